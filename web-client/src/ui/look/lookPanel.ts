// Shows how the selected surface looks: the colours first, everything else in groups that open.
import { css, html, type TemplateResult } from 'lit';
import type { AppState } from '../../state/appState.ts';
import type { BackSide, SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, type Choice, selectRow, sliderRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import './bodyPanel.ts';
import type { BodyModel } from './bodyPanel.ts';
import './colourPanel.ts';
import type { ColourModel } from './colourPanel.ts';
import './cutPanels.ts';
import type { ClipModel, WindowsModel } from './cutPanels.ts';
import './linesPanel.ts';
import type { LinesModel } from './linesPanel.ts';
import { LookGroup } from './lookStyles.ts';
import './paintPanel.ts';
import type { PaintModel } from './paintPanel.ts';

/** What its groups take: all of them are about the same surface. */
export type LookModel = ColourModel & OpacityModel & LinesModel & WindowsModel & ClipModel & BodyModel & PaintModel;

export class LookPanel extends ModelElement<LookModel> {
    static override styles = css`
        :host {
            display: block;
            padding-top: 10px;
        }
        details {
            border-top: 1px solid var(--line);
        }
        wakesurf-colour {
            display: block;
            margin-bottom: 10px;
        }
        summary {
            padding: 7px 0;
            font-weight: 600;
            cursor: pointer;
        }
        details[open] > :last-child {
            display: block;
            padding-bottom: 10px;
        }
    `;

    override render(): TemplateResult {
        const { model } = this;
        return html`
            <wakesurf-colour .model=${model}></wakesurf-colour>
            <details id="opacity-group">
                <summary>Opacity and outlines</summary>
                <wakesurf-opacity .model=${model}></wakesurf-opacity>
            </details>
            <details id="lines-group">
                <summary>Stripes and texture</summary>
                <wakesurf-lines .model=${model}></wakesurf-lines>
            </details>
            <details id="pieces-group">
                <summary>Lines, ribbons and arrows</summary>
                <wakesurf-pieces .model=${model}></wakesurf-pieces>
            </details>
            <details id="windows-group">
                <summary>Part shown</summary>
                <wakesurf-windows .model=${model}></wakesurf-windows>
            </details>
            <details id="clip-group">
                <summary>Cutting planes</summary>
                <wakesurf-clip .model=${model}></wakesurf-clip>
            </details>
            <details id="body-group">
                <summary>Body</summary>
                <wakesurf-body .model=${model}></wakesurf-body>
            </details>
            <details id="paint-group" @toggle=${this.listParts}>
                <summary>Painting and connected parts</summary>
                <wakesurf-paint .model=${model}></wakesurf-paint>
            </details>
        `;
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        const { view } = this.model;
        view.partsListed.value = false;
        // Nothing on the page would say that the brush is still in hand.
        if (view.tool.value === 'paint') view.tool.value = 'none';
    }

    /** Parts are looked for only while a user sees the list. */
    private listParts(event: Event): void {
        this.model.view.partsListed.value = (event.target as HTMLDetailsElement).open;
    }
}

customElements.define('wakesurf-look', LookPanel);

const sides: readonly Choice<BackSide>[] = [
    { value: 'shaded', words: 'A little darker' },
    { value: 'tinted', words: 'Tinted orange' },
    { value: 'same', words: 'The same' },
];

export interface OpacityModel {
    state: Pick<AppState, 'activeSurface'>;
    view: Pick<ViewState, 'changeLook' | 'exactWhenStill' | 'lookOf'>;
}

/** How much of what is behind the selected surface is seen through it, its outlines and its other side. */
export class OpacityPanel extends LookGroup<OpacityModel> {
    override render(): TemplateResult {
        const { look } = this;
        const { view } = this.model;
        const percent = (part: number): string => `${Math.round(100 * part)} %`;
        const slider = { low: 0, high: 1, step: 0.05 };
        return html`
            ${sliderRow({
                ...{ ...slider, low: 0.05, id: 'opacity', words: 'Opacity', value: look.opacity },
                shown: percent(look.opacity),
                change: (opacity) => this.change({ opacity }),
            })}
            ${checkRow(
                'More opaque when seen edge-on',
                look.angleOpacity,
                (angleOpacity) => this.change({ angleOpacity, ...dimmed(look, angleOpacity) }),
                { id: 'angle-opacity' },
            )}
            ${sliderRow({
                ...{ ...slider, id: 'smoke', words: 'Smoke', value: look.smoke },
                shown: look.smoke === 0 ? 'off' : percent(look.smoke),
                change: (smoke) => this.change({ smoke, ...dimmed(look, smoke > 0, 0.9) }),
            })}
            <p class="quiet">Smoke thins where the surface has been stretched, and with age.</p>
            ${checkRow('Points instead of cells', look.points, (points) => this.change({ points }), { id: 'points' })}
            ${checkRow('Outlines', look.silhouettes, (silhouettes) => this.change({ silhouettes }), { id: 'silhouettes' })}
            ${selectRow('back-side', 'Other side', sides, look.backSide, (backSide) => this.change({ backSide }))}
            ${checkRow(
                'Exact order when still',
                view.exactWhenStill.value,
                (on) => {
                    view.exactWhenStill.value = on;
                },
                { id: 'exact-order' },
            )}
            <p class="quiet">Applies to all transparent surfaces. While the view moves, transparency is approximate; pictures and films are always exact.</p>
        `;
    }
}

/** Makes a surface let something through, so that more or less of that can be chosen. */
function dimmed({ opacity }: SurfaceLook, on: boolean, to = 0.6): Partial<SurfaceLook> {
    return on && opacity > 0.95 ? { opacity: to } : {};
}

customElements.define('wakesurf-opacity', OpacityPanel);
