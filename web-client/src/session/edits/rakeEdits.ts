// The user's edits of rakes on their way to the server: of each rake only the newest counts, and what is on
// the screen stays ahead of the record until it is answered.
import { signal } from '@preact/signals-core';
import { EditWindow } from '../../connection/editWindow.ts';
import type { RakeRecord, SurfaceEpoch } from '../../protocol/messages.ts';
import { boundsRound } from '../../scene/domain/domainAxes.ts';
import type { RakeMove } from '../../scene/rake/rakeInteraction.ts';
import { fitted, type RakeShape } from '../../scene/rake/rakeShape.ts';
import type { AppState } from '../../state/appState.ts';
import type { LatencyLog } from '../../state/latency.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { refusalWords, announceFailure } from '../base/calls.ts';
import type { Gestures } from './gestures.ts';
import type { TurnAlong, UndoHistory } from './undoHistory.ts';

const numbersEveryMs = 200;

/** Name the problems of numbers that the active rake cannot have: told where they are typed, and solved by
 *  whatever changes the same of it. */
export const numberProblems = { shape: 'rake outside', seeds: 'seeds' } as const;

/** All of a rake that people set. */
interface RakeEdit {
    rake: string;
    shape: RakeShape;
    seeds: number;
    name: string;
    colour: string | undefined;
    dragging: boolean;
    editedAt: number;
    gesture: string;
    along: TurnAlong | null;
}

/** Returns what undo and redo turn with an act. */
type AlongOf = (gesture: string) => TurnAlong | null;

export type RakeChange = Partial<Pick<RakeEdit, 'shape' | 'seeds' | 'name' | 'colour'>>;

interface OneRake {
    window: EditWindow<RakeEdit>;
    newest: RakeEdit;
    /** The revision of the record that the newest answer spoke of; 0 after a refusal. */
    answeredRev: number;
    refused: boolean;
}

export interface RakeEditsOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    latency: LatencyLog;
    history: UndoHistory;
    gestures: Gestures;
    requestFrame: () => void;
    onChange: () => void;
    requested: (surface: SurfaceEpoch) => void;
    /** Returns whether a handle is held at the moment. */
    dragging: () => boolean;
}

export class RakeEdits {
    /** The number of seeds of the active rake, ahead of its record. */
    readonly seeds = signal(0);
    private readonly options: RakeEditsOptions;
    private readonly edited = new Map<string, OneRake>();
    private numbersShownAt = 0;
    private shown: string | undefined;
    /** The one that goes on; it ends without a last move where its rake is deleted. */
    private drag: { rake: string; gesture: string } | null = null;

    constructor(options: RakeEditsOptions) {
        this.options = options;
    }

    get busy(): boolean {
        return [...this.edited.values()].some(({ window }) => window.busy);
    }

    flush(): void {
        for (const { window } of this.edited.values()) window.flush();
    }

    /** The active rake, moved in the scene. */
    move({ shape, dragging, movedAt }: RakeMove, alongOf: AlongOf = () => null): void {
        const { state } = this.options;
        const rake = state.activeRake.value;
        if (rake === null) return;
        const gesture = this.drag?.rake === rake ? this.drag.gesture : this.options.gestures.begin();
        this.drag = dragging ? { rake, gesture } : null;
        const fitted = dragging ? shape : this.inDomain(rake, shape);
        // The numbers in the panel need not follow every frame: drawing text costs as much as the surface.
        if (!dragging || movedAt - this.numbersShownAt > numbersEveryMs) {
            this.numbersShownAt = movedAt;
            state.rakeShape.value = fitted;
        }
        this.submit(rake, { shape: fitted }, { dragging, editedAt: movedAt, gesture, along: alongOf(gesture) });
    }

    change(rake: string, change: RakeChange, alongOf: AlongOf = () => null): void {
        const gesture = this.options.gestures.pressed(`rake ${rake} ${Object.keys(change).join()}`, performance.now());
        this.follow(rake, change, { gesture, along: alongOf(gesture) });
    }

    /** Changes it as part of an act that has a name. */
    follow(rake: string, change: RakeChange, act: Pick<RakeEdit, 'along' | 'gesture'>): void {
        const fitted = change.shape === undefined ? change : { ...change, shape: this.inDomain(rake, change.shape) };
        if (rake === this.options.state.activeRake.value) {
            if (fitted.shape !== undefined) this.options.state.rakeShape.value = fitted.shape;
            if (fitted.seeds !== undefined) this.seeds.value = fitted.seeds;
        }
        this.submit(rake, fitted, { dragging: false, editedAt: performance.now(), ...act });
    }

    /** Takes over the active rake's record unless an edit of ours is ahead of it. */
    recordsChanged(): void {
        const { state, dragging } = this.options;
        if (!dragging()) this.drag = null;
        this.forgetAllBut(state.rakes.value);
        const record = state.rake.value;
        if (record?.rake !== this.shown) {
            for (const about of Object.values(numberProblems)) state.problems.solved(about);
        }
        this.shown = record?.rake;
        const own = this.edited.get(record?.rake ?? '');
        if (dragging() || own?.window.busy === true) return;
        // The record that the answer spoke of is still on its way.
        if (record !== undefined && own !== undefined && own.answeredRev > record.rev) return;
        this.seeds.value = record?.seeds ?? 0;
        state.rakeShape.value = record ?? { kind: 'line', points: [] };
    }

    /** A new connection, perhaps to a server that counts from the start. */
    reconnected(): void {
        for (const one of this.edited.values()) one.answeredRev = 0;
    }

    /** Drops what was still to be said of a rake that has been deleted. */
    private forgetAllBut(rakes: ReadonlyMap<string, RakeRecord>): void {
        const gone = [...this.edited.keys()].filter((rake) => !rakes.has(rake));
        for (const rake of gone) {
            this.edited.delete(rake);
            this.options.state.problems.solved(`rake ${rake}`);
        }
        if (gone.length > 0) this.options.onChange();
    }

    private submit(rake: string, change: RakeChange, how: Pick<RakeEdit, 'along' | 'dragging' | 'editedAt' | 'gesture'>): void {
        const { state } = this.options;
        const record = state.rakes.value.get(rake);
        if (record === undefined) return;
        if (change.shape !== undefined) state.problems.solved(numberProblems.shape);
        if (change.seeds !== undefined) state.problems.solved(numberProblems.seeds);
        const own = this.edited.get(rake);
        const base = own?.window.busy === true ? own.newest : settingsOf(record);
        const edit: RakeEdit = { ...base, rake, ...change, ...how };
        // Letting go where the last move was brings nothing new, unless it ends a lease.
        if (!edit.dragging && !this.leases && own?.window.busy !== true && sameRake(edit, record)) return;
        const one = own ?? this.track(edit);
        one.newest = edit;
        one.window.submit(edit);
    }

    private track(newest: RakeEdit): OneRake {
        const window = new EditWindow<RakeEdit>({
            requestFlush: this.options.requestFrame,
            onChange: () => this.settled(newest.rake),
            send: (edit) => this.send(edit),
        });
        const one: OneRake = { window, newest, answeredRev: 0, refused: false };
        this.edited.set(newest.rake, one);
        return one;
    }

    private settled(rake: string): void {
        this.options.onChange();
        const one = this.edited.get(rake);
        if (one === undefined || one.window.busy || this.options.dragging()) return;
        // What is refused goes back to where all other users see it.
        if (one.answeredRev > 0 || one.refused) this.recordsChanged();
        one.refused = false;
    }

    private async send({ shape, dragging, editedAt, gesture, along, colour, ...edit }: RakeEdit): Promise<void> {
        const { state, worker, latency, history, requested } = this.options;
        const one = this.edited.get(edit.rake);
        // The flag takes the lease on the rake, and ends it after the drag.
        const lease = this.leases ? { dragging } : {};
        const tint = colour === undefined ? {} : { colour };
        try {
            const points = shape.points.map((point) => [...point] as [number, number, number]);
            const reply = await worker.call('rake.set', { ...edit, kind: shape.kind, points, ...tint, ...lease, gesture });
            state.problems.solved(`rake ${edit.rake}`);
            history.noted(gesture, along);
            if (one !== undefined) one.answeredRev = reply.rev;
            for (const { surface, epoch } of reply.surfaces) {
                latency.answered(surface, epoch, editedAt);
                requested({ surface, epoch });
            }
        } catch (error) {
            // It was deleted meanwhile, which every user sees.
            if (one === undefined || !this.edited.has(edit.rake)) return;
            announceFailure(state, `rake ${edit.rake}`, error);
            one.answeredRev = 0;
            one.refused ||= refusalWords(error) !== null;
        }
    }

    /** In the data of its surfaces, which need not be those that are worked on; as it is where they are not known. */
    private inDomain(rake: string, shape: RakeShape): RakeShape {
        const { dataset, surfaces } = this.options.state;
        const own = [...surfaces.value.values()].filter((each) => each.rake === rake);
        const data = own.length === 0 ? [dataset.value] : own.map((each) => this.options.state.described(each.dataset));
        const bounds = data.flatMap((each) => (each === null ? [] : [each.bounds]));
        return bounds.length < data.length ? shape : fitted(shape, boundsRound(bounds));
    }

    private get leases(): boolean {
        return this.options.state.capabilities.value.includes('lease');
    }
}

function settingsOf(record: RakeRecord): Omit<RakeEdit, 'along' | 'dragging' | 'editedAt' | 'gesture'> {
    const { rake, kind, points, seeds, name } = record;
    // What is left out of a colour stays as it is.
    return { rake, shape: { kind, points }, seeds, name, colour: undefined };
}

function sameRake({ shape, seeds, name, colour }: RakeEdit, record: RakeRecord): boolean {
    if (seeds !== record.seeds || name !== record.name || (colour ?? record.colour) !== record.colour) return false;
    return shape.kind === record.kind && JSON.stringify(shape.points) === JSON.stringify(record.points);
}
