// Times and coordinates as the page writes them: as finely as those of the dataset ask for, however large they are, in the units that
// people of the session have typed, or else that the reader of the data knows.
import { effect } from '@preact/signals-core';
import { fieldNumber, finestStep, placeNumber, resolutionOf } from '../../scene/base/numbers.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState, Units } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { Calls } from '../base/calls.ts';

type TimeState = Pick<AppState, 'dataset' | 'surfaces'>;
type PlaceState = Pick<AppState, 'dataset'>;

/** Shorter times have an exponent. */
const maxDecimals = 6;
const steps = new WeakMap<readonly number[], number>();

/** Returns the resolution of all time-steps and surfaces; 0 where there is only one time. */
function timeResolution({ dataset, surfaces }: TimeState): number {
    const times = dataset.value?.times ?? [];
    const ends = [...surfaces.value.values()].flatMap(({ from, to }) => [from, to]);
    const all = [...times.slice(0, 1), ...times.slice(-1), ...ends].filter(Number.isFinite);
    if (!steps.has(times)) steps.set(times, finestStep(times));
    return resolutionOf(Math.min(...all), Math.max(...all), steps.get(times));
}

export function timeText(state: TimeState, time: number): string {
    return placeNumber(time, timeResolution(state));
}

export function timeWords(state: TimeState, view: Pick<ViewState, 'units'>, time: number): string {
    return withUnit(timeText(state, time), view.units.value.time);
}

export function timeField(state: TimeState, time: number): string {
    return fieldNumber(time, timeResolution(state));
}

/** The time of a clock: four digits, more where time-steps are nearer, as many from state to state while it
 *  runs. */
export function clockText(state: TimeState, time: number, runs: boolean): string {
    const decimals = -Math.ceil(Math.log10(timeResolution(state)) - 1e-9);
    if (!Number.isFinite(time) || !(decimals <= maxDecimals)) return timeField(state, time);
    const text = time.toFixed(Math.max(0, decimals));
    return runs ? text : String(Number(text));
}

export function coordinateText(state: PlaceState, axis: number, value: number): string {
    return placeNumber(value, coordinateResolution(state, axis));
}

export function coordinateField(state: PlaceState, axis: number, value: number): string {
    return fieldNumber(value, coordinateResolution(state, axis));
}

function coordinateResolution({ dataset }: PlaceState, axis: number): number {
    const bounds = dataset.value?.bounds ?? [0, 0, 0, 0, 0, 0];
    return resolutionOf(bounds[2 * axis] ?? 0, bounds[2 * axis + 1] ?? 0);
}

export function showUnits(
    state: Pick<AppState, 'dataset' | 'typedUnits'>,
    view: Pick<ViewState, 'units'>,
    scene: Pick<FlowScene, 'setUnit'>,
): void {
    effect(() => {
        const { lengthUnit = '', timeUnit = '' } = state.dataset.value ?? {};
        const { length, time } = state.typedUnits.value;
        view.units.value = { length: length || lengthUnit, time: time || timeUnit };
        scene.setUnit(view.units.value.length);
    });
}

/** For every user in the session. An empty unit is as the data say. */
export async function typeUnits(state: AppState, calls: Pick<Calls, 'try'>, change: Partial<Units>): Promise<void> {
    const before = state.typedUnits.value;
    const typed = { ...before, ...change };
    const session = state.session.value;
    if (session === null) return;
    state.typedUnits.value = typed;
    if ((await calls.try('session.setUnits', { session, ...typed })) === null && state.typedUnits.value === typed) {
        state.typedUnits.value = before;
    }
}

/** A number with its unit, if there is one. */
export function withUnit(words: string, unit: string): string {
    return unit === '' ? words : `${words} ${unit}`;
}
