// Planes through the data: how one is added, and where the chosen one lies and what it shows.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import { levelFields } from '../../session/edits/defaults.ts';
import { dot, plus, times, unit as unitOf } from '../../scene/rake/rakeShape.ts';
import { spanWithin } from '../../scene/slices/sliceHandles.ts';
import { type SlicePlace, Slices } from '../../session/picture/slicesInPicture.ts';
import { timeField, withUnit } from '../../session/picture/writtenNumbers.ts';
import type { AppState, Units } from '../../state/appState.ts';
import { mostContours } from '../../state/sliceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, selectRow, sliderRow, vectorFields } from '../base/rows.ts';
import { otherTimeRow } from '../base/otherTimeRow.ts';
import { lateRow } from '../base/lateRow.ts';
import { ModelElement } from '../base/signalElement.ts';
import { fieldWords, isVelocityAcross, velocityAcross } from '../../session/picture/surfaceOwner.ts';

/** Loaded with the panel, after the first picture. */
export { Slices };

export interface SlicesModel {
    state: Pick<AppState, 'dataset' | 'datasets' | 'locked' | 'rakePoints' | 'slices' | 'surfaces'>;
    view: Pick<ViewState, 'chosenThing' | 'clip' | 'slices' | 'tool' | 'units'>;
    slices: Slices;
    /** Returns the time of the picture. */
    time: () => number;
}

type Bounds = readonly [number, number, number, number, number, number];

const axes: readonly (readonly [string, Vec3])[] = [
    ['x', [1, 0, 0]],
    ['y', [0, 1, 0]],
    ['z', [0, 0, 1]],
];
const steps = 1000;

export class SlicesPanel extends ModelElement<SlicesModel> {
    static override styles = css`
        .add {
            display: grid;
            grid-template-columns: auto repeat(3, 1fr) auto auto;
            gap: 6px;
            align-items: center;
        }
        .cut {
            display: flex;
            justify-content: space-between;
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
        const { tool } = this.model.view;
        return html`<div class="add" role="group" aria-label="Add a slice">
            <span>Add</span>
            ${axes.map(
                ([axis, normal]) =>
                    html`<button type="button" id=${`slice-${axis}`} title=${`A plane across ${axis}`} @click=${() => this.model.slices.add(middleOf(bounds), normal)}>${axis}</button>`,
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
            <button
                type="button"
                id="slice-points"
                title="A plane through three points: click each in the picture"
                aria-pressed=${tool.value === 'slice'}
                @click=${() => (tool.value = tool.value === 'slice' ? 'none' : 'slice')}
            >
                3 points
            </button>
        </div>`;
    }

    private settings(id: string, place: SlicePlace, bounds: Bounds, locked: boolean): TemplateResult {
        const { state, view, slices } = this.model;
        const dataset = state.dataset.value!;
        const { origin, normal, field } = place;
        const look = view.slices.value;
        const longest = slices.arrows.longest.value.get(id);
        const names = [...new Set([...levelFields(dataset), velocityAcross])];
        const choices = (names.includes(field) ? names : [field, ...names]).map((name) => ({
            value: name,
            words: fieldWords(name, dataset),
        }));
        const along = unitOf(normal);
        const [low, high] = spanWithin(bounds, along);
        const at = dot(origin, along);
        const resolution = resolutionOf(low, high);
        const fault = slices.faults.value.get(id);
        const numbers = slices.numbersOf(id);
        return html`
            ${fault === undefined ? nothing : html`<p role="status" id="slice-fault">${fault}</p>`}
            ${lateRow(slices.late.value.has(id), () => slices.retry(id))}
            ${
                locked
                    ? nothing
                    : html`
                      ${selectRow('slice-field', 'Field', choices, field, (name) => slices.change(id, { field: name }))}
                      ${sliderRow({
                          ...{ id: 'slice-offset', words: 'Position', value: at, shown: fieldNumber(at, resolution) },
                          ...{ low, high, step: (high - low) / steps },
                          change: (value) => slices.change(id, { origin: plus(origin, times(along, value - at)) }),
                      })}
                      ${this.subtracting(id, place)}
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
                ...{ id: 'slice-contours', words: 'Contour lines', value: look.contours, low: 0, high: mostContours, step: 1 },
                shown: look.contours === 0 ? 'none' : String(look.contours),
                change: (contours) => (view.slices.value = { ...look, contours }),
            })}
            ${checkRow('Arrows of the flow in the plane', look.arrows, (arrows) => (view.slices.value = { ...look, arrows }), { id: 'slice-arrows' })}
            ${this.cutting(id)}
            ${numbers === null ? nothing : html`<p class="quiet" id="slice-numbers">${numberWords(numbers, place, dataset, view.units.value)}</p>`}
            ${look.arrows && longest !== undefined ? html`<p class="quiet">${arrowWords(longest, dataset)}</p>` : nothing}
        `;
    }

    /** What is before the slice hides it. */
    private cutting(id: string): TemplateResult {
        const { clip } = this.model.view;
        const flipped = clip.value.slice?.id === id ? clip.value.slice.flipped : null;
        return html`<div class="cut" role="group" aria-label="Cut at this slice">
            ${checkRow('Cut surfaces here', flipped !== null, (on) => (clip.value = { ...clip.value, slice: on ? { id, flipped: false } : null }), { id: 'slice-cut' })}
            <button
                id="slice-cut-flip"
                type="button"
                aria-pressed=${flipped === true ? 'true' : 'false'}
                aria-label="Cut the other side of the slice"
                title="Cut the other side"
                ?disabled=${flipped === null}
                @click=${() => (clip.value = { ...clip.value, slice: { id, flipped: flipped !== true } })}
            >
                ⇄
            </button>
        </div>`;
    }

    /** What is subtracted: of its own data at first what was a time-step before. */
    private subtracting(id: string, { minus }: SlicePlace): TemplateResult {
        const { state, slices, time } = this.model;
        const { dataset, name, times } = state.dataset.value!;
        const step = (times[1] ?? 1) - (times[0] ?? 0);
        const others = state.datasets.value.filter((each) => each.dataset !== dataset);
        const choices = [
            { value: '', words: 'nothing' },
            { value: dataset, words: `${name} at another time`, disabled: times.length < 2 },
            ...others.map((each) => ({ value: each.dataset, words: each.name })),
        ];
        const change = (next: SlicePlace['minus']): void => slices.change(id, { minus: next });
        const choose = (chosen: string): void => {
            if (chosen === '') change(null);
            else if (chosen === dataset) change({ dataset: null, time: { kind: 'offset', by: -step } });
            else change({ dataset: chosen, time: minus === null || minus.dataset === null ? { kind: 'same' } : minus.time });
        };
        const of = minus === null ? '' : (minus.dataset ?? dataset);
        return html`${selectRow('slice-minus', 'Minus', choices, of, choose)}
        ${
            minus === null
                ? nothing
                : otherTimeRow({
                      ...{ id: 'slice-minus-time', words: 'Its time', chosen: minus.time },
                      // Its own at the same time would be nothing.
                      ...{ maySame: minus.dataset !== null, first: { by: -step, time: time() } },
                      written: (number) => timeField(state, number),
                      change: (chosen) => change({ ...minus, time: chosen }),
                  })
        }`;
    }

    private addAcross(rake: readonly Vec3[]): Promise<void> {
        const [a, b] = [rake[0]!, rake.at(-1)!];
        const middle = a.map((each, k) => (each + b[k]!) / 2) as unknown as Vec3;
        const along = a.map((each, k) => b[k]! - each) as unknown as Vec3;
        return this.model.slices.add(middle, dot(along, along) > 0 ? along : [1, 0, 0]);
    }
}

function middleOf(bounds: Bounds): Vec3 {
    return [0, 1, 2].map((k) => (bounds[2 * k]! + bounds[2 * k + 1]!) / 2) as unknown as Vec3;
}

/** Where the field is the velocity across the plane, also what flows through it. */
function numberWords(
    { area, mean }: { area: number; mean: number },
    { normal, field, minus }: SlicePlace,
    dataset: DatasetDescription,
    { length, time }: Units,
): string {
    const short = (value: number): string => shortNumber(Number(value.toPrecision(3)));
    const axis = axes.findIndex(([name]) => field === `velocity_${name}`);
    const isNormal = isVelocityAcross(field, dataset);
    const unit = dataset.fields.find(({ name }) => name === (axis >= 0 || isNormal ? dataset.velocity : field))?.unit ?? '';
    const said = `Mean ${withUnit(short(mean), unit)} over ${withUnit(short(area), length === '' ? '' : `${length}²`)}.`;
    const isAcross = isNormal || (axis >= 0 && Math.abs(dot(unitOf(normal), axes[axis]![1])) > 1 - 1e-12);
    if (!isAcross || minus !== null) return said;
    const rate = unit !== '' && unit === `${length}/${time}` ? `${length}³/${time}` : '';
    return `${said} ${withUnit(short(mean * area), rate)} flow through it in the direction of ${axis < 0 ? 'its normal' : axes[axis]![0]}.`;
}

function arrowWords(longest: number, { fields, velocity }: DatasetDescription): string {
    if (longest === 0) return 'Nothing flows along this plane.';
    const unit = fields.find(({ name }) => name === velocity)?.unit ?? '';
    return `The longest arrow is ${withUnit(shortNumber(Number(longest.toPrecision(2))), unit)}; the fastest hundredth is drawn no longer.`;
}

customElements.define('wakesurf-slices', SlicesPanel);
