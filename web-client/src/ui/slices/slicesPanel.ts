// Planes through the data: how one is added, and where the chosen one lies and what it shows.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { Vec3 } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf } from '../../scene/base/numbers.ts';
import { levelFields } from '../../session/edits/defaults.ts';
import { type SlicePlace, Slices } from '../../session/picture/slicesInPicture.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { selectRow, sliderRow, vectorFields } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { fieldWords } from '../../session/picture/surfaceOwner.ts';

/** Loaded with the panel, after the first picture. */
export { Slices };

export interface SlicesModel {
    state: Pick<AppState, 'dataset' | 'locked' | 'rakePoints' | 'slices'>;
    view: Pick<ViewState, 'chosenThing'>;
    slices: Slices;
}

type Bounds = readonly [number, number, number, number, number, number];

const axes: readonly (readonly [string, Vec3])[] = [
    ['x', [1, 0, 0]],
    ['y', [0, 1, 0]],
    ['z', [0, 0, 1]],
];
const steps = 1000;
/** A plane that only grazes a corner of the domain shows nothing. */
const inset = 5e-4;

export class SlicesPanel extends ModelElement<SlicesModel> {
    static override styles = css`
        .add {
            display: grid;
            grid-template-columns: auto repeat(3, 1fr) auto;
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
    `;

    override render(): TemplateResult {
        const { state, view, slices } = this.model;
        const { dataset } = state;
        if (dataset.value === null) return html``;
        const locked = state.locked.value;
        const id = view.chosenThing.value ?? '';
        const place = slices.places.value.get(id) ?? null;
        const bounds = dataset.value.bounds as unknown as Bounds;
        return html`
            ${locked ? nothing : this.adding(bounds)}
            ${place === null ? nothing : this.settings(id, place, bounds, locked)}
        `;
    }

    private adding(bounds: Bounds): TemplateResult {
        const rake = this.model.state.rakePoints.value;
        return html`<div class="add" role="group" aria-label="Add a slice">
            <span>Add across</span>
            ${axes.map(
                ([axis, normal]) =>
                    html`<button type="button" id=${`slice-${axis}`} @click=${() => this.add(middleOf(bounds), normal)}>${axis}</button>`,
            )}
            <button
                type="button"
                id="slice-rake"
                title="A plane at the middle of the active rake, at a right angle to it"
                ?disabled=${rake.length < 2}
                @click=${() => this.addAcross(rake)}
            >
                rake
            </button>
        </div>`;
    }

    private settings(id: string, place: SlicePlace, bounds: Bounds, locked: boolean): TemplateResult {
        const { state, slices } = this.model;
        const dataset = state.dataset.value!;
        const { origin, normal, field } = place;
        const names = levelFields(dataset);
        const choices = (names.includes(field) ? names : [field, ...names]).map((name) => ({
            value: name,
            words: fieldWords(name, dataset),
        }));
        const unit = unitOf(normal);
        const [low, high] = spanOf(bounds, unit);
        const at = dot(origin, unit);
        const resolution = resolutionOf(low, high);
        const fault = slices.faults.value.get(id);
        return html`
            ${fault === undefined ? nothing : html`<p role="status" id="slice-fault">${fault}</p>`}
            ${
                locked
                    ? nothing
                    : html`
                      ${selectRow('slice-field', 'Field', choices, field, (name) => slices.change(id, { field: name }))}
                      ${sliderRow({
                          ...{ id: 'slice-offset', words: 'Position', value: at, shown: fieldNumber(at, resolution) },
                          ...{ low, high, step: (high - low) / steps },
                          change: (value) => slices.change(id, { origin: moved(origin, unit, value - at) }),
                      })}
                      <div class="triple" role="group" aria-label="Origin">
                          <span>Origin</span>
                          ${vectorFields(
                              'Origin',
                              origin,
                              (_, value) => fieldNumber(value, resolution),
                              (point) => slices.change(id, { origin: point }),
                          )}
                      </div>
                      <div class="triple" role="group" aria-label="Normal">
                          <span>Normal</span>
                          ${vectorFields(
                              'Normal',
                              normal,
                              (_, value) => fieldNumber(value, 1e-3),
                              (vector) => {
                                  if (vector.every((each) => each === 0)) return false;
                                  slices.change(id, { normal: vector });
                                  return true;
                              },
                          )}
                      </div>
                  `
            }
            ${sliderRow({
                ...{ id: 'slice-contours', words: 'Contour lines', value: slices.contours.value, low: 0, high: 40, step: 1 },
                shown: slices.contours.value === 0 ? 'none' : String(slices.contours.value),
                change: (value) => (slices.contours.value = value),
            })}
        `;
    }

    private async add(origin: Vec3, normal: Vec3): Promise<void> {
        const { view, slices } = this.model;
        const shown = slices.places.value.get(view.chosenThing.value ?? '') ?? [...slices.places.value.values()][0];
        const made = await slices.add(origin, normal, shown?.field);
        if (made !== null) view.chosenThing.value = made;
    }

    private addAcross(rake: readonly Vec3[]): Promise<void> {
        const [a, b] = [rake[0]!, rake.at(-1)!];
        const middle = a.map((each, k) => (each + b[k]!) / 2) as unknown as Vec3;
        const along = a.map((each, k) => b[k]! - each) as unknown as Vec3;
        return this.add(middle, dot(along, along) > 0 ? along : [1, 0, 0]);
    }
}

function dot(a: Vec3, b: Vec3): number {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function unitOf(normal: Vec3): Vec3 {
    const length = Math.hypot(...normal) || 1;
    return normal.map((each) => each / length) as unknown as Vec3;
}

function moved(origin: Vec3, unit: Vec3, by: number): Vec3 {
    return origin.map((each, k) => each + by * unit[k]!) as unknown as Vec3;
}

function middleOf(bounds: Bounds): Vec3 {
    return [0, 1, 2].map((k) => (bounds[2 * k]! + bounds[2 * k + 1]!) / 2) as unknown as Vec3;
}

/** The places along a direction between which planes across it meet the domain. */
function spanOf(bounds: Bounds, unit: Vec3): [number, number] {
    const ends = [0, 1, 2].map((k) => [bounds[2 * k]! * unit[k]!, bounds[2 * k + 1]! * unit[k]!]);
    const [low, high] = [Math.min, Math.max].map((end) =>
        ends.reduce((sum, pair) => sum + end(...(pair as [number, number])), 0),
    ) as [number, number];
    return [low + inset * (high - low), high - inset * (high - low)];
}

customElements.define('wakesurf-slices', SlicesPanel);
