// The user's edits of surfaces on their way to the server; what the controls show stays ahead of the record meanwhile.
import { signal } from '@preact/signals-core';
import { EditWindow } from '../../connection/editWindow.ts';
import type { SurfaceEpoch, SurfaceRecord, SurfaceSetting } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { LatencyLog } from '../../state/latency.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellFailure } from './editFailures.ts';
import type { Gestures } from './gestures.ts';
import { fulfils, intentOf, settingOf, type SurfaceIntent, withSecondCurve } from './surfaceIntent.ts';
import type { UndoHistory } from './undoHistory.ts';

interface SurfaceEdit {
    setting: SurfaceSetting;
    editedAt: number;
    gesture: string;
}

interface OneSurface {
    window: EditWindow<SurfaceEdit>;
    last: SurfaceSetting | null;
    refused: boolean;
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
    /** Of the active surface: what the controls show. */
    readonly intent = signal<SurfaceIntent | null>(null);
    private readonly options: SurfaceEditsOptions;
    private readonly edited = new Map<string, OneSurface>();
    private intentOf = '';
    /** Of what the intent asks for no time is left. */
    private timeless: string | null = null;

    constructor(options: SurfaceEditsOptions) {
        this.options = options;
    }

    get busy(): boolean {
        return [...this.edited.values()].some(({ window }) => window.busy);
    }

    flush(): void {
        for (const { window } of this.edited.values()) window.flush();
    }

    /** @param gesture left out: the control's that changes this */
    change(change: Partial<SurfaceIntent>, gesture?: string): void {
        const { state, gestures } = this.options;
        const record = state.surface.value;
        const before = this.intent.value;
        if (record === undefined || before === null) return;
        const dataset = state.dataset.value;
        let intent = { ...before, ...change };
        if (dataset !== null) intent = withSecondCurve(intent, dataset.bounds, state.rakePoints.value);
        this.intent.value = intent;
        const setting = settingOf(intent, record, state.times.value, dataset?.steady ?? false);
        if (setting === null) {
            this.timeless = record.surface;
            state.problems.say(timeOf(record.surface), noTimeLeft(intent));
            return;
        }
        this.timeFound();
        const one = this.edited.get(record.surface) ?? this.track(record.surface);
        one.last = setting;
        const editedAt = performance.now();
        const what = `surface ${record.surface} ${Object.keys(change).join()}`;
        one.window.submit({ setting, editedAt, gesture: gesture ?? gestures.slid(what, editedAt) });
    }

    /** Takes over the active surface's record unless an edit of ours is ahead of it. */
    recordsChanged(): void {
        const { surfaces, surface } = this.options.state;
        this.forgetAllBut(surfaces.value);
        const record = surface.value;
        const one = this.edited.get(record?.surface ?? '');
        const another = this.intentOf !== (record?.surface ?? '');
        this.intentOf = record?.surface ?? '';
        if (record === undefined) this.takeOver(null);
        else if (another || one === undefined) this.takeOver(record);
        // A record that is what was asked for brings no news of other people, and less than the intent says.
        else if (!one.window.busy && !(one.last !== null && fulfils(record, one.last))) {
            // Overtaken: should it come back, by a redo, it is news again.
            one.last = null;
            this.takeOver(record);
        }
    }

    reconnected(): void {
        for (const one of this.edited.values()) one.last = null;
    }

    /** What was still to be said of a surface that someone has deleted is not sent any more. */
    private forgetAllBut(surfaces: ReadonlyMap<string, SurfaceRecord>): void {
        const gone = [...this.edited.keys()].filter((id) => !surfaces.has(id));
        for (const id of gone) {
            this.edited.delete(id);
            this.options.state.problems.solved(`surface ${id}`);
        }
        if (gone.length > 0) this.options.onChange();
    }

    private takeOver(record: SurfaceRecord | null): void {
        this.intent.value = record === null ? null : intentOf(record);
        this.timeFound();
    }

    private timeFound(): void {
        if (this.timeless !== null) this.options.state.problems.solved(timeOf(this.timeless));
        this.timeless = null;
    }

    private track(surface: string): OneSurface {
        const window = new EditWindow<SurfaceEdit>({
            requestFlush: this.options.requestFrame,
            onChange: () => this.settled(surface),
            send: (edit) => this.send(surface, edit),
        });
        const one: OneSurface = { window, last: null, refused: false };
        this.edited.set(surface, one);
        return one;
    }

    private settled(surface: string): void {
        this.options.onChange();
        const one = this.edited.get(surface);
        if (one === undefined || one.window.busy || !one.refused) return;
        one.refused = false;
        one.last = null;
        this.recordsChanged();
    }

    private async send(id: string, { setting, editedAt, gesture }: SurfaceEdit): Promise<void> {
        const { state, worker, latency, history, requested } = this.options;
        try {
            const { surface, epoch } = await worker.call('surface.set', { ...setting, gesture });
            state.problems.solved(`surface ${id}`);
            history.noted(gesture);
            latency.answered(surface, epoch, editedAt);
            requested({ surface, epoch });
        } catch (error) {
            const one = this.edited.get(id);
            // It was deleted meanwhile, which everyone sees.
            if (one === undefined) return;
            const refused = tellFailure(state, `surface ${id}`, error);
            one.refused ||= refused;
        }
    }
}

/** What of a surface it is that words about its time are about: an answer to an earlier edit does not take them away. */
function timeOf(surface: string): string {
    return `surface ${surface} time`;
}

function noTimeLeft({ kind, direction }: SurfaceIntent): string {
    const side = direction === 'backward' ? 'before' : direction === 'both' ? 'on both sides of' : 'after';
    const choose = direction === 'backward' ? 'a later' : direction === 'both' ? 'another' : 'an earlier';
    return `No time is left in the data ${side} this moment to follow a ${kind} surface. Choose ${choose} time.`;
}
