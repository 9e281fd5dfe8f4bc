// The settings of the surface: its kind, how long it is followed, how fine it is.
import { css, html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type {
    Accuracy,
    DatasetDescription,
    Direction,
    Between,
    Interpolation,
    SurfaceKind,
    SurfaceRecord,
} from '../../protocol/messages.ts';
import { surfaceKinds } from '../../protocol/generated/surface.ts';
import { fieldNumber, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import { diagonal } from '../../scene/camera/cameraControls.ts';
import { surfacesOf } from '../../session/edits/selection.ts';
import type { SurfaceIntent } from '../../session/edits/surfaceIntent.ts';
import { cutBackAt, directionsOf, followed, longestLength } from '../../session/edits/surfaceTimes.ts';
import { withUnit } from '../../session/picture/writtenNumbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { Families } from '../../session/surface/families.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { isolated } from '../../state/announcements.ts';
import { toggled } from '../../state/pageView.ts';
import { LevelRows } from './levelPanel.ts';
import './timesPanel.ts';
import { type Choice, selectRow, sliderRow, vectorFields } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { unitOfDuration } from '../look/colourNames.ts';

// Nobody needs these before the first picture.
void import('./openedRows.ts');

/** Separation as a multiple of the finest spacing of the dataset's grid. */
const separations = [
    { factor: 0.5, words: 'fine' },
    { factor: 1, words: 'grid spacing' },
    { factor: 2, words: 'medium' },
    { factor: 4, words: 'coarse' },
];

const directions: readonly Choice<Direction>[] = [
    { value: 'forward', words: 'Forward, downstream' },
    { value: 'backward', words: 'Backward, upstream' },
    { value: 'both', words: 'Both directions' },
];

const accuracies: readonly Choice<Accuracy>[] = [
    { value: 'fast', words: 'Fast, for exploring' },
    { value: 'balanced', words: 'Balanced' },
    { value: 'exact', words: 'Exact, for figures' },
];

const interpolations: readonly Choice<Interpolation>[] = [
    { value: 'linear', words: 'Linear, as in ParaView' },
    { value: 'smooth', words: 'Smooth, cubic' },
];

const betweens: readonly Choice<Between>[] = [
    { value: 'linear', words: 'Linear, as in ParaView' },
    { value: 'cubic', words: 'Cubic' },
    { value: 'flow', words: 'Along the flow' },
];

const kindNames = { stream: 'Stream', path: 'Path', streak: 'Streak', time: 'Time', level: 'Isosurface' } as const;
const kindsOfRakes = surfaceKinds.filter((kind) => kind !== 'level');

/** Of the time that the fluid takes: what moves is shown first where the data last longer, see scene_suggestion.cpp. */
const leastLasting = 0.3;

/** The ends of the slider are exact: it is parted evenly. */
const lengthSteps = 100;

export interface SurfaceModel {
    state: AppState;
    view: Pick<ViewState, 'units' | 'visibility' | 'changeVisibility' | 'changeLook' | 'lookOf'>;
    edits: Pick<Edits, 'actions' | 'changeSurface' | 'chooseSurface' | 'intent' | 'remark'>;
    families: Families;
    chooseKind: (kind: SurfaceKind) => void;
}

export class SurfacePanel extends ModelElement<SurfaceModel> {
    private level: LevelRows | null = null;

    static override styles = css`
        /* Only there to be disabled as a whole. */
        .edits {
            display: contents;
        }
        .kinds {
            display: grid;
            grid-template-columns: repeat(4, auto);
            margin: 0 0 10px;
            padding: 2px;
            border: 1px solid var(--line);
            border-radius: 8px;
            background: var(--raised);
        }
        legend {
            position: absolute;
            width: 1px;
            height: 1px;
            overflow: hidden;
            clip-path: inset(50%);
        }
        .kind {
            display: flex;
            align-items: center;
            gap: 5px;
            min-height: 28px;
            padding-left: 4px;
            border-radius: 6px;
            cursor: pointer;
        }
        .kind input {
            margin: 0;
            accent-color: var(--accent);
        }
        .row {
            margin-top: 6px;
        }
        .quiet {
            margin: 4px 0 0;
            font-size: 12px;
        }
        select {
            max-width: 190px;
        }
        .several {
            display: grid;
            grid-template-columns: minmax(0, 1fr) auto auto auto;
            gap: 6px;
            margin-top: 10px;
        }
        .several select {
            max-width: none;
        }
        .sweep {
            display: grid;
            grid-template-columns: 42px repeat(3, 1fr);
            gap: 6px;
            align-items: center;
            margin-top: 8px;
        }
    `;

    override render(): TemplateResult {
        const { state, edits } = this.model;
        const intent = edits.intent.value;
        const dataset = state.surfaceDataset.value;
        if (dataset === null) return html``;
        if (intent?.kind === 'level') return this.isosurface();
        if (state.rake.value === undefined) return html``;
        if (intent === null) {
            return html`<p class="quiet">This rake has no surface.</p>
                ${this.several()}`;
        }
        return html`
            <fieldset class="edits" ?disabled=${state.locked.value}>
                <fieldset class="kinds">
                    <legend>Kind of surface</legend>
                    ${kindsOfRakes.map((kind) => this.kindChoice(kind, dataset))}
                </fieldset>
                ${this.kindNote(intent, dataset)}
                ${this.followedRows(intent, dataset)}
                <p class="quiet" id="surface-remark" role="status" ?hidden=${edits.remark.value === null}>${edits.remark.value}</p>
                <wakesurf-mesh-rules .model=${this.model}></wakesurf-mesh-rules>
                <wakesurf-twin .model=${this.model}></wakesurf-twin>
            </fieldset>
            ${this.several()}
        `;
    }

    private isosurface(): TemplateResult {
        const { state, edits } = this.model;
        return html`<fieldset class="edits" ?disabled=${state.locked.value}>
            ${(this.level ??= new LevelRows(this.model)).rows()}
            <p class="quiet" id="surface-remark" role="status" ?hidden=${edits.remark.value === null}>${edits.remark.value}</p>
        </fieldset>`;
    }

    /** Returns the rows of surfaces that follow particles. */
    private followedRows(intent: SurfaceIntent, dataset: DatasetDescription): TemplateResult {
        const { state, edits } = this.model;
        const shown = followed(intent, state.surfaceTimes.value, dataset.steady);
        const { longest, dataEnd } = this.longest(intent, dataset);
        const step = longest / lengthSteps;
        return html`
                ${sliderRow({
                    ...{ id: 'length', words: 'Integration time', value: shown, shown: this.duration(shown) },
                    ...{ low: step, high: longest, step },
                    change: (length) => edits.changeSurface({ length }),
                })}
                <wakesurf-time-ends .model=${this.model}></wakesurf-time-ends>
                <p class="quiet" id="data-end" ?hidden=${!dataEnd || shown < longest * 0.999}>To the end of the data.</p>
                <wakesurf-release .model=${this.model}></wakesurf-release>
                ${intent.kind === 'time' ? this.secondCurve(intent) : ''}
                ${this.separation(dataset, intent.separation)}
                ${selectRow('direction', 'Direction', directionChoices(intent), intent.direction, (direction) => edits.changeSurface({ direction }))}
                ${this.cutBack(intent, dataset)}
                ${selectRow('accuracy', 'Accuracy', accuracies, intent.accuracy, (accuracy) => edits.changeSurface({ accuracy }))}
                ${
                    dataset.smooth
                        ? selectRow('interpolation', 'Interpolation', interpolations, intent.interpolation, (interpolation) =>
                              edits.changeSurface(
                                  interpolation === 'smooth' ? { interpolation, between: 'linear' } : { interpolation },
                              ),
                          )
                        : nothing
                }
                ${
                    intent.kind !== 'stream' &&
                    intent.interpolation === 'linear' &&
                    dataset.grid !== 'analytic' &&
                    this.model.state.surfaceTimes.value.length > 2
                        ? selectRow('between', 'Between stored times', betweens, intent.between, (between) =>
                              edits.changeSurface({ between }),
                          )
                        : nothing
                }
        `;
    }

    /** The end of the slider, and whether it is that of the data. */
    private longest(intent: SurfaceIntent, { steady }: DatasetDescription): { longest: number; dataEnd: boolean } {
        const { surfaceTimes, suggestion } = this.model.state;
        const left = longestLength(intent, surfaceTimes.value, steady);
        if (left !== null) return { longest: Math.max(left, Number.MIN_VALUE), dataEnd: true };
        const usual = suggestion.value?.surfaces.find(({ kind }) => kind === intent.kind);
        const longest = Math.max(intent.length, 2 * (usual === undefined ? intent.length : usual.to - usual.from));
        return { longest, dataEnd: false };
    }

    /** Why a kind that moves is not offered, would show the same, or is small. */
    private kindNote(
        { kind, from }: SurfaceIntent,
        { times, steady, grid }: DatasetDescription,
    ): TemplateResult | typeof nothing {
        const note = (words: string): TemplateResult => html`<p class="quiet" id="kind-note">${words}</p>`;
        if (steady) {
            return kind === 'stream' ? note('The flow does not change: a stream surface is also the streak surface.') : nothing;
        }
        if (times.length < 2) {
            return grid === 'analytic'
                ? nothing
                : note(
                      `The data have one time, ${this.time(times[0] ?? from)}: only stream surfaces and isosurfaces can be shown.`,
                  );
        }
        const stream = this.model.state.suggestion.value?.surfaces.find((each) => each.kind === 'stream');
        const [lasting, usual] = [times.at(-1)! - times[0]!, stream === undefined ? 0 : stream.to - stream.from];
        return usual * leastLasting <= lasting
            ? nothing
            : note(
                  `The data last ${this.duration(lasting)}, and the fluid takes ${this.duration(usual)} to pass: surfaces that move stay short.`,
              );
    }

    /** Both ways, but not as long back as forward. */
    private cutBack(intent: SurfaceIntent, { steady }: DatasetDescription): TemplateResult | typeof nothing {
        const end = cutBackAt(intent, this.model.state.surfaceTimes.value, steady);
        if (end === null) return nothing;
        const words =
            end < intent.from
                ? `Back to ${this.time(end)} only, where the data begin.`
                : `Forward only: the data begin at its release, ${this.time(end)}. Release it later to see both.`;
        return html`<p class="quiet" id="cut-back">${words}</p>`;
    }

    /** A rake may have several surfaces, or none. */
    private several(): TemplateResult {
        const { state, view, edits } = this.model;
        const rake = state.activeRake.value ?? '';
        const active = state.activeSurface.value;
        const own = surfacesOf(state, rake).map((id) => state.surfaces.value.get(id)!);
        const locked = state.locked.value;
        const { hidden } = view.visibility.value;
        const isHidden = hidden.has(active ?? '');
        const choose = (event: Event): void => edits.chooseSurface((event.target as HTMLSelectElement).value);
        return html`<div class="several" role="group" aria-label="Surfaces of this rake">
            ${
                own.length > 1
                    ? html`<select id="which-surface" aria-label="Surface" @change=${choose}>
                      ${own.map(
                          (each, i) =>
                              html`<option value=${each.surface} .selected=${each.surface === active}>
                                  ${surfaceWords(each, i)}
                              </option>`,
                      )}
                  </select>`
                    : html`<span></span>`
            }
            ${
                active === null
                    ? nothing
                    : html`<button
                          type="button"
                          id="hide-surface"
                          aria-pressed=${isHidden ? 'true' : 'false'}
                          title="Hide this surface on this page; the rake stays"
                          @click=${() => view.changeVisibility({ hidden: toggled(hidden, active) })}
                      >
                          Hide
                      </button>`
            }
            <button type="button" ?disabled=${locked} @click=${() => edits.actions.addSurface(rake)}>
                Add surface
            </button>
            ${
                own.length > 0
                    ? html`<button
                      type="button"
                      aria-label="Delete surface"
                      title="Delete this surface; the rake stays"
                      ?disabled=${locked}
                      @click=${() => edits.actions.deleteSurface(active ?? '')}
                  >
                      Delete
                  </button>`
                    : nothing
            }
        </div>`;
    }

    private duration(value: number): string {
        const { state, view } = this.model;
        return withUnit(shortNumber(value), unitOfDuration(view.units.value, state.surfaceDataset.value));
    }

    private time(value: number): string {
        return withUnit(shortNumber(value), this.model.view.units.value.time);
    }

    private length(value: number): string {
        return withUnit(shortNumber(value), this.model.view.units.value.length);
    }

    private kindChoice(kind: SurfaceKind, { times, steady }: DatasetDescription): TemplateResult {
        const { edits, state } = this.model;
        const still = kind !== 'stream' && times.length < 2 && !steady;
        const disabled = still || !state.capabilities.value.includes(kind);
        return html`<label class="kind">
            <input
                type="radio"
                name="kind"
                value=${kind}
                ?disabled=${disabled}
                .checked=${live(edits.intent.value?.kind === kind)}
                @change=${() => this.model.chooseKind(kind)}
            />${kindNames[kind]}
        </label>`;
    }

    /** The second curve of a time surface's patch. */
    private secondCurve({ sweep, rake2 }: SurfaceIntent): TemplateResult {
        const rakes = this.model.state.rakes.value;
        if (sweep === null) {
            const name = rakes.get(rake2 ?? '')?.name ?? 'another rake';
            return html`<p class="quiet">Released between this rake and ${isolated(name)}.</p>`;
        }
        const resolution = resolutionOf(0, diagonal(this.model.state.surfaceDataset.value!.bounds));
        const written = (_axis: number, value: number): string => fieldNumber(value, resolution);
        return html`<div class="sweep" role="group" aria-label="Sweep">
            <span>Sweep</span>
            ${vectorFields('Sweep along', sweep, written, (along) => {
                const may = along.some((each) => each !== 0);
                if (may) this.model.edits.changeSurface({ sweep: along });
                return may;
            })}
        </div>`;
    }

    private separation({ finestSpacing, points }: DatasetDescription, current: number): TemplateResult {
        const { suggestion } = this.model.state;
        const kind = this.model.edits.intent.value?.kind;
        const suggested = suggestion.value?.surfaces.find((each) => each.kind === kind)?.separation;
        const choices = separations.map(({ factor, words }) => ({
            value: factor * finestSpacing,
            // A formula has no grid.
            words: `${this.length(factor * finestSpacing)}, ${factor === 1 && points === 0 ? 'default' : words}`,
        }));
        const close = (value: number): boolean => Math.abs(value - current) <= 1e-6 * current;
        const known = (value: number): boolean => choices.some((each) => Math.abs(each.value - value) <= 1e-6 * value);
        if (suggested !== undefined && !known(suggested)) {
            choices.push({ value: suggested, words: `${this.length(suggested)}, suggested` });
        }
        if (!known(current)) choices.push({ value: current, words: this.length(current) });
        choices.sort((a, b) => a.value - b.value);
        return selectRow('separation', 'Separation', choices, close, (separation) =>
            this.model.edits.changeSurface({ separation }),
        );
    }
}

function directionChoices({ kind }: SurfaceIntent): Choice<Direction>[] {
    return directions.filter(({ value }) => directionsOf(kind).includes(value));
}

function surfaceWords({ kind, direction }: SurfaceRecord, index: number): string {
    return `${index + 1}: ${kindNames[kind]}${direction === 'forward' ? '' : `, ${direction}`}`;
}

customElements.define('wakesurf-surface', SurfacePanel);
