// Streamlines of their own: how a set is added, and the settings of the chosen one.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import { Lines } from '../../session/picture/linesInPicture.ts';
import type { AppState } from '../../state/appState.ts';
import { thickest, thinnest } from '../../state/lineLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { sliderRow } from '../base/rows.ts';
import { lateRow } from '../base/lateRow.ts';
import { ModelElement } from '../base/signalElement.ts';
import { aboutPoint, acrossAxis, alongRake, alongWalls, inletAmong, inPlane, offWalls, type SeedsPlace } from './linesPlaces.ts';
import { linesSettings } from './linesSettings.ts';

/** Loaded with the panel, after the first picture. */
export { Lines };

export interface LinesModel {
    state: Pick<AppState, 'dataset' | 'locked' | 'rakePoints' | 'lines' | 'slices'>;
    view: Pick<ViewState, 'chosenThing' | 'lines'>;
    lines: Lines;
    /** Returns the place that the camera looks at. */
    middle: () => Vec3;
}

export class LinesPanel extends ModelElement<LinesModel> {
    static override styles = css`
        .add {
            display: flex;
            flex-wrap: wrap;
            gap: 6px;
            align-items: center;
        }
        .triple {
            display: grid;
            grid-template-columns: 4em repeat(3, minmax(0, 1fr));
            gap: 6px;
            align-items: center;
            margin-top: 4px;
        }
        .patches {
            max-height: 30vh;
            overflow-y: auto;
        }
    `;

    override render(): TemplateResult {
        const { state, view, lines } = this.model;
        const dataset = state.dataset.value;
        if (dataset === null) return html``;
        const locked = state.locked.value;
        const { width } = view.lines.value;
        const id = view.chosenThing.value ?? '';
        const place = lines.places.value.get(id) ?? null;
        const said = lines.faults.value.get(id) ?? lines.told.value.get(id);
        return html`
            ${locked ? nothing : this.adding(dataset)}
            ${said === undefined ? nothing : html`<p role="status" class="quiet" id="streamlines-told">${said}</p>`}
            ${lateRow(lines.late.value.has(id), () => lines.retry(id))}
            ${
                place === null || locked
                    ? nothing
                    : linesSettings({
                          ...{ place, dataset, meaning: lines.meanings.value.get(id) },
                          change: (change) => lines.change(id, change),
                      })
            }
            ${
                place === null
                    ? nothing
                    : sliderRow({
                          ...{ id: 'streamlines-width', words: 'Width', value: width, low: thinnest, high: thickest, step: 0.5 },
                          shown: `${width} px`,
                          change: (value) => (view.lines.value = { width: value }),
                      })
            }
        `;
    }

    private adding({ bounds, obstacle, patches }: DatasetDescription): TemplateResult {
        const { state, middle } = this.model;
        const inlet = inletAmong(patches);
        const rake = state.rakePoints.value;
        const slice = [...state.slices.value.values()].at(-1);
        const button = (id: string, words: string, title: string, of: () => SeedsPlace, disabled = false): TemplateResult =>
            html`<button type="button" id=${`streamlines-${id}`} title=${title} ?disabled=${disabled} @click=${() => this.add(of())}>
                ${words}
            </button>`;
        return html`<div class="add" role="group" aria-label="Add streamlines">
            <span>Add from</span>
            ${button('rake', 'rake', 'Seeds from one end of the active rake to the other', () => alongRake(rake), rake.length < 2)}
            ${(['x', 'y', 'z'] as const).map((axis, k) =>
                button(`plane-${axis}`, `plane ${axis}`, `Seeds all over a plane across ${axis}`, () =>
                    acrossAxis(bounds, k as 0 | 1 | 2, middle()),
                ),
            )}
            ${slice === undefined ? nothing : button('slice', 'slice', 'Seeds all over the newest slice', () => inPlane(bounds, slice.origin, slice.normal))}
            ${button('sphere', 'sphere', 'Seeds on a sphere about the middle of the picture', () => aboutPoint(bounds, middle()))}
            ${obstacle ? button('walls', 'walls', 'Seeds all over the bodies, a little off them', () => offWalls(bounds)) : nothing}
            ${obstacle ? button('along', 'along walls', 'Lines on the bodies, as oil shows the flow there', () => alongWalls()) : nothing}
            ${inlet === undefined ? nothing : button('patch', 'patch', 'Seeds all over a patch of the boundary, such as an inlet', () => offWalls(bounds, [inlet]))}
        </div>`;
    }

    private async add(seeds: SeedsPlace): Promise<void> {
        const { state, view, lines } = this.model;
        const field = lines.like(view.chosenThing.value)?.field ?? state.dataset.value!.velocity;
        const made = await lines.add({ ...seeds, direction: 'both', duration: 0, length: 0, field, range: null });
        if (made !== null) view.chosenThing.value = made;
    }
}

customElements.define('wakesurf-streamlines', LinesPanel);
