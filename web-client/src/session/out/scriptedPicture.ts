// `window.wakesurf`: pictures for a program that drives this page, as the client for Python does. It says
// whether all that the session shows is on the screen, and draws a PNG.
import type { ReadonlySignal } from '@preact/signals-core';
import type { FigureBackground } from '../../scene/capture.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { LatencyLog } from '../../state/latency.ts';
import type { ViewState } from '../../state/viewState.ts';
import { type Figure, unfinishedSurface } from './figure.ts';
import type { BodyFields } from '../picture/bodyFields.ts';
import type { Slices } from '../picture/slicesInPicture.ts';
import { addressWith } from './recipes.ts';

export interface ScriptedSetting {
    width: number;
    height: number;
    background: FigureBackground;
    bar: boolean;
    axes: boolean;
    rake: boolean;
    caption: string | null;
}

/** Why the picture is not whole; empty where it is. Begins with `!` where it never will be. `time`: of the
 *  clock, null: as it is. */
export function unfinished(
    state: AppState,
    view: Pick<ViewState, 'lookOf'>,
    bodyFields: Pick<BodyFields, 'status'>,
    fieldsShown: { waiting: ReadonlySignal<boolean> },
    time: number | null,
): string {
    const stage = state.stage.value;
    if (stage !== 'running') {
        return stage === 'failed' || stage === 'gone' || stage === 'ended' ? `!the page has ${stage}` : stage;
    }
    for (const record of state.surfaces.value.values()) {
        const failure = state.surfaceErrors.value.get(record.surface);
        if (failure !== undefined) return `!${record.surface}: ${failure.text}`;
        const why = unfinishedSurface(state, view, record, time);
        if (why !== '') return why;
    }
    if (fieldsShown.waiting.value) return 'a slice or a set of lines is not there';
    return bodyFields.status.value === 'waiting' ? 'the values along the body are not there' : '';
}

export interface PageParts {
    state: AppState;
    view: Pick<ViewState, 'lookOf'>;
    scene: FlowScene;
    bodyFields: Pick<BodyFields, 'status'>;
    /** Slices and lines. */
    fieldsShown: { waiting: ReadonlySignal<boolean> };
    slices: ReadonlySignal<{ slices: Pick<Slices, 'lags'> } | null>;
    latency: LatencyLog;
    canvas: HTMLCanvasElement;
    figure: Figure;
}

export interface ScriptedPage {
    /** Has what tests/end_to_end reads its facts from. */
    readonly parts: PageParts;
    unfinished(time: number | null): string;
    /** Returns a PNG as an address of data. Error: in words. */
    picture(setting: ScriptedSetting): Promise<string>;
    /** Whether the last picture had no room for the scalar bar. */
    readonly barLeftOut: boolean;
}

export function scriptedPage(parts: PageParts): ScriptedPage {
    const { state, view, bodyFields, fieldsShown, figure } = parts;
    return {
        parts,
        unfinished: (time) => unfinished(state, view, bodyFields, fieldsShown, time),
        picture: async ({ width, height, background, caption, bar, axes, rake }) => {
            figure.bar.value = bar;
            figure.axes.value = axes;
            figure.rake.value = rake;
            const drawn = figure.draw({ width, height }, caption, background);
            return addressWith(await figure.recipes(), drawn.toDataURL('image/png'));
        },
        get barLeftOut() {
            return figure.barLeftOut;
        },
    };
}
