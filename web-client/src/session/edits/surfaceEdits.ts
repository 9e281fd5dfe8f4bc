// The user's edits of surfaces on their way to the server; what the controls show stays ahead of the record
// meanwhile.
import { batch, signal } from '@preact/signals-core';
import { EditWindow } from '../../connection/editWindow.ts';
import type { SurfaceEpoch, SurfaceRecord, SurfaceSetting } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { LatencyLog } from '../../state/latency.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { refusalWords, announceFailure } from '../base/calls.ts';
import type { Gestures } from './gestures.ts';
import { fulfils, intentOf, settingOf, type SurfaceIntent, withSecondCurve } from './surfaceIntent.ts';
import { adapted } from './surfaceTimes.ts';
import type { TurnAlong, UndoHistory } from './undoHistory.ts';

interface SurfaceEdit {
    setting: SurfaceSetting;
    editedAt: number;
    gesture: string;
    along: TurnAlong | null;
}

interface OneSurface {
    window: EditWindow<SurfaceEdit>;
    last: SurfaceSetting | null;
    /** The revision of the record that the newest answer spoke of; 0 after a refusal. */
    answeredRev: number;
}

export interface SurfaceEditsOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    latency: LatencyLog;
    history: UndoHistory;
    gestures: Gestures;
    requestFrame: () => void;
    onChange: () => void;
    requested: (surface: SurfaceEpoch) => void;
}

export class SurfaceEdits {
    /** What the controls show of the active surface. */
    readonly intent = signal<SurfaceIntent | null>(null);
    private readonly options: SurfaceEditsOptions;
    private readonly edited = new Map<string, OneSurface>();
    /** What became of the last change where it is not just what was asked for: told at the controls. */
    readonly remark = signal<string | null>(null);
    private intentOf = '';
    /** The record that the intent shows; null where the intent is ahead. */
    private taken: SurfaceRecord | null = null;

    constructor(options: SurfaceEditsOptions) {
        this.options = options;
    }

    get busy(): boolean {
        return [...this.edited.values()].some(({ window }) => window.busy);
    }

    flush(): void {
        for (const { window } of this.edited.values()) window.flush();
    }

    /**
     * @param gesture left out: the control's that changes this
     * @param remark what is to be said of it, beside what cannot be just so
     * @param along what undo and redo turn with it, which makes it an act of its own
     */
    change(change: Partial<SurfaceIntent>, gesture?: string, remark: string | null = null, along: TurnAlong | null = null): void {
        const { state, gestures } = this.options;
        const record = state.surface.value;
        const before = this.intent.value;
        if (record === undefined || before === null) return;
        const dataset = state.surfaceDataset.value;
        if (dataset === null) {
            this.remark.value = 'Not applied: the data of this surface are not known.';
            return;
        }
        const { steady, bounds } = dataset;
        const times = state.surfaceTimes.value;
        const { intent: possible, remark: note } = adapted({ ...before, ...change }, change.from !== undefined, times, steady);
        const intent = withSecondCurve(possible, bounds, state.rakePoints.value);
        const setting = settingOf(intent, record, times, steady);
        if (setting === null) {
            this.remark.value = `Not applied: the data have no time to follow a ${intent.kind} surface in.`;
            return;
        }
        this.taken = null;
        batch(() => {
            this.intent.value = intent;
            this.remark.value = [note, remark].find((words) => words !== null) ?? null;
        });
        const one = this.edited.get(record.surface) ?? this.track(record.surface);
        one.last = setting;
        const editedAt = performance.now();
        const what = `surface ${record.surface} ${Object.keys(change).join()}`;
        const act = gesture ?? (along === null ? gestures.slid(what, editedAt) : gestures.begin());
        one.window.submit({ setting, editedAt, gesture: act, along });
    }

    /** Takes over the active surface's record unless an edit of ours is ahead of it. */
    recordsChanged(): void {
        const { surfaces, surface } = this.options.state;
        this.forgetAllBut(surfaces.value);
        const record = surface.value;
        const one = this.edited.get(record?.surface ?? '');
        const lastSetting = one?.last ?? null;
        const another = this.intentOf !== (record?.surface ?? '');
        this.intentOf = record?.surface ?? '';
        if (record === undefined) this.takeOver(null);
        else if (another) this.takeOver(record, true);
        else if (record === this.taken || one?.window.busy === true) return;
        // The record that the answer spoke of is still on its way.
        else if (one !== undefined && one.answeredRev > record.rev) return;
        // A record that is what was asked for brings no news of other people, and less than the intent says.
        else if (lastSetting === null || !fulfils(record, lastSetting)) {
            // Overtaken: should it come back, by a redo, it is news again.
            if (one !== undefined) one.last = null;
            this.takeOver(record);
        }
    }

    /** A new connection, perhaps to a server that counts from the start. */
    reconnected(): void {
        for (const one of this.edited.values()) {
            one.last = null;
            one.answeredRev = 0;
        }
    }

    /** Drops what was still to be said of a surface that has been deleted. */
    private forgetAllBut(surfaces: ReadonlyMap<string, SurfaceRecord>): void {
        const gone = [...this.edited.keys()].filter((id) => !surfaces.has(id));
        for (const id of gone) {
            this.edited.delete(id);
            this.options.state.problems.solved(`surface ${id}`);
        }
        if (gone.length > 0) this.options.onChange();
    }

    private takeOver(record: SurfaceRecord | null, another = false): void {
        this.taken = record;
        const intent = record === null ? null : intentOf(record);
        // As when the rake has moved: what was said of the controls is still true.
        if (JSON.stringify(intent) === JSON.stringify(this.intent.value) && !another) return;
        batch(() => {
            this.intent.value = intent;
            this.remark.value = null;
        });
    }

    private track(surface: string): OneSurface {
        const window = new EditWindow<SurfaceEdit>({
            requestFlush: this.options.requestFrame,
            onChange: () => this.settled(surface),
            send: (edit) => this.send(surface, edit),
        });
        const one: OneSurface = { window, last: null, answeredRev: 0 };
        this.edited.set(surface, one);
        return one;
    }

    private settled(surface: string): void {
        this.options.onChange();
        // What others have done meanwhile was left aside.
        if (this.edited.get(surface)?.window.busy === false) this.recordsChanged();
    }

    private async send(id: string, { setting, editedAt, gesture, along }: SurfaceEdit): Promise<void> {
        const { state, worker, latency, history, requested } = this.options;
        try {
            const { surface, epoch, rev } = await worker.call('surface.set', { ...setting, gesture });
            state.problems.solved(`surface ${id}`);
            const one = this.edited.get(id);
            if (one !== undefined) one.answeredRev = rev;
            history.noted(gesture, along);
            latency.answered(surface, epoch, editedAt);
            requested({ surface, epoch });
        } catch (error) {
            const one = this.edited.get(id);
            // It was deleted meanwhile, which every user sees.
            if (one === undefined) return;
            announceFailure(state, `surface ${id}`, error);
            // The newest goes back to what every user sees; what came after this one may yet be taken.
            if (one.last === setting) this.goBack(id, one, refusalWords(error));
        }
    }

    private goBack(id: string, one: OneSurface, why: string | null): void {
        one.last = null;
        one.answeredRev = 0;
        const record = this.options.state.surface.value;
        if (record?.surface !== id) return;
        this.takeOver(record);
        this.remark.value = why === null ? null : `Not applied: ${why}`;
    }
}
