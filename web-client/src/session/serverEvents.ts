// Hands on what comes by itself: a surface straight to its feed, changes of the connection to who follows them, and the server's
// notifications (records, surfaces, people, datasets, notices) to whom they concern.
import { type Notification, type ReportedError, type SurfaceDone, unreadableWords } from '../protocol/messages.ts';
import type { AppState } from '../state/appState.ts';
import type { WorkerEvent } from '../worker/workerClient.ts';
import type { OpenDataset } from './openDataset.ts';
import type { People } from './people/people.ts';
import type { SessionController } from './sessionController.ts';
import type { LongCall } from './base/longCall.ts';
import type { SurfaceFeed } from './surface/surfaceFeed.ts';
import type { SurfaceOutcomes, SurfaceProgress } from './surface/surfaceProgress.ts';

/** Notices before the server closes the connection, which the page tells in its own words. */
const closingNotices: ReadonlySet<string> = new Set(['displaced', 'removed', 'linkEnded', 'loggedOut']);
/** Notices of which the newest takes the place of the other. */
const noticeSubjects: Readonly<Record<string, string>> = { notDurable: 'durability', durableAgain: 'durability' };

/** Notices of something that has happened once more when they come again. */
const repeatableNotices: ReadonlySet<string> = new Set(['dataReplaced']);

export interface ServerEventsOptions {
    state: AppState;
    feed: Pick<SurfaceFeed, 'done' | 'progressed' | 'ranged'>;
    outcomes: Pick<SurfaceOutcomes, 'done'>;
    people: Pick<People, 'patched'>;
    progress: Pick<SurfaceProgress, 'progressed'>;
    longCalls: readonly Pick<LongCall, 'progressed'>[];
    dataset: Pick<OpenDataset, 'patched' | 'stepsPatched'>;
    controller: Pick<SessionController, 'patched' | 'deleted'>;
}

export class ServerEvents {
    private readonly options: ServerEventsOptions;
    private readonly announced = new Map<string, string>();

    constructor(options: ServerEventsOptions) {
        this.options = options;
    }

    dispatch(notification: Notification): void {
        const { feed, outcomes, dataset, people, progress, longCalls, controller } = this.options;
        switch (notification.method) {
            case 'session.patched':
                controller.patched(notification.session, notification.patches);
                break;
            case 'surface.done':
                outcomes.done(notification.stats);
                feed.done(notification.surface, notification.epoch, whyNotWhole(notification));
                break;
            case 'dataset.patched': {
                const { method: _, ...entry } = notification;
                dataset.patched(entry);
                break;
            }
            case 'server.notice':
                this.noticed(notification.kind, notification.text ?? null, notification.surface ?? '');
                break;
            case 'presence.patched':
                people.patched(notification.participants, notification.left);
                break;
            case 'cache.patched':
                dataset.stepsPatched(notification.dataset, notification.held);
                break;
            case 'surface.progress':
                feed.progressed(notification.surface, notification.epoch, notification.seconds ?? null);
                break;
            case 'surface.ranges':
                feed.ranged(notification.surface, notification.ranges);
                break;
            case '$/progress': {
                const { percentage, message = '', time, quadsSoFar, remaining, seconds } = notification.value;
                for (const each of longCalls) each.progressed(notification.token, percentage ?? 0);
                progress.progressed(notification.token, {
                    ...{ fraction: percentage === undefined ? null : percentage / 100, message },
                    ...{ time: time ?? null, quads: quadsSoFar ?? null },
                    ...{ remaining: remaining ?? null, seconds: seconds ?? null },
                });
                break;
            }
        }
    }

    /** Says that what the page shows is not all there is, until it is loaded by a server that it
     *  understands. */
    unreadable(faults: readonly string[]): void {
        const [first] = faults;
        if (first === undefined) return;
        const more = faults.length > 1 ? ` and ${faults.length - 1} more` : '';
        this.say('unreadable', unreadableWords(first + more));
    }

    /** Whatever the kind, words for people are shown. */
    private noticed(kind: string, text: string | null, surface: string): void {
        const { state, controller } = this.options;
        if (kind === 'sessionDeleted') void controller.deleted();
        else if (kind === 'catchingUp' || kind === 'caughtUp') {
            const surfaces = new Set(state.catchingUp.value);
            if (kind === 'catchingUp') surfaces.add(surface);
            else surfaces.delete(surface);
            state.catchingUp.value = surfaces;
        } else if (text !== null && repeatableNotices.has(kind)) state.notices.say(kind, sentence(text));
        else if (text !== null && !closingNotices.has(kind)) this.say(noticeSubjects[kind] ?? kind, sentence(text));
    }

    /** Some notices come again whenever the session is joined; what was sent away stays away. */
    private say(about: string, words: string): void {
        if (this.announced.get(about) === words) return;
        this.announced.set(about, words);
        this.options.state.notices.say(about, words);
    }
}

/** Errors and notices of the server begin with a small letter. */
function sentence(text: string): string {
    const first = text.charAt(0).toUpperCase() + text.slice(1);
    return /[.!?…]$/.test(first) ? first : `${first}.`;
}

/** A surface that ends before a time-step which cannot be read is there, but not all that was asked for. */
function whyNotWhole({ error, stats }: SurfaceDone): ReportedError | null {
    if (error !== undefined) return error;
    return stats?.stopped === undefined ? null : { message: `The surface ends early: ${stats.stopped}` };
}

export interface Receivers {
    state: Pick<AppState, 'roundTripMs'>;
    feed: Pick<SurfaceFeed, 'receive' | 'troubled'>;
    events: Pick<ServerEvents, 'dispatch' | 'unreadable'>;
    controller: Pick<SessionController, 'connectionChanged'>;
    loginEnded: (login: string) => void;
}

export function dispatchWorkerEvent(event: WorkerEvent, { state, feed, events, controller, loginEnded }: Receivers): void {
    switch (event.type) {
        case 'surface':
            feed.receive(event);
            break;
        case 'frameTrouble':
            void feed.troubled(event.surface, event.subscription, event.reason);
            break;
        case 'notification':
            events.dispatch(event.notification);
            break;
        case 'unreadable':
            events.unreadable(event.faults);
            break;
        case 'roundTrip':
            state.roundTripMs.value = event.ms;
            break;
        case 'loginEnded':
            loginEnded(event.login);
            break;
        case 'connection': {
            const { type: _, ...connection } = event;
            controller.connectionChanged(connection);
            break;
        }
    }
}
