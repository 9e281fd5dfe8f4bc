// A comparison begins with a copy of the session, and leaves none behind.
import { expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { Compare, type CompareOptions, type Beside } from './compare.ts';
import type { Half } from './half.ts';

function compareWith(open: CompareOptions<Beside>['open']): { compare: Compare<Beside>; asked: string[]; state: AppState } {
    vi.stubGlobal('addEventListener', () => undefined);
    const asked: string[] = [];
    const state = new AppState();
    const answer = (method: string, params: object): Promise<unknown> => {
        asked.push(`${method} ${JSON.stringify(params)}`);
        return Promise.resolve({ session: 'copy' });
    };
    const compare = new Compare<Beside>({
        left: { state } as Half,
        calls: { try: answer } as CompareOptions<Beside>['calls'],
        views: { current: () => ({}) },
        ...{ open, close: () => undefined },
    });
    return { compare, asked, state };
}

it('says why there is no second picture, takes the copy away, and can be tried again', async () => {
    const { compare, asked, state } = compareWith(() => {
        throw new Error('no graphics');
    });
    await compare.begin();
    expect(asked.at(-1)).toBe('session.delete {"session":"copy","forever":false}');
    expect([...state.notices.all.value.values()].join()).toContain('no graphics');
    expect([compare.busy.value, compare.right.value]).toEqual([false, null]);
});

it('takes the copy away also before its page has entered it', async () => {
    const deleted: unknown[] = [];
    const right = {
        state: new AppState(),
        worker: { call: (_: string, params: object) => Promise.resolve(void deleted.push(params)) },
        end: () => undefined,
    } as unknown as Beside;
    const { compare } = compareWith(() => right);
    await compare.begin();
    expect(right.state.session.value).toBeNull();
    await compare.end();
    expect(deleted).toEqual([
        { session: 'copy', forever: false },
        { session: 'copy', forever: true },
    ]);
});
