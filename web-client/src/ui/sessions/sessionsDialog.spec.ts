// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { OwnServer } from '../../connection/ownServer.ts';
import type { SessionEntry } from '../../protocol/messages.ts';
import { SessionList } from '../../session/sessions/sessionList.ts';
import { savedFiles } from '../../testing/fakes.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import { CallError } from '../../worker/workerClient.ts';
import './sessionsDialog.ts';

const limit = 5;
let bench: PageBench;
let dialog: ShownPanel;
let kept: SessionEntry[];
let trashed: SessionEntry[];
let opened: string[];

function entryOf(session: string, name: string, participants = 0): SessionEntry {
    const counts = { rakes: 1, surfaces: 1, slices: 0, lines: 0, bookmarks: 0, annotations: 0, participants };
    const moments = { created: '2026-11-22T10:00:00Z', lastUsed: '2026-11-22T10:00:00Z' };
    return { session, name, people: [], edited: true, thumbnail: false, ...counts, ...moments };
}

function take(from: SessionEntry[], { session }: Record<string, unknown>): SessionEntry {
    return from.splice(
        from.findIndex((each) => each.session === session),
        1,
    )[0]!;
}

beforeEach(async () => {
    bench = new PageBench();
    kept = [entryOf('main', 'Main', 1), entryOf('old', 'Old'), entryOf('shared', 'Shared work', 2)];
    [trashed, opened] = [[], []];
    Object.assign(bench.answers, {
        'session.list': ({ trash }: Record<string, unknown>) => ({
            sessions: [...(trash === true ? trashed : kept)],
            ...{ limit, trashLimit: 9 },
        }),
        'session.rename': (asked: Record<string, unknown>) => {
            kept = kept.map((each) => (each.session === asked['session'] ? { ...each, name: String(asked['name']) } : each));
            return {};
        },
        'session.delete': (asked: Record<string, unknown>) => {
            if (asked['forever'] === true) return take(trashed, asked) && {};
            const entry = take(kept, asked);
            trashed.push({ ...entry, deletedAt: new Date().toISOString(), deletedUntil: '2026-12-22T10:00:00Z' });
            return {};
        },
        'session.fork': ({ name }: Record<string, unknown>) => {
            kept.push(entryOf('copied', String(name)));
            return { session: 'copied', name, remaining: limit - kept.length };
        },
        'session.restore': (asked: Record<string, unknown>) => {
            kept.push(take(trashed, asked));
            return { remaining: limit - kept.length };
        },
    });
    const { state, view, worker } = bench;
    state.session.value = 'main';
    const sessionList = new SessionList({
        state,
        worker,
        server: new OwnServer('http://localhost/'),
        restored: () => undefined,
        open: (to) => opened.push(to),
    });
    dialog = await ShownPanel.of('wakesurf-sessions', { state, view, sessionList });
    view.sessionsShown.value = true;
    await settled();
    await settled();
});

/** Answers of the server lead to further questions. */
async function settled(): Promise<void> {
    for (let i = 0; i < 4; ++i) await rested();
}

function card(session: string): ShownPanel {
    return dialog.within(`[data-session=${session}]`);
}

async function press(within: ShownPanel, name: string | RegExp): Promise<void> {
    await within.press(name);
    await settled();
}

const names = (): string[] => kept.map(({ name }) => name);

describe('the list of sessions', () => {
    it('says who is there and what is in each', () => {
        expect(card('main').text).toContain('you are here');
        expect(card('main').text).toContain('1 rake, 1 surface');
        expect(card('shared').text).toContain('2 people here now');
    });

    it('renames in place', async () => {
        await press(card('old'), 'Rename');
        const field = card('old').get('input', 'New name of Old');
        field.value = ' Figure 7 ';
        field.form!.dispatchEvent(new Event('submit', { bubbles: true, cancelable: true }));
        await settled();
        expect(names()).toContain('Figure 7');
        expect(card('old').text).toContain('Figure 7');
    });
});

describe('a session that is copied', () => {
    it('is offered to be opened', async () => {
        await press(card('old'), 'Copy');
        expect(bench.asked('session.fork')).toEqual([{ session: 'old', name: 'Old copy' }]);
        expect(dialog.text).toContain('“Old” was copied.');
        expect(card('copied').text).toContain('Old copy');
        await press(dialog, 'Open the copy');
        expect(opened).toEqual(['#session=copied']);
    });
});

describe('a session as a file', () => {
    const file = new Blob(['{"wakesurfSession":1}']);
    const asked: [path: string, init: RequestInit][] = [];
    let reply: () => Response;

    beforeEach(() => {
        asked.length = 0;
        vi.stubGlobal('fetch', async (url: URL, init: RequestInit) => {
            asked.push([url.pathname, init]);
            return reply();
        });
        return () => {
            vi.unstubAllGlobals();
            vi.restoreAllMocks();
        };
    });

    async function choose(): Promise<void> {
        const input = dialog.get('input', 'File of a session');
        Object.defineProperty(input, 'files', { value: [file], configurable: true });
        input.dispatchEvent(new Event('change'));
        await settled();
    }

    it('is saved under its name, and made again from that', async () => {
        const saved = savedFiles();
        reply = () => new Response(file);
        await press(card('shared'), 'Export');
        expect(asked.map(([path]) => path)).toEqual(['/api/v1/sessions/shared/session.json']);
        expect(saved.map(({ name }) => name)).toEqual(['Shared_work-session.json']);
        expect(await saved[0]!.content.text()).toBe(await file.text());

        reply = () => Response.json({ session: 'made', name: 'Shared work', remaining: 1, notes: [] });
        await choose();
        expect(asked[1]).toMatchObject(['/api/v1/sessions', { method: 'POST', body: file }]);
        expect(dialog.text).toContain('“Shared work” was imported.');
        await press(dialog.within('[role=status]'), 'Open');
        expect(opened).toEqual(['#session=made']);
    });

    it('is refused in words where it is none', async () => {
        const error = { message: 'this is not the file of a session', data: { hint: 'choose one that was exported' } };
        reply = () => Response.json({ error }, { status: 400 });
        await choose();
        expect(dialog.within('[role=alert]').text).toMatch(/not the file of a session: choose one/i);
        expect(opened).toEqual([]);
    });
});

describe('a session that is deleted', () => {
    it('asks first where others are in it', async () => {
        await press(card('shared'), 'Delete');
        expect(card('shared').text).toContain('2 others are in it now.');
        await press(card('shared'), 'Keep');
        expect(names()).toContain('Shared work');
        await press(card('shared'), 'Delete');
        await press(card('shared'), 'Delete anyway');
        expect(dialog.text).toContain('“Shared work” is in the trash.');
    });

    it('is taken back by Undo, restored from the trash, or removed for good', async () => {
        await press(card('old'), 'Delete');
        await press(dialog, 'Undo');
        expect(dialog.text).toContain('“Old” was restored.');
        expect(names()).toContain('Old');

        await press(card('old'), 'Delete');
        expect(dialog.all('[data-session=old]')).toEqual([]);
        await press(dialog, /^Trash/);
        expect(card('old').text).toMatch(/Deleted just now, kept until/);
        await press(card('old'), 'Restore');
        expect(dialog.all('[data-session=old]')).toEqual([]);
        expect(names()).toContain('Old');

        await press(dialog, /^On this server/);
        await press(card('old'), 'Delete');
        await press(dialog, /^Trash/);
        await press(card('old'), 'Delete permanently …');
        expect(card('old').text).toContain('This cannot be undone.');
        await press(card('old'), 'Delete permanently');
        expect(dialog.text).toContain('“Old” was deleted permanently.');
        expect([...names(), ...trashed.map(({ name }) => name)]).not.toContain('Old');
        // Where every user meets cannot be deleted.
        await press(dialog, /^On this server/);
        expect(card('main').all('button', 'Delete')).toEqual([]);
    });
});

describe('how many sessions there can be', () => {
    it('is said before it is met, and a refusal says what to do', async () => {
        expect(dialog.text).toContain('there is room for only 2 more. Delete sessions that are no longer needed');
        bench.answers['session.create'] = () => {
            const message = 'the server keeps at most 3 sessions, and that many are there';
            throw new CallError({ kind: 'rpc', code: -32014, message, hint: 'session.delete' } as never);
        };
        const name = dialog.get('input', 'Name of the new session');
        name.value = 'One too many';
        name.form!.dispatchEvent(new Event('submit', { bubbles: true, cancelable: true }));
        await settled();
        expect(dialog.text).toContain(
            'The server keeps at most 3 sessions, and that many are there. Export the sessions that are no longer needed',
        );
        expect(bench.state.session.value).toBe('main');
    });
});
