// The user's edits of the active rake and surface on their way to the server.
import { signal } from '@preact/signals-core';
import { EditWindow } from '../connection/editWindow.ts';
import type { SurfaceEpoch, SurfaceSetting, Vec3 } from '../protocol/messages.ts';
import type { RakeMove } from '../scene/rake/rakeInteraction.ts';
import { type AppState, withEntry } from '../state/appState.ts';
import type { LatencyLog } from '../state/latency.ts';
import { CallError, type WorkerClient } from '../worker/workerClient.ts';
import {
    fulfils,
    intentOf,
    settingOf,
    type SurfaceIntent,
    withSecondCurve,
} from './surfaceIntent.ts';

const numbersEveryMs = 200;
const notPermitted = -32003;
const leased = -32011;

interface RakeEdit {
    rake: string;
    kind: string;
    name: string;
    points: Vec3[];
    seeds: number;
    dragging: boolean;
    editedAt: number;
}

interface SurfaceEdit {
    setting: SurfaceSetting;
    editedAt: number;
}

export interface EditsOptions {
    state: AppState;
    worker: WorkerClient;
    latency: LatencyLog;
    requestFrame: () => void;
    setRakePoints: (points: readonly Vec3[]) => void;
    /** Whether a handle is held at the moment. */
    dragging: () => boolean;
}

export class Edits {
    /** What the controls show: ahead of the record while edits are on their way. */
    readonly intent = signal<SurfaceIntent | null>(null);
    readonly seeds = signal(0);
    private readonly options: EditsOptions;
    private readonly rakeWindow: EditWindow<RakeEdit>;
    private readonly surfaceWindow: EditWindow<SurfaceEdit>;
    private lastSetting: SurfaceSetting | null = null;
    private lastRake: RakeEdit | null = null;
    private numbersShownAt = 0;
    private refused = false;

    constructor(options: EditsOptions) {
        this.options = options;
        const onChange = (): void => {
            const busy = this.rakeWindow.busy || this.surfaceWindow.busy;
            options.state.editsPending.value = busy;
            if (!busy) this.takeBackRefused();
        };
        const shared = { requestFlush: options.requestFrame, onChange };
        this.rakeWindow = new EditWindow({ ...shared, send: (edit) => this.sendRake(edit) });
        this.surfaceWindow = new EditWindow({ ...shared, send: (edit) => this.sendSurface(edit) });
    }

    /** Called at the start of every frame. */
    flush(): void {
        this.rakeWindow.flush();
        this.surfaceWindow.flush();
    }

    moveRake(move: RakeMove): void {
        // The numbers in the panel need not follow every frame: drawing text costs as much as the surface.
        if (!move.dragging || move.movedAt - this.numbersShownAt > numbersEveryMs) {
            this.numbersShownAt = move.movedAt;
            this.options.state.rakePoints.value = move.points;
        }
        this.submitRake(move.points, this.seeds.value, move.dragging, move.movedAt);
    }

    setSeeds(seeds: number): void {
        this.seeds.value = seeds;
        this.submitRake([...this.options.state.rakePoints.value], seeds, false, performance.now());
    }

    setPoints(points: Vec3[]): void {
        this.options.setRakePoints(points);
        this.moveRake({ points, dragging: false, movedAt: performance.now() });
    }

    changeSurface(change: Partial<SurfaceIntent>): void {
        const { state } = this.options;
        const record = state.surface.value;
        const before = this.intent.value;
        if (record === undefined || before === null) return;
        const dataset = state.dataset.value;
        let intent = { ...before, ...change };
        if (dataset !== null) {
            intent = withSecondCurve(intent, dataset.bounds, state.rakePoints.value);
        }
        this.intent.value = intent;
        const steady = dataset?.steady ?? false;
        const setting = settingOf(intent, record, state.times.value, steady);
        if (setting === null) {
            state.editError.value =
                `No time is left in the data after this moment to follow a ${intent.kind} surface. ` +
                'Choose an earlier time.';
            return;
        }
        this.lastSetting = setting;
        this.surfaceWindow.submit({ setting, editedAt: performance.now() });
    }

    /** Takes over the server's records wherever no edit of ours is ahead of them. */
    recordsChanged(): void {
        const { state, dragging } = this.options;
        const record = state.surface.value;
        const expected = this.lastSetting !== null && !this.surfaceWindow.busy;
        if (record === undefined) this.intent.value = null;
        else if (!this.surfaceWindow.busy && !(expected && fulfils(record, this.lastSetting!))) {
            this.intent.value = intentOf(record);
        }
        const rake = state.rake.value;
        if (dragging() || this.rakeWindow.busy) return;
        this.seeds.value = rake?.seeds ?? 0;
        this.showRake(rake?.points ?? []);
    }

    /** The connection was lost: what was not sent is what the user sees, and is sent again. */
    reconnected(): void {
        this.lastSetting = null;
        this.lastRake = null;
    }

    private showRake(points: readonly Vec3[]): void {
        this.options.state.rakePoints.value = points;
        this.options.setRakePoints(points);
    }

    private submitRake(points: Vec3[], seeds: number, dragging: boolean, editedAt: number): void {
        const rake = this.options.state.rake.value;
        if (rake === undefined) return;
        const { kind, name } = rake;
        const edit = { rake: rake.rake, kind, name, points, seeds, dragging, editedAt };
        // Letting go where the last move was brings nothing new, unless it ends a lease.
        if (!dragging && !this.leases && sameRake(edit, this.lastRake)) {
            this.recordsChanged();
            return;
        }
        this.lastRake = edit;
        this.rakeWindow.submit(edit);
    }

    private get leases(): boolean {
        return this.options.state.capabilities.value.includes('lease');
    }

    private async sendRake({ editedAt, dragging, ...edit }: RakeEdit): Promise<void> {
        const { state, worker, latency } = this.options;
        // The flag takes the lease on the rake, and ends it after the drag.
        const lease = this.leases ? { dragging } : {};
        try {
            const reply = await worker.call('rake.set', { ...edit, ...lease });
            state.editError.value = null;
            for (const { surface, epoch } of reply.surfaces) {
                latency.answered(surface, epoch, editedAt);
                this.requested({ surface, epoch });
            }
            if (reply.clipped) this.adoptClipped(edit.points, reply.points);
        } catch (error) {
            this.failed(error);
        }
    }

    private failed(error: unknown): void {
        const { editError } = this.options.state;
        editError.value = error instanceof Error ? error.message : String(error);
        if (!(error instanceof CallError)) return;
        const { code, message } = error.failure;
        // The hint is for scripts, which can take the rake away from others.
        if (code === leased) editError.value = `${message}: wait until it is let go`;
        this.refused ||= [notPermitted, leased].includes(code);
    }

    /**
     * What may not be changed goes back to where everybody else sees it. Other mistakes stay, to be
     * corrected.
     */
    private takeBackRefused(): void {
        if (!this.refused || this.options.dragging()) return;
        this.refused = false;
        this.lastSetting = null;
        this.lastRake = null;
        this.recordsChanged();
    }

    private adoptClipped(sent: readonly Vec3[], kept: readonly Vec3[]): void {
        if (this.options.dragging()) return;
        const unchanged = JSON.stringify(this.options.state.rakePoints.value) === JSON.stringify(sent);
        if (unchanged) this.showRake(kept);
    }

    private async sendSurface({ setting, editedAt }: SurfaceEdit): Promise<void> {
        const { state, worker, latency } = this.options;
        try {
            const { surface, epoch } = await worker.call('surface.set', setting);
            state.editError.value = null;
            latency.answered(surface, epoch, editedAt);
            this.requested({ surface, epoch });
        } catch (error) {
            this.failed(error);
        }
    }

    private requested({ surface, epoch }: SurfaceEpoch): void {
        const epochs = this.options.state.requestedEpochs;
        if (epoch <= (epochs.value.get(surface) ?? 0)) return;
        epochs.value = withEntry(epochs.value, surface, epoch);
    }
}

function sameRake(a: RakeEdit, b: RakeEdit | null): boolean {
    if (b === null || a.rake !== b.rake || a.seeds !== b.seeds) return false;
    return JSON.stringify(a.points) === JSON.stringify(b.points);
}
