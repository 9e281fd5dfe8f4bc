// The people of the session: who is there, what they look at and point at; and what of ours they are told.
// Presence is no part of the record: nothing of it is kept, and while no other user is there nothing is sent.
import { batch } from '@preact/signals-core';
import type { CameraPlace, JoinedSession, ParticipantChange, Presence, Vec3 } from '../../protocol/messages.ts';
import type { CameraPose } from '../../scene/camera/cameraControls.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

/** Sends as often as the server tells others at most. */
const sendEveryMs = 50;
const upwards: Vec3 = [0, 0, 1];

export interface PeopleOptions {
    state: AppState;
    view: ViewState;
    worker: Pick<WorkerClient, 'notify'>;
    controls: { readonly pose: CameraPose; readonly fov: number; follow: (pose: CameraPose) => void };
    requestFrame: () => void;
    /** Runs an action later; returns how to prevent that. */
    later?: (action: () => void, ms: number) => () => void;
}

export class People {
    private readonly options: PeopleOptions;
    private readonly later: (action: () => void, ms: number) => () => void;
    /** Not told yet; what is told last counts. */
    private pending: Presence = {};
    private sent: Record<string, string> = {};
    private resting = false;

    constructor(options: PeopleOptions) {
        this.options = options;
        this.later = options.later ?? afterTimeout;
    }

    joined({ participants, you }: Pick<JoinedSession, 'participants' | 'you'>): void {
        const { state } = this.options;
        batch(() => {
            state.you.value = you;
            state.participants.value = new Map(participants.map((each) => [each.participant, each]));
        });
        this.sent = {};
        this.pending = {};
        this.cameraMoved();
    }

    patched(changes: readonly ParticipantChange[], left: readonly string[]): void {
        const { state, view, requestFrame } = this.options;
        const people = new Map(state.participants.value);
        const alone = people.size < 2;
        for (const change of changes) {
            const before = people.get(change.participant) ?? newcomer(change.participant);
            people.set(change.participant, { ...before, ...change });
            // What a host has allowed this page.
            if (change.participant === state.you.value && change.role !== undefined) state.role.value = change.role;
        }
        for (const id of left) people.delete(id);
        state.participants.value = people;
        if (left.includes(view.following.value ?? '')) view.following.value = null;
        // A newcomer to a user who was alone has been told nothing of them.
        if (alone && people.size > 1) {
            this.sent = {};
            this.cameraMoved();
        }
        if (changes.some(({ participant, camera }) => participant === view.following.value && camera !== undefined)) {
            this.follow();
        }
        requestFrame();
    }

    /** Looks as another user does from now on; null: as this page's user likes. */
    startFollowing(participant: string | null): void {
        this.options.view.following.value = participant;
        this.follow();
    }

    /** The user has taken the camera: they no longer follow. */
    takeCamera(): void {
        this.options.view.following.value = null;
        this.cameraMoved();
    }

    cameraMoved(): void {
        const { position, target, orthographic } = this.options.controls.pose;
        const fov = orthographic ? {} : { fov: this.options.controls.fov };
        this.tell({ camera: { position, target, up: upwards, ...fov } });
    }

    tell(presence: Presence): void {
        this.pending = { ...this.pending, ...presence };
        if (!this.resting) this.send();
    }

    private send(): void {
        const { state, worker } = this.options;
        if (state.participants.value.size < 2) return;
        const fresh = Object.entries(this.pending).filter(([name, value]) => this.sent[name] !== JSON.stringify(value));
        this.pending = {};
        if (fresh.length === 0) return;
        for (const [name, value] of fresh) this.sent[name] = JSON.stringify(value);
        worker.notify('presence.update', Object.fromEntries(fresh));
        this.resting = true;
        this.later(() => {
            this.resting = false;
            this.send();
        }, sendEveryMs);
    }

    private follow(): void {
        const { state, view, controls, requestFrame } = this.options;
        const camera = state.participants.value.get(view.following.value ?? '')?.camera;
        if (camera === undefined || camera === null) return;
        controls.follow(poseOf(camera));
        view.orthographic.value = camera.fov === undefined;
        requestFrame();
    }
}

function poseOf({ position, target, fov }: CameraPlace): CameraPose {
    return { position, target, orthographic: fov === undefined };
}

function newcomer(participant: string) {
    return { participant, name: '', colour: '#888888', role: 'viewer', connected: true } as const;
}

function afterTimeout(action: () => void, ms: number): () => void {
    const timer = setTimeout(action, ms);
    return () => clearTimeout(timer);
}
