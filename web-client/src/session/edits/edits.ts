// The user's edits, whatever of: what is chosen, the rakes and surfaces on their way to the server, and the
// way back.
import { limits } from '../../protocol/generated/limits.ts';
import { effect, untracked } from '@preact/signals-core';
import { type AppState, withEntry } from '../../state/appState.ts';
import type { SurfaceEpoch, Vec3 } from '../../protocol/messages.ts';
import type { RakeMove } from '../../scene/rake/rakeInteraction.ts';
import type { RakeShape } from '../../scene/rake/rakeShape.ts';
import type { LatencyLog } from '../../state/latency.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { Gestures } from './gestures.ts';
import { type RakeChange, RakeEdits } from './rakeEdits.ts';
import { RecordActions } from './recordActions.ts';
import { Selection } from './selection.ts';
import { SurfaceEdits } from './surfaceEdits.ts';
import type { SurfaceIntent } from './surfaceIntent.ts';
import { type TurnAlong, UndoHistory } from './undoHistory.ts';

/** The server tells others of no more. */
const maxPresencePoints = limits.presencePoints;

export interface EditsOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    latency: LatencyLog;
    requestFrame: () => void;
    /** Returns whether a handle is held at the moment. */
    dragging: () => boolean;
}

/** A record that is moved. */
export interface Moved {
    noun: 'rake' | 'slice' | 'lines';
    id: string;
}

/** An act of another page's user, which is followed. */
export interface FollowedAct {
    /** Its name here. */
    gesture: string;
    along: TurnAlong;
}

/** Moves a record as that of another page is moved; does nothing where it is not there. */
type Follower = (id: string, change: object, act: FollowedAct) => void;

export class Edits {
    readonly gestures = new Gestures(() => this.state.problems.passed('edit'));
    readonly history: UndoHistory;
    readonly actions: RecordActions;
    private readonly state: AppState;
    private readonly rakes: RakeEdits;
    private readonly surfaces: SurfaceEdits;
    private readonly selection: Selection;
    /** Told what this user moves, how and as part of which act, as of the other half of a comparison; returns what undo and redo turn with it. */
    onMove: ((moved: Moved, change: object, gesture: string) => TurnAlong | null) | null = null;
    private readonly followers = new Map<Moved['noun'], Follower>();
    /** Made by this user, and chosen once its record is here. */
    private awaited: { rake: string } | { surface: string } | null = null;

    constructor(options: EditsOptions) {
        const { state, worker } = options;
        this.state = state;
        this.history = new UndoHistory(state, worker);
        this.selection = new Selection(state);
        const shared = {
            ...options,
            history: this.history,
            gestures: this.gestures,
            onChange: () => (state.editsPending.value = this.rakes.busy || this.surfaces.busy),
            requested: (surface: SurfaceEpoch) => this.requested(surface),
        };
        this.rakes = new RakeEdits(shared);
        this.surfaces = new SurfaceEdits(shared);
        this.addFollower('rake', (rake, change, act) => this.rakes.follow(rake, change, act));
        this.actions = new RecordActions(state, worker, this, (made) => {
            this.awaited = made;
            this.recordsChanged();
        });
        effect(() => {
            if (this.selection.overtaken) untracked(() => this.recordsChanged());
        });
    }

    /** Returns what the controls show of the active surface: ahead of the record while edits are on their
     *  way. */
    get intent(): SurfaceEdits['intent'] {
        return this.surfaces.intent;
    }

    /** Returns what became of the last change of the active surface where it is not just what was asked
     *  for. */
    get remark(): SurfaceEdits['remark'] {
        return this.surfaces.remark;
    }

    get seeds(): RakeEdits['seeds'] {
        return this.rakes.seeds;
    }

    /** Called at the start of every frame. */
    flush(): void {
        this.rakes.flush();
        this.surfaces.flush();
    }

    moveRake(move: RakeMove): void {
        const moved: Moved = { noun: 'rake', id: this.state.activeRake.value ?? '' };
        this.rakes.move(move, (gesture) => this.onMove?.(moved, { shape: move.shape }, gesture) ?? null);
    }

    /** Returns what others are told of a move while it lasts. */
    draggedNow({ shape, dragging }: RakeMove): { rake: string; points: Vec3[] } | null {
        const rake = this.state.activeRake.value;
        if (!dragging || rake === null || shape.points.length > maxPresencePoints) return null;
        return { rake, points: shape.points.map((point) => [...point] as Vec3) };
    }

    /** Changes the shape of the active rake. */
    setShape(shape: RakeShape): void {
        this.changeRake(this.state.activeRake.value ?? '', { shape });
    }

    changeRake(rake: string, change: RakeChange): void {
        this.rakes.change(rake, change, (gesture) => this.onMove?.({ noun: 'rake', id: rake }, change, gesture) ?? null);
    }

    /** Of what is loaded later, as slices. */
    addFollower(noun: Moved['noun'], follow: Follower): void {
        this.followers.set(noun, follow);
    }

    /** Does as is told of another page: nothing is told of it. */
    follow({ noun, id }: Moved, change: object, act: FollowedAct): void {
        this.followers.get(noun)?.(id, change, act);
    }

    /** Undoes or redoes the newest step, if that is the one which this goes with. */
    async turnToo(along: TurnAlong, way: 'undo' | 'redo'): Promise<void> {
        await this.allSent();
        await this.history.turn(way, along);
    }

    /**
     * @param gesture the act it is part of, where that is not the control's
     * @param remark what is to be said of it at the controls
     * @param along what undo and redo turn with it
     */
    changeSurface(change: Partial<SurfaceIntent>, gesture?: string, remark?: string | null, along?: TurnAlong): void {
        this.surfaces.change(change, gesture, remark, along);
    }

    chooseRake(rake: string): void {
        if (rake === this.state.activeRake.value) return;
        this.selection.chooseRake(rake);
        this.recordsChanged();
    }

    chooseSurface(surface: string): void {
        this.selection.chooseSurface(surface);
        this.recordsChanged();
    }

    async undo(): Promise<void> {
        this.state.problems.passed('edit');
        await this.allSent();
        await this.history.turn('undo');
    }

    async redo(): Promise<void> {
        this.state.problems.passed('edit');
        await this.allSent();
        await this.history.turn('redo');
    }

    /** Takes over the server's records wherever no edit of ours is ahead of them. */
    recordsChanged(): void {
        this.chooseAwaited();
        this.selection.settle();
        this.surfaces.recordsChanged();
        this.rakes.recordsChanged();
    }

    /** The connection was lost: what was not sent is what the user sees, and is sent again. */
    reconnected(): void {
        this.rakes.reconnected();
        this.surfaces.reconnected();
    }

    /** Sends what was done before an undo ahead of it. */
    private allSent(): Promise<void> {
        ++this.history.turns.value;
        this.flush();
        const { editsPending } = this.state;
        if (!editsPending.value) return Promise.resolve();
        return new Promise((resolve) => {
            const stop = editsPending.subscribe((pending) => {
                if (pending) return;
                resolve();
                queueMicrotask(() => stop());
            });
        });
    }

    private chooseAwaited(): void {
        const { awaited, state, selection } = this;
        if (awaited === null) return;
        if ('rake' in awaited) {
            if (!state.rakes.value.has(awaited.rake)) return;
            selection.chooseRake(awaited.rake);
        } else {
            if (!state.surfaces.value.has(awaited.surface)) return;
            selection.chooseSurface(awaited.surface);
        }
        this.awaited = null;
    }

    private requested({ surface, epoch }: SurfaceEpoch): void {
        const epochs = this.state.requestedEpochs;
        if (epoch <= (epochs.value.get(surface) ?? 0)) return;
        epochs.value = withEntry(epochs.value, surface, epoch);
    }
}
