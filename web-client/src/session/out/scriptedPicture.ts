// Pictures for a program that drives this page, as the client for Python does: whether all that the session shows is on the screen, and
// the picture as a PNG.
import type { FigureBackground } from '../../scene/capture.ts';
import type { AppState } from '../../state/appState.ts';
import type { Figure } from './figure.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { BodyFlow } from '../picture/bodyFlow.ts';
import { unfinishedSurface } from './wholeSurface.ts';

export interface ScriptedSetting {
    width: number;
    height: number;
    background: FigureBackground;
    bar: boolean;
    axes: boolean;
    rake: boolean;
    caption: string | null;
}

/** Why the picture is not whole; empty where it is. Begins with `!` where it never will be. `time`: of the clock, null: as it is. */
export function unfinished(
    state: AppState,
    view: Pick<ViewState, 'lookOf'>,
    bodyFlow: Pick<BodyFlow, 'standing'>,
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
    return bodyFlow.standing.value === 'waiting' ? 'the flow along the body is not there' : '';
}

/** As an address of data. Error: in words. */
export function scriptedPicture(figure: Figure, setting: ScriptedSetting): string {
    const { width, height, background, caption } = setting;
    figure.bar.value = setting.bar;
    figure.axes.value = setting.axes;
    figure.rake.value = setting.rake;
    return figure.draw({ width, height }, caption, background).toDataURL('image/png');
}
