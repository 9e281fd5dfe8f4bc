// Undo and redo as a person counts them: the server turns a whole gesture at once, and this page knows which
// of the steps there its user has made. What it made itself, as the first rake of a session, is none of them.
import { signal } from '@preact/signals-core';
import type { HistoryDepth } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellFailure } from './editFailures.ts';

type Way = 'undo' | 'redo';

export class UndoHistory {
    readonly undoable = signal(0);
    readonly redoable = signal(0);
    /** Holds what the last step came to, for people. */
    readonly words = signal('');
    /** Grows with every turn that is asked for: what goes on by itself stops then. */
    readonly turns = signal(0);
    /** Grows with every edit and every turn that the server has taken. */
    readonly taken = signal(0);
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;
    /** Names the gesture of the newest step; none after a turn, which ends it on the server as well. */
    private gesture: string | null = null;
    private last: Promise<unknown> = Promise.resolve();

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>) {
        this.state = state;
        this.worker = worker;
    }

    /** The server has taken an edit. */
    noted(gesture: string): void {
        if (gesture !== this.gesture) ++this.undoable.value;
        this.gesture = gesture;
        this.redoable.value = 0;
        this.words.value = '';
        ++this.taken.value;
    }

    /** Another session, or another life of the server: what was counted here is not what it would turn. */
    clear(): void {
        this.count(0, 0);
        this.words.value = '';
    }

    undo(): Promise<void> {
        return this.turn('undo');
    }

    redo(): Promise<void> {
        return this.turn('redo');
    }

    private turn(way: Way): Promise<void> {
        // One after the other: two at once would count wrongly.
        const turned = this.last.then(() => this.turnOne(way));
        this.last = turned;
        return turned;
    }

    private async turnOne(way: Way): Promise<void> {
        const { undoable, redoable } = this;
        if ((way === 'undo' ? undoable : redoable).value === 0) {
            this.nothing(way);
            return;
        }
        try {
            const result = await this.worker.call(`history.${way}`, {});
            const { skipped } = result;
            const done = 'undone' in result ? result.undone : result.redone;
            if (skipped.length === 0 && done === null) {
                if (way === 'undo') this.count(0, redoable.value);
                else this.count(undoable.value, 0);
                this.nothing(way);
                return;
            }
            ++this.taken.value;
            const made = skipped.length === 0 ? 1 : 0;
            if (way === 'undo') this.count(undoable.value - 1, redoable.value + made);
            else this.count(undoable.value + made, redoable.value - 1);
            this.tell(way, skipped);
        } catch (error) {
            tellFailure(this.state, 'undo', error);
        }
    }

    private nothing(way: Way): void {
        this.words.value = `Nothing left to ${way}.`;
    }

    private tell(way: Way, skipped: HistoryDepth['skipped']): void {
        this.words.value = way === 'undo' ? 'Undone.' : 'Redone.';
        this.state.problems.solved('undo');
        if (skipped.length === 0) return;
        const why = skipped.map(({ type, id, why: reason }) => reason.replace(`${type} ${id}`, this.nameOf(type, id)));
        const done = way === 'undo' ? 'undone' : 'redone';
        this.words.value = `Not ${done}: ${why.join('; ')}.`;
        this.state.notices.say('undo', this.words.value);
    }

    private nameOf(type: string, id: string): string {
        if (type === 'annotation') return 'a note';
        if (type === 'bookmark') return 'a view';
        const { rakes, surfaces } = this.state;
        const rake = type === 'surface' ? (surfaces.value.get(id)?.rake ?? '') : id;
        const name = rakes.value.get(rake)?.name ?? '';
        if (name === '') return `a ${type}`;
        return type === 'surface' ? `the surface of ${name}` : name;
    }

    private count(undoable: number, redoable: number): void {
        this.gesture = null;
        this.undoable.value = undoable;
        this.redoable.value = redoable;
    }
}
