// The chosen rake in numbers, by buttons and by keys: everything a pointer can do to it, without dragging.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { limits } from '../../protocol/generated/limits.ts';
import type { RakeKind, Vec3 } from '../../protocol/messages.ts';
import { fieldNumber, niceStep, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import { diagonal } from '../../scene/camera/cameraControls.ts';
import { gridStep, unitAxis } from '../../scene/rake/rakeDrag.ts';
import { gripOf, type Handle } from '../../scene/rake/rakeHandles.ts';
import { withCoordinate } from '../../scene/rake/rakeInteraction.ts';
import { asKind, circleOf, circleShape, type RakeShape, withoutPoint, withPointAfter } from '../../scene/rake/rakeShape.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { numberProblems } from '../../session/edits/rakeEdits.ts';
import { coordinateField, coordinateText, withUnit } from '../../session/picture/writtenNumbers.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, numberField, numberRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

const rakePanelStyles = css`
    fieldset {
        display: contents;
    }
    .pair {
        display: grid;
        grid-template-columns: 1fr 1fr;
        gap: 10px;
    }
    .pair label {
        display: grid;
        grid-template-columns: auto minmax(0, 1fr);
        gap: 8px;
        align-items: center;
    }
    .row {
        margin-top: 8px;
    }
    .row input,
    .row select {
        width: 84px;
    }
    select {
        min-width: 0;
    }
    .point {
        display: grid;
        grid-template-columns: 62px repeat(3, minmax(0, 1fr));
        gap: 6px;
        align-items: center;
        margin-top: 6px;
    }
    .point input.long {
        padding-inline: 2px;
        font-size: 11px;
        letter-spacing: -0.2px;
    }
    .handle {
        padding-inline: 2px;
    }
    [aria-pressed='true'] {
        border-color: var(--accent);
        box-shadow: inset 0 0 0 1px var(--accent);
    }
    .turn {
        grid-template-columns: 62px 1fr 1fr;
    }
    .heads {
        margin: 8px 0 -6px;
        color: var(--quiet);
        text-align: center;
    }
    .tools {
        margin-top: 10px;
        padding: 2px 10px 10px;
        border: 1px solid var(--line);
        border-radius: 8px;
    }
    .nudges {
        display: grid;
        grid-template-columns: repeat(6, minmax(0, 1fr));
        gap: 4px;
        margin-top: 8px;
    }
    .nudges.two {
        grid-template-columns: 1fr 1fr;
    }
    .nudges button {
        padding-inline: 2px;
    }
    .wide {
        width: 100%;
        margin-top: 8px;
    }
    .check {
        margin-top: 10px;
        cursor: pointer;
    }
`;

type Axis = 0 | 1 | 2;

const nudgeKeys: Record<string, [axis: Axis, sign: 1 | -1]> = {
    ArrowRight: [0, 1],
    ArrowLeft: [0, -1],
    PageUp: [1, 1],
    PageDown: [1, -1],
    ArrowUp: [2, 1],
    ArrowDown: [2, -1],
};
const turnKeys: Record<string, 1 | -1> = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 };
/** Are parts of the domain's diagonal; ten times as much with Shift. */
const stepFractions = [0.002, 0.01, 0.05];
const turnDegrees = 5;
const mostSeeds = limits.seeds;
const axes = ['x', 'y', 'z'] as const;
const shapes: [RakeKind, string][] = [
    ['line', 'Line'],
    ['polyline', 'Polyline'],
    ['circle', 'Circle'],
];

export interface RakeModel {
    state: AppState;
    view: Pick<ViewState, 'plot' | 'tool' | 'units' | 'visibility'>;
    edits: Pick<Edits, 'changeRake' | 'seeds' | 'setShape'>;
    scene: Pick<FlowScene, 'interaction' | 'rakes'>;
}

export class RakePanel extends ModelElement<RakeModel> {
    /** What the buttons act on. */
    private readonly chosen = signal<Handle>(0);
    /** The point of a rake with many points whose numbers are shown. */
    private readonly shownPoint = signal(1);
    private readonly stepIndex = signal(0);
    private readonly snapping = signal(false);

    static override styles = rakePanelStyles;

    override connectedCallback(): void {
        super.connectedCallback();
        this.snapping.value = this.model.scene.interaction.step !== null;
    }

    override render(): TemplateResult {
        const { state } = this.model;
        const shape = state.rakeShape.value;
        if (state.rake.value === undefined || state.dataset.value === null || shape.points.length === 0) return html``;
        const rows = handleRows(shape, this.shownPoint.value);
        const { lockedRakes } = this.model.view.visibility.value;
        return html`<fieldset ?disabled=${state.locked.value || lockedRakes.has(state.activeRake.value ?? '')}>
            ${this.shapeAndSeeds(shape.kind)}
            <div class="point heads" aria-hidden="true">
                <span></span>${axes.map((axis) => html`<span>${this.inUnits(axis)}</span>`)}
            </div>
            ${rows.map((row) => this.pointRow(row.handle, row.name))}
            ${shape.points.length > 12 ? this.pointChoice(shape.points.length) : nothing}
            ${shape.kind === 'circle' ? this.radius() : nothing} ${this.turnRow()}
            <p class="hint" id="nudge-hint">
                Drag a handle, or focus its button and press ← → for x, ↑ ↓ for z, Page Up/Down for y. Hold Shift
                for longer steps.
            </p>
            ${this.buttons()} ${this.snapChoice()}
        </fieldset>
        <button type="button" class="wide" id="plot-rake" @click=${() => (this.model.view.plot.value = 'rake')}>Plot along the rake</button>
        ${this.why()}`;
    }

    /** Why the rake is where the server suggests one. */
    private why(): TemplateResult | typeof nothing {
        const { suggestion } = this.model.state;
        const same = suggestion.value?.rake.points.every((point, i) => String(point) === String(this.points[i])) ?? false;
        return same ? html`<p class="hint" id="rake-why">Chosen by the data: ${lowered(suggestion.value!.why)}</p>` : nothing;
    }

    private get points(): readonly Vec3[] {
        return this.model.state.rakePoints.value;
    }

    /** The chosen handle, or one that this rake has. */
    private get target(): Handle {
        const chosen = this.chosen.value;
        const { kind, points } = this.model.state.rakeShape.value;
        if (chosen === 'middle' || (kind === 'circle' && chosen === 0)) return 'middle';
        return typeof chosen === 'number' && chosen < points.length ? chosen : 0;
    }

    private get step(): number {
        const { state, scene } = this.model;
        const size = diagonal(state.dataset.value!.bounds);
        return scene.interaction.step ?? niceStep(size * (stepFractions[this.stepIndex.value] ?? 0.01));
    }

    private inUnits(words: string | number): string {
        return withUnit(typeof words === 'number' ? shortNumber(words) : words, this.model.view.units.value.length);
    }

    private shapeAndSeeds(kind: RakeKind): TemplateResult {
        const { edits, state } = this.model;
        const choices: [RakeKind, string][] = kind === 'points' ? [...shapes, ['points', 'Points']] : shapes;
        const change = (event: Event): void => {
            const chosen = (event.target as HTMLSelectElement).value as RakeKind;
            edits.setShape(asKind(state.rakeShape.value, chosen, longestAxis(state.dataset.value!.bounds)));
        };
        return html`<div class="pair">
            <label>Shape
                <select id="shape" @change=${change}>
                    ${choices.map(([value, words]) => html`<option value=${value} .selected=${value === kind}>${words}</option>`)}
                </select>
            </label>
            <label>Seeds
                ${numberField({ id: 'seeds', narrow: true, shown: String(edits.seeds.value), change: (typed) => this.seedsTyped(typed) })}
            </label>
        </div>`;
    }

    private pointRow(handle: Handle, name: string): TemplateResult {
        const at = this.placeOf(handle);
        return html`<div class="point" role="group" aria-label=${`${name} point`}>
            ${this.handleButton(handle, name)}
            ${axes.map((axis, k) => {
                const value = at[k] ?? 0;
                return numberField({
                    ...{ label: `${name} ${axis}`, title: String(value), narrow: true },
                    shown: coordinateField(this.model.state, k, value),
                    change: (typed) => this.coordinateTyped(typed, handle, k as Axis),
                });
            })}
        </div>`;
    }

    private placeOf(handle: Handle): Vec3 {
        return handle === 'middle' ? gripOf(this.model.state.rakeShape.value) : (this.points[handle as number] ?? [0, 0, 0]);
    }

    private handleButton(handle: Handle, name: string): TemplateResult {
        const { interaction } = this.model.scene;
        const pressed = handle !== 'rotate' && handle === this.target;
        return html`<button
            type="button"
            class="handle"
            data-handle=${String(handle)}
            aria-describedby="nudge-hint"
            aria-pressed=${pressed ? 'true' : 'false'}
            @click=${() => (this.chosen.value = handle)}
            @focus=${() => interaction.highlight(handle)}
            @blur=${() => {
                interaction.endNudge();
                interaction.highlight(null);
            }}
            @keydown=${(event: KeyboardEvent) => this.key(event, handle)}
            @keyup=${() => interaction.endNudge()}
        >
            ${name}
        </button>`;
    }

    private turnRow(): TemplateResult {
        const { interaction } = this.model.scene;
        const turn = (sign: 1 | -1) => () => interaction.turn((sign * turnDegrees * Math.PI) / 180);
        return html`<div class="point turn" role="group" aria-label="Rotate about the middle">
            ${this.handleButton('rotate', 'Turn')}
            <button type="button" aria-label="Turn left" @click=${turn(1)}>↺ ${turnDegrees}°</button>
            <button type="button" aria-label="Turn right" @click=${turn(-1)}>↻ ${turnDegrees}°</button>
        </div>`;
    }

    private pointChoice(count: number): TemplateResult {
        return numberRow(`Point (1 to ${count})`, {
            ...{ id: 'point-number', narrow: true, min: 2, max: count - 1, shown: String(this.shownPoint.value + 1) },
            change: (typed) => {
                this.shownPoint.value = Math.round(typed) - 1;
            },
        });
    }

    private radius(): TemplateResult {
        const { state, edits } = this.model;
        const circle = circleOf(state.rakeShape.value);
        return numberRow(this.inUnits('Radius'), {
            ...{ id: 'radius', narrow: true, min: 0, shown: this.radiusText(circle.radius) },
            change: (radius) => {
                if (radius > 0) edits.setShape(circleShape({ ...circle, radius }));
                return radius > 0;
            },
        });
    }

    private radiusText(radius: number): string {
        return fieldNumber(radius, resolutionOf(0, diagonal(this.model.state.dataset.value!.bounds)));
    }

    /** For whoever neither drags nor types. */
    private buttons(): TemplateResult {
        const { state, scene, view } = this.model;
        const { kind, points } = state.rakeShape.value;
        const target = this.target;
        const name = handleNameOf(target, state.rakeShape.value);
        const placing = view.tool.value === 'place';
        const nudge = (axis: Axis, sign: 1 | -1) => () => scene.interaction.nudge(target, this.along(axis, sign));
        return html`<div class="tools" role="group" aria-label=${`Move ${name}`}>
            <div class="row">
                <span>Move <strong>${name}</strong> by</span>
                <select id="nudge-step" aria-label="Length of a step" ?disabled=${this.snapping.value}
                    @change=${(event: Event) => (this.stepIndex.value = Number((event.target as HTMLSelectElement).value))}>
                    ${this.snapping.value ? html`<option .selected=${true}>${this.inUnits(this.step)}</option>` : this.stepChoices()}
                </select>
            </div>
            <div class="nudges">
                ${axes.flatMap((axis, k) =>
                    ([-1, 1] as const).map(
                        (sign) =>
                            html`<button type="button" class=${`axis-${axis}`}
                                aria-label=${`${name} ${sign < 0 ? 'minus' : 'plus'} ${axis}`}
                                @click=${nudge(k as Axis, sign)}>${sign < 0 ? '−' : '+'}${axis}</button>`,
                    ),
                )}
            </div>
            <button type="button" class="wide" id="place" aria-pressed=${placing ? 'true' : 'false'}
                @click=${() => this.place(target, placing)}>
                ${placing ? 'Click in the picture (Esc to cancel)' : `Place ${name} with a click`}
            </button>
            ${
                (kind === 'polyline' || kind === 'line') && target !== 'middle'
                    ? this.pointButtons(target as number, points.length)
                    : nothing
            }
        </div>`;
    }

    private stepChoices(): TemplateResult[] {
        const size = diagonal(this.model.state.dataset.value!.bounds);
        return stepFractions.map(
            (fraction, i) =>
                html`<option value=${i} .selected=${i === this.stepIndex.value}>
                    ${this.inUnits(niceStep(size * fraction))}
                </option>`,
        );
    }

    private pointButtons(index: number, count: number): TemplateResult {
        const { state, edits } = this.model;
        const add = (): void => {
            edits.setShape(withPointAfter(state.rakeShape.value, index));
            this.chosen.value = index + 1;
            this.shownPoint.value = Math.max(1, index + 1);
        };
        const remove = (): void => {
            const less = withoutPoint(state.rakeShape.value, index);
            if (less !== null) edits.setShape(less);
            this.chosen.value = Math.max(0, index - 1);
        };
        return html`<div class="nudges two">
            <button type="button" @click=${add}>Add point after</button>
            <button type="button" ?disabled=${count <= 2} @click=${remove}>Remove point</button>
        </div>`;
    }

    private snapChoice(): TemplateResult {
        const { state, scene } = this.model;
        const step = gridStep(state.dataset.value!.bounds);
        const change = (on: boolean): void => {
            this.snapping.value = on;
            scene.interaction.step = on ? step : null;
        };
        return html`${checkRow(`Snap to a grid of ${this.inUnits(step)}`, this.snapping.value, change, { id: 'snap' })}
            <p class="hint">Hold Shift while dragging to stay on one axis.</p>`;
    }

    private key(event: KeyboardEvent, handle: Handle): void {
        const { interaction } = this.model.scene;
        if (handle === 'rotate') {
            const sign = turnKeys[event.key];
            if (sign === undefined) return;
            event.preventDefault();
            interaction.turn((sign * turnDegrees * (event.shiftKey ? 3 : 1) * Math.PI) / 180, true);
            return;
        }
        const key = nudgeKeys[event.key];
        if (key === undefined) return;
        event.preventDefault();
        const by = this.along(...key).map((each) => each * (event.shiftKey ? 10 : 1)) as Vec3;
        interaction.nudge(handle, by, true);
    }

    private along(axis: Axis, sign: 1 | -1): Vec3 {
        const by: Vec3 = [0, 0, 0];
        by[axis] = sign * this.step;
        return by;
    }

    private place(handle: Handle, placing: boolean): void {
        const { view, scene } = this.model;
        scene.interaction.place(placing ? null : handle);
        view.tool.value = placing ? 'none' : 'place';
    }

    /** Takes a typed coordinate. One that does not fit into the domain stops at its edge, in words. */
    private coordinateTyped(typed: number, handle: Handle, axis: Axis): void {
        const { state, edits } = this.model;
        const { bounds } = state.dataset.value!;
        const { shape, stoppedAt } = withCoordinate(state.rakeShape.value, handle, axis, typed, bounds);
        edits.setShape(shape);
        if (stoppedAt === null) state.problems.solved(numberProblems.shape);
        else state.problems.sayUntil('edit', numberProblems.shape, this.stoppedWords(axis, typed, stoppedAt));
    }

    private stoppedWords(axis: Axis, typed: number, stoppedAt: number): string {
        const { state } = this.model;
        const { bounds } = state.dataset.value!;
        const [low, high] = [bounds[2 * axis]!, bounds[2 * axis + 1]!].map((end) => coordinateText(state, axis, end));
        const name = axes[axis];
        const others = axes.filter((each) => each !== name).join(' and ');
        return (
            `${name} = ${coordinateText(state, axis, typed)} does not fit into the domain, which extends from ${name} = ${low} to ${high}. ` +
            `${name} stops at ${coordinateText(state, axis, stoppedAt)}; ${others} stay.`
        );
    }

    private seedsTyped(typed: number): void {
        const { state, edits } = this.model;
        const seeds = Math.round(typed);
        if (seeds >= 2 && seeds <= mostSeeds) {
            edits.changeRake(state.activeRake.value ?? '', { seeds });
        } else {
            const words = `A rake has 2 to ${mostSeeds} seeds. This one still has ${edits.seeds.value}.`;
            state.problems.sayUntil('edit', numberProblems.seeds, words);
        }
    }
}

/** Most flows go along the longest side of their domain. */
function longestAxis(bounds: readonly number[]): Vec3 {
    const sides = ([0, 1, 2] as const).map((axis) => bounds[2 * axis + 1]! - bounds[2 * axis]!);
    return unitAxis(sides.indexOf(Math.max(...sides)) as Axis);
}

function lowered(sentence: string): string {
    return sentence.charAt(0).toLowerCase() + sentence.slice(1);
}

interface HandleRow {
    handle: Handle;
    name: string;
}

/** With more points than these only the first, the last and one chosen by its number are listed. */
const mostRows = 12;

function handleNameOf(handle: Handle, { kind, points }: RakeShape): string {
    if (handle === 'rotate') return 'Turn';
    if (kind === 'circle') return ['Centre', 'Rim', 'Tilt'][handle === 'middle' ? 0 : handle] ?? '';
    if (handle === 'middle') return 'Middle';
    if (handle === 0) return 'Start';
    return handle === points.length - 1 ? 'End' : `Point ${handle + 1}`;
}

/** @param shown the index of the point that is listed of many */
function handleRows(shape: RakeShape, shown: number): HandleRow[] {
    const last = shape.points.length - 1;
    const all = [...shape.points.keys()];
    const few = last < mostRows ? all : [0, Math.min(shown, last - 1), last];
    const handles: Handle[] = shape.kind === 'circle' ? ['middle', 1, 2] : [...few, 'middle'];
    return handles.map((handle) => ({ handle, name: handleNameOf(handle, shape) }));
}

customElements.define('wakesurf-rake', RakePanel);
