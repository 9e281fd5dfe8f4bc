import { describe, expect, it } from 'vitest';
import { AppState } from '../state/appState.ts';
import { ServerNews } from './serverNews.ts';

function bench() {
    const state = new AppState();
    let deleted = 0;
    const patched: string[] = [];
    const unheard = (): void => undefined;
    const news = new ServerNews({
        state,
        feed: { done: unheard, progressed: unheard },
        people: { patched: unheard },
        progress: { progressed: unheard },
        dataset: { patched: unheard, stepsPatched: unheard },
        controller: { patched: (session) => void patched.push(session), deleted: async () => void ++deleted },
    });
    const hear = (kind: string, text: string | null, surface: string | null = null): void =>
        news.take({ method: 'server.notice', kind, text, surface });
    return { state, hear, said: () => [...state.notices.all.value], deleted: () => deleted, news, patched };
}

describe('a notice of the server', () => {
    it('is shown whatever its kind, beside those about other things', () => {
        const { hear, said } = bench();
        hear('recordsKeptAside', 'two rakes could not be used: ask who runs the server');
        hear('carefulStart', 'the server died 3 times in a row.');
        expect(said()).toEqual([
            ['recordsKeptAside', 'Two rakes could not be used: ask who runs the server.'],
            ['carefulStart', 'The server died 3 times in a row.'],
        ]);
    });

    it('takes the place of the one that it answers', () => {
        const { hear, said } = bench();
        hear('notDurable', 'edits are not kept');
        hear('durableAgain', 'edits are kept again');
        expect(said()).toEqual([['durability', 'Edits are kept again.']]);
    });

    it('that was sent away does not come back because the session is joined again, but with another turn', () => {
        const { state, hear, said } = bench();
        hear('notDurable', 'edits are not kept');
        state.notices.solved('durability');
        hear('notDurable', 'edits are not kept');
        expect(said()).toEqual([]);
        hear('durableAgain', 'edits are kept again');
        hear('notDurable', 'edits are not kept');
        expect(said()).toEqual([['durability', 'Edits are not kept.']]);
    });

    it('for programs only, or before the connection is closed, is not shown', () => {
        const { state, hear, said, deleted } = bench();
        hear('catchingUp', null, 's1');
        expect([...state.catchingUp.value]).toEqual(['s1']);
        hear('caughtUp', null, 's1');
        expect(state.catchingUp.value.size).toBe(0);
        hear('linkEnded', 'the share link has expired');
        hear('sessionDeleted', 'the session was deleted');
        expect([said(), deleted()]).toEqual([[], 1]);
    });
});

describe('records that the page cannot read', () => {
    it('are reported, once for the same reason', () => {
        const { state, news, patched } = bench();
        const faults = ['rake r1.seeds is not a whole number', 'rake r2.name is not a text'];
        news.take({ method: 'session.patched', session: 'main', seq: 1, patches: [], faults });
        expect([...state.notices.all.value]).toEqual([
            [
                'unreadable',
                'This page cannot read what the server sent: rake r1.seeds is not a whole number and 1 more. Reload the page.',
            ],
        ]);
        state.notices.solved('unreadable');
        news.take({ method: 'session.patched', session: 'main', seq: 2, patches: [], faults });
        expect([...state.notices.all.value]).toEqual([]);
        expect(patched).toEqual(['main', 'main']);
    });
});
