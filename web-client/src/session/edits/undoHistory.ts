// Undo and redo as a person counts them. The server keeps an edit for every call; what one gesture or one press of a button
// sent in several calls is taken back at once.
import { signal } from '@preact/signals-core';
import type { HistoryDepth } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellFailure } from './editFailures.ts';

/** Edits of one slider that follow each other faster are one step. */
const gesturePauseMs = 1000;

interface Step {
    gesture: string;
    calls: number;
    at: number;
}

type Way = 'undo' | 'redo';

export class UndoHistory {
    readonly undoable = signal(0);
    readonly redoable = signal(0);
    /** What the last step came to, for people. */
    readonly words = signal('');
    private readonly state: AppState;
    private readonly worker: WorkerClient;
    private readonly stacks: Record<Way, Step[]> = { undo: [], redo: [] };
    private last: Promise<unknown> = Promise.resolve();

    constructor(state: AppState, worker: WorkerClient) {
        this.state = state;
        this.worker = worker;
    }

    /** The server has taken an edit. `same`: those of one gesture are one edit for the server too, as a drag is. */
    noted(gesture: string, at: number, same: boolean): void {
        const { undo } = this.stacks;
        const top = undo.at(-1);
        this.stacks.redo = [];
        if (top?.gesture === gesture && (same || at - top.at < gesturePauseMs)) {
            if (!same) top.calls += 1;
            top.at = at;
        } else undo.push({ gesture, calls: 1, at });
        this.words.value = '';
        this.count();
    }

    /** Another session, or another life of the server: what was counted here is not what it would turn. */
    clear(): void {
        this.stacks.undo = [];
        this.stacks.redo = [];
        this.words.value = '';
        this.count();
    }

    undo(): Promise<void> {
        return this.turn('undo');
    }

    redo(): Promise<void> {
        return this.turn('redo');
    }

    private turn(way: Way): Promise<void> {
        // One after the other: two at once would turn each other's edits.
        const turned = this.last.then(() => this.turnOne(way));
        this.last = turned;
        return turned;
    }

    private async turnOne(way: Way): Promise<void> {
        const step = this.stacks[way].pop();
        if (step === undefined) {
            this.words.value = `Nothing of yours is left to ${way}.`;
            return;
        }
        const results: HistoryDepth[] = [];
        try {
            for (let i = 0; i < step.calls; ++i) results.push(await this.worker.call(`history.${way}`, {}));
            this.tell(way, results.flatMap((result) => result.skipped));
        } catch (error) {
            // The rest is still to be turned, what was turned can be turned back.
            this.keep(way, step, step.calls - results.length);
            tellFailure(this.state, 'undo', error);
        }
        this.keep(way === 'undo' ? 'redo' : 'undo', step, results.filter(({ skipped }) => skipped.length === 0).length);
        this.count();
    }

    /** A gesture of its own from here on: what comes next is no part of it. */
    private keep(way: Way, step: Step, calls: number): void {
        if (calls > 0) this.stacks[way].push({ ...step, calls, gesture: '' });
    }

    private tell(way: Way, skipped: HistoryDepth['skipped']): void {
        this.words.value = way === 'undo' ? 'Undone.' : 'Done again.';
        this.state.problems.solved('undo');
        if (skipped.length === 0) return;
        const why = skipped.map(({ type, id, why: reason }) => reason.replace(`${type} ${id}`, this.nameOf(type, id)));
        const done = way === 'undo' ? 'taken back' : 'done again';
        this.words.value = `Not ${done}: ${why.join('; ')}.`;
        this.state.notice.value = this.words.value;
    }

    private nameOf(type: string, id: string): string {
        const { rakes, surfaces } = this.state;
        const rake = type === 'surface' ? (surfaces.value.get(id)?.rake ?? '') : id;
        const name = rakes.value.get(rake)?.name ?? '';
        if (name === '') return `a ${type}`;
        return type === 'surface' ? `the surface of ${name}` : name;
    }

    private count(): void {
        this.undoable.value = this.stacks.undo.length;
        this.redoable.value = this.stacks.redo.length;
    }
}
