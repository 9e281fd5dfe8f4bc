// The painter: nothing of the selected surface is shown but what a brush reveals; and its connected parts,
// which can be hidden.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { SurfacePart } from '../../mesh/meshChange.ts';
import { maxHiddenParts, type SurfaceLook } from '../../state/surfaceLook.ts';
import type { Brush, ViewState } from '../../state/viewState.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { checkRow, sliderRow } from '../base/rows.ts';
import { LookGroup, lookStyles } from './lookStyles.ts';
import { countWords } from '../base/words.ts';

const listedAtMost = 12;

export interface PaintModel {
    state: Pick<AppState, 'activeSurface' | 'parts'>;
    view: ViewState;
    scene: Pick<FlowScene, 'surfaces' | 'loop'>;
}

export class PaintPanel extends LookGroup<PaintModel> {
    static override styles = [
        lookStyles,
        css`
            h2 {
                margin: 12px 0 4px;
                padding-top: 10px;
                border-top: 1px solid var(--line);
                font-size: 13px;
                font-weight: 600;
            }
        `,
    ];

    override render(): TemplateResult {
        const { look } = this;
        const { state } = this.model;
        const id = state.activeSurface.value;
        return html`
            ${checkRow('Show only what the brush has revealed', look.painting, (on) => this.startPainting(on), { id: 'painting' })}
            ${look.painting ? this.brush(look) : nothing}
            <h2>Connected parts</h2>
            ${this.parts(look, state.parts.value.get(id ?? '') ?? [])}
        `;
    }

    private brush(look: SurfaceLook): TemplateResult {
        const { view } = this.model;
        const { radiusPx } = view.brush.value;
        return html`
            <div class="buttons" role="group" aria-label="Brush">
                ${this.tool('reveal', 'Reveal')} ${this.tool('erase', 'Erase')}
            </div>
            ${sliderRow({
                ...{ id: 'brush-size', words: 'Brush size', value: radiusPx, low: 4, high: 64, step: 2 },
                shown: `${2 * radiusPx} px`,
                change: (radius) => (view.brush.value = { ...view.brush.value, radiusPx: radius }),
            })}
            ${sliderRow({
                ...{ id: 'faded', words: 'Opacity of the rest', value: look.faded, low: 0, high: 0.5, step: 0.05 },
                shown: look.faded === 0 ? 'hidden' : `${Math.round(100 * look.faded)} %`,
                change: (faded) => this.change({ faded }),
            })}
            <div class="buttons">
                <button id="reveal-all" type="button" @click=${() => this.fill(true)}>Reveal all</button>
                <button id="hide-all" type="button" @click=${() => this.fill(false)}>Hide all</button>
            </div>
            ${
                view.paintLeftOut.value.has(this.model.state.activeSurface.value ?? '')
                    ? html`<p role="status">
                      The painting is too detailed for a link or a saved view: both will show the whole surface. Use fewer, larger strokes.
                  </p>`
                    : nothing
            }
            <p class="quiet">Drag in the picture. Without a pointer, press “Reveal all” and set a range under “Part shown”.</p>
        `;
    }

    private tool(does: Brush['does'], words: string): TemplateResult {
        const { view } = this.model;
        const on = view.tool.value === 'paint' && view.brush.value.does === does;
        return html`<button
            id=${`brush-${does}`}
            type="button"
            aria-pressed=${on ? 'true' : 'false'}
            @click=${() => {
                view.brush.value = { ...view.brush.value, does };
                view.tool.value = on ? 'none' : 'paint';
            }}
        >
            ${words}
        </button>`;
    }

    private parts(look: SurfaceLook, parts: readonly SurfacePart[]): TemplateResult {
        const more = parts.length - listedAtMost;
        return html`
            ${parts
                .slice(0, listedAtMost)
                .map((part, i) =>
                    checkRow(
                        `Part ${i + 1}: ${countWords(part.cells)} quads`,
                        !part.hidden,
                        (on) => this.showPart(look, parts, part, on),
                        { id: `part-${i + 1}` },
                    ),
                )}
            ${more > 0 ? html`<p class="quiet">and ${more} more; to hide one, click it in the picture</p>` : nothing}
            ${
                look.hiddenParts.length > maxHiddenParts
                    ? html`<p role="status">A link or a saved view hides only the first ${maxHiddenParts} of these parts.</p>`
                    : nothing
            }
            <div class="buttons">
                ${this.tool('hidePart', 'Hide by clicking')}
                <button id="show-parts" type="button" ?disabled=${look.hiddenParts.length === 0} @click=${() => this.change({ hiddenParts: [] })}>
                    Show all parts
                </button>
            </div>
        `;
    }

    private showPart(look: SurfaceLook, parts: readonly SurfacePart[], part: SurfacePart, show: boolean): void {
        const hidden = parts.filter((each) => (each === part ? !show : each.hidden)).map(({ seed }) => seed);
        if (show || look.hiddenParts.length < parts.length) this.change({ hiddenParts: hidden });
    }

    private startPainting(painting: boolean): void {
        const { view } = this.model;
        this.change({ painting });
        view.brush.value = { ...view.brush.value, does: 'reveal' };
        view.tool.value = painting ? 'paint' : 'none';
    }

    private fill(reveal: boolean): void {
        const { state, scene } = this.model;
        const id = state.activeSurface.value;
        if (id === null) return;
        scene.surfaces.revealAll(id, reveal);
        scene.loop.request();
    }
}

customElements.define('wakesurf-paint', PaintPanel);
