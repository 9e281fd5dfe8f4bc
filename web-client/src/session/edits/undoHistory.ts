// Undo and redo as a person counts them: the server turns a whole gesture at once, and this page knows which
// of the steps there its user has made. What it made itself, as the first rake of a session, is none of them.
import { computed, signal } from '@preact/signals-core';
import type { HistoryDepth } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { announceFailure } from '../base/calls.ts';
import { isolated } from '../../state/announcements.ts';

type Way = 'undo' | 'redo';

/** Turns what goes with a step and is no record, as this page's look of a surface. */
export type TurnAlong = Readonly<Record<Way, () => void>>;

export class UndoHistory {
    /** Hold what goes with each step, the newest last. */
    private readonly done = signal<readonly (TurnAlong | null)[]>([]);
    private readonly undone = signal<readonly (TurnAlong | null)[]>([]);
    readonly undoable = computed(() => this.done.value.length);
    readonly redoable = computed(() => this.undone.value.length);
    /** What the last step came to, for people. */
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
    noted(gesture: string, along: TurnAlong | null = null): void {
        if (gesture !== this.gesture) this.done.value = [...this.done.value, along];
        this.gesture = gesture;
        this.undone.value = [];
        this.words.value = '';
        ++this.taken.value;
    }

    /** Another session, or another life of the server: what was counted here is not what it would turn. */
    clear(): void {
        this.keep([], []);
        this.words.value = '';
    }

    /** Turns the newest step. @param only where that is the one which this goes with */
    turn(way: Way, only?: TurnAlong): Promise<void> {
        // One after the other: two at once would count wrongly.
        const turned = this.last.then(() => this.turnOne(way, only));
        this.last = turned;
        return turned;
    }

    private async turnOne(way: Way, only?: TurnAlong): Promise<void> {
        const [done, undone] = [this.done.value, this.undone.value];
        const along = (way === 'undo' ? done : undone).at(-1);
        if (only !== undefined && along !== only) return;
        if (along === undefined) {
            this.nothing(way);
            return;
        }
        try {
            const result = await this.worker.call(`history.${way}`, {});
            const { skipped } = result;
            const turned = 'undone' in result ? result.undone : result.redone;
            if (skipped.length === 0 && turned === null) {
                if (way === 'undo') this.keep([], undone);
                else this.keep(done, []);
                this.nothing(way);
                return;
            }
            ++this.taken.value;
            const made = skipped.length === 0 ? [along] : [];
            if (way === 'undo') this.keep(done.slice(0, -1), [...undone, ...made]);
            else this.keep([...done, ...made], undone.slice(0, -1));
            if (made.length > 0) along?.[way]();
            this.tell(way, skipped);
        } catch (error) {
            announceFailure(this.state, 'undo', error);
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
        if (type === 'slice') return 'a slice';
        if (type === 'lines') return 'the streamlines';
        if (type === 'annotation') return 'a note';
        if (type === 'bookmark') return 'a view';
        const { rakes, surfaces } = this.state;
        const surface = type === 'surface' ? surfaces.value.get(id) : undefined;
        if (surface?.kind === 'level') return 'the isosurface';
        const rake = type === 'surface' ? (surface?.rake ?? '') : id;
        const name = rakes.value.get(rake)?.name ?? '';
        if (name === '') return `a ${type}`;
        return type === 'surface' ? `the surface of ${isolated(name)}` : isolated(name);
    }

    private keep(done: readonly (TurnAlong | null)[], undone: readonly (TurnAlong | null)[]): void {
        this.gesture = null;
        this.done.value = done;
        this.undone.value = undone;
    }
}
