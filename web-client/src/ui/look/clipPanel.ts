// Planes that cut all surfaces open, and the body if wanted.
import { css, html, type TemplateResult } from 'lit';
import { coordinateText } from '../../session/picture/writtenNumbers.ts';
import type { ClipPlane, ClipPlanes } from '../../state/pageView.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow } from '../base/rows.ts';
import { lookStyles } from './lookStyles.ts';
import { ModelElement } from '../base/signalElement.ts';

const axes = ['x', 'y', 'z'] as const;

export interface ClipModel {
    state: Pick<AppState, 'dataset'>;
    view: Pick<ViewState, 'clip'>;
}

export class ClipPanel extends ModelElement<ClipModel> {
    static override styles = [
        lookStyles,
        css`
            .plane {
                display: grid;
                grid-template-columns: 72px 1fr minmax(44px, auto) auto;
                gap: 8px;
                align-items: center;
            }
            .value {
                text-align: right;
                font-size: 12px;
            }
            .plane button {
                padding: 1px 8px;
            }
        `,
    ];

    override render(): TemplateResult {
        const { view } = this.model;
        const { planes, body } = view.clip.value;
        return html`
            ${axes.map((axis, i) => this.plane(axis, i, planes[i]!))}
            ${checkRow('Cut the body too', body, (on) => this.change({ body: on }), { id: 'clip-body' })}
            <p class="quiet">Planes cut all surfaces in the picture.</p>
        `;
    }

    private plane(axis: string, index: number, plane: ClipPlane): TemplateResult {
        const bounds = this.model.state.dataset.value?.bounds ?? [0, 1, 0, 1, 0, 1];
        const [low, high] = [bounds[2 * index] ?? 0, bounds[2 * index + 1] ?? 1];
        const place = coordinateText(this.model.state, index, low + plane.at * (high - low));
        return html`<div class="plane" role="group" aria-label=${`Plane across ${axis}`}>
            ${checkRow(`Cut ${axis}`, plane.on, (on) => this.changePlane(index, { on }), { id: `clip-${axis}` })}
            <input
                id=${`clip-${axis}-at`}
                type="range"
                min="0"
                max="1"
                step="0.005"
                aria-label=${`Where it cuts ${axis}`}
                aria-valuetext=${place}
                .value=${String(plane.at)}
                ?disabled=${!plane.on}
                @input=${(event: Event) => this.changePlane(index, { at: (event.target as HTMLInputElement).valueAsNumber })}
            />
            <span class="value">${place}</span>
            <button
                id=${`clip-${axis}-flip`}
                type="button"
                aria-pressed=${plane.flipped ? 'true' : 'false'}
                aria-label=${`Cut the other side of ${axis}`}
                title="Cut the other side"
                ?disabled=${!plane.on}
                @click=${() => this.changePlane(index, { flipped: !plane.flipped })}
            >
                ⇄
            </button>
        </div>`;
    }

    private changePlane(index: number, change: Partial<ClipPlane>): void {
        const { planes } = this.model.view.clip.value;
        const [x, y, z] = planes.map((plane, i) => (i === index ? { ...plane, ...change } : plane));
        this.change({ planes: [x!, y!, z!] });
    }

    private change(change: Partial<ClipPlanes>): void {
        const { clip } = this.model.view;
        clip.value = { ...clip.value, ...change };
    }
}

customElements.define('wakesurf-clip', ClipPanel);
