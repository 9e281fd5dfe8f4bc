// All sessions of the server and those in its trash, as the list shows them, and what can be done with them
// there. What the server refuses is said in the list, which lies over everything else.
import { computed, signal } from '@preact/signals-core';
import { faultOf, type OwnServer, requestWords } from '../../connection/ownServer.ts';
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { SessionEntry, SessionImported } from '../../protocol/messages.ts';
import { Announcements, isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import { openFragment, writeFragment } from '../view/urlState.ts';
import { latestSession } from './joinSession.ts';

const noPlace = 'Export the sessions that are no longer needed, and delete them.';
const fullTrash = 'Permanently delete some sessions in the trash.';
/** Others make and delete sessions while the list is open. */
const refreshMs = 5000;

export interface SessionListOptions {
    state: AppState;
    worker: Pick<WorkerClient, 'call'>;
    server: Pick<OwnServer, 'fetch'>;
    /** A session is out of the trash. */
    restored?: (session: string) => void;
    /** Shows another session; replaced in tests. */
    open?: (fragment: string) => void;
}

export interface Limits {
    sessions: number;
    trash: number;
}

export class SessionList {
    /** Null: not known yet. That which was used last comes first. */
    readonly sessions = signal<readonly SessionEntry[] | null>(null);
    readonly trash = signal<readonly SessionEntry[] | null>(null);
    readonly limits = signal<Limits | null>(null);
    /** How many more can be made. */
    readonly remaining = computed(() => {
        const [limits, sessions] = [this.limits.value, this.sessions.value];
        return limits === null || sessions === null ? null : Math.max(0, limits.sessions - sessions.length);
    });
    /** Whether the page came by a share link, which is for its own session only. */
    readonly ownOnly = computed(() => !(this.sessions.value ?? []).some(({ session }) => session === 'main'));
    readonly problems = new Announcements();
    /** What has been done, and what came of it. */
    readonly notices = new Announcements();
    readonly busy = signal(false);
    private readonly options: SessionListOptions;
    private readonly open: (fragment: string) => void;
    private timer: ReturnType<typeof setInterval> | null = null;

    constructor(options: SessionListOptions) {
        this.options = options;
        this.open = options.open ?? openFragment;
    }

    /** While the list is on the screen. */
    watch(): void {
        this.unwatch();
        void this.refresh();
        this.timer = setInterval(() => void this.refresh(), refreshMs);
    }

    unwatch(): void {
        if (this.timer !== null) clearInterval(this.timer);
        this.timer = null;
    }

    async refresh(): Promise<void> {
        const { worker } = this.options;
        try {
            const [active, deleted] = await Promise.all([
                worker.call('session.list', {}),
                worker.call('session.list', { trash: true }),
            ]);
            this.sessions.value = [...active.sessions].sort((a, b) => later(b.lastUsed, a.lastUsed));
            this.trash.value = [...deleted.sessions].sort((a, b) => later(b.deletedAt, a.deletedAt));
            this.limits.value = { sessions: active.limit, trash: active.trashLimit };
            this.problems.solved('list');
        } catch (error) {
            this.problems.tell('list', error);
        }
    }

    enter(session: string): void {
        this.open(writeFragment(session, null));
    }

    /** A new one, and into it. @param dataset null: the server's first */
    async create(name: string, dataset: string | null): Promise<void> {
        await this.attempt(async () => {
            const made = await this.options.worker
                .call('session.create', name === '' ? {} : { name: fitting(name) })
                .catch(inWords(noPlace));
            this.open(writeFragment(made.session, dataset));
        });
    }

    /** The session in which this browser saw the dataset last, if it is still there; else a new one. */
    async enterDataset(dataset: string, name: string): Promise<void> {
        const known = latestSession(dataset);
        await this.refresh();
        const there = this.sessions.value?.find(
            (each) => each.session === known?.session && (each.created ?? '') === known.created,
        );
        if (there === undefined) await this.create(name, dataset);
        else this.open(writeFragment(there.session, dataset));
    }

    async rename(session: string, name: string): Promise<void> {
        await this.attempt(() => this.options.worker.call('session.rename', { session, name: fitting(name) }));
    }

    async copy({ session, name }: SessionEntry): Promise<void> {
        await this.attempt(async () => {
            const made = await this.options.worker
                .call('session.fork', { session, name: fitting(name, ' copy') })
                .catch(inWords(noPlace));
            this.notices.say('done', `“${isolated(name)}” was copied.`, {
                label: 'Open the copy',
                act: () => this.enter(made.session),
            });
        });
    }

    async delete({ session, name }: SessionEntry): Promise<void> {
        await this.attempt(async () => {
            await this.options.worker.call('session.delete', { session }).catch(inWords(fullTrash));
            this.notices.say('done', `“${isolated(name)}” is in the trash.`, {
                label: 'Undo',
                act: () => void this.restore({ session, name }),
            });
        });
    }

    async restore({ session, name }: Pick<SessionEntry, 'session' | 'name'>): Promise<void> {
        await this.attempt(async () => {
            await this.options.worker.call('session.restore', { session }).catch(inWords(noPlace));
            this.options.restored?.(session);
            this.notices.say('done', `“${isolated(name)}” was restored.`, { label: 'Open', act: () => this.enter(session) });
        });
    }

    async deleteForever({ session, name }: SessionEntry): Promise<void> {
        await this.attempt(async () => {
            await this.options.worker.call('session.delete', { session, forever: true });
            this.notices.say('done', `“${isolated(name)}” was deleted permanently.`);
        });
    }

    /** Null where it failed; why is in `problems`. */
    async export({ session }: Pick<SessionEntry, 'session'>): Promise<Blob | null> {
        let file: Blob | null = null;
        await this.attempt(async () => void (file = await fetchSessionFile(this.options.server, session)));
        return file;
    }

    /** Null: there is none. */
    thumbnail(session: string): Promise<Blob | null> {
        return fetchThumbnail(this.options.server, session).catch(() => null);
    }

    async import(file: Blob): Promise<void> {
        await this.attempt(async () => {
            const { session, name, notes } = await sendSessionFile(this.options.server, file);
            const words = [`“${isolated(name)}” was imported.`, ...notes].join(' ');
            this.notices.say('done', words, { label: 'Open', act: () => this.enter(session) });
        });
    }

    /** Removes what was said before: it was about something else. */
    private async attempt(action: () => Promise<unknown>): Promise<void> {
        if (this.busy.value) return;
        this.busy.value = true;
        this.notices.solved('done');
        this.problems.solved('action');
        try {
            await action();
        } catch (error) {
            this.problems.say('action', requestWords(error));
        } finally {
            this.busy.value = false;
        }
        await this.refresh();
    }
}

/** A limit is said with what can be done here: the server's hint names methods, and the list has buttons. */
function inWords(remedy: string): (error: unknown) => never {
    return (error) => {
        if (!(error instanceof CallError) || error.failure.code !== errorCodes.overLimit) throw error;
        const { message } = error.failure;
        throw new Error(`${message.charAt(0).toUpperCase()}${message.slice(1)}. ${remedy}`);
    };
}

function later(a: string | undefined, b: string | undefined): number {
    return Date.parse(a ?? '') - Date.parse(b ?? '') || 0;
}

/** Limits a file, in bytes, to what the server takes; refused here already, lest it is sent for nothing. */
const largestMiB = 24;

type Server = Pick<OwnServer, 'fetch'>;

/** Error: in words. */
async function fetchSessionFile(server: Server, session: string): Promise<Blob> {
    const reply = await server.fetch(`api/v1/sessions/${encodeURIComponent(session)}/session.json`);
    if (!reply.ok) throw await faultOf(reply);
    return reply.blob();
}

/** Error: in words. */
async function sendSessionFile(server: Server, file: Blob): Promise<SessionImported> {
    if (file.size > largestMiB << 20) {
        throw new Error(
            `This file is ${Math.ceil(file.size / (1 << 20))} MiB; a session file is at most ${largestMiB} MiB. Choose the file of an exported session.`,
        );
    }
    const headers = { 'Content-Type': 'application/json' };
    const reply = await server.fetch('api/v1/sessions', { method: 'POST', headers, body: file });
    if (!reply.ok) throw await faultOf(reply);
    return (await reply.json()) as SessionImported;
}

/** The picture of a session, or null where it has none any more. */
async function fetchThumbnail(server: Server, session: string): Promise<Blob | null> {
    const reply = await server.fetch(`api/v1/sessions/${encodeURIComponent(session)}/thumbnail`);
    return reply.ok ? reply.blob() : null;
}

const maxBytes = 120;

/** Cut between characters, so that it and what is put behind it fit. */
export function fitting(name: string, end = ''): string {
    const characters = [...name];
    while (new TextEncoder().encode(characters.join('') + end).length > maxBytes) characters.pop();
    return characters.join('') + end;
}
