import { describe, expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/fakes.ts';
import { CallError } from '../../worker/workerClient.ts';
import { Calls } from '../base/calls.ts';
import { readFragment } from '../view/urlState.ts';
import { OwnCopy } from './ownCopy.ts';

function bench(answer: () => object) {
    const state = new AppState();
    state.stage.value = 'running';
    state.sessionName.value = 'wing';
    const called: unknown[] = [];
    const opened: string[] = [];
    const worker = answering((method, params) => {
        called.push([method, params]);
        return answer();
    });
    const copy = new OwnCopy({
        state,
        calls: new Calls(state, worker, { begin: () => '', taken: () => undefined }),
        views: { current: () => ({ camera: { position: [1, 2, 3], target: [0, 0, 0], orthographic: false }, looks: {} }) },
        open: (fragment) => opened.push(fragment),
    });
    return { state, copy, called, opened };
}

describe('a copy of the session', () => {
    it('is opened with the key that lets into it, at the same view', async () => {
        const { copy, called, opened } = bench(() => ({
            session: 'session-9',
            name: 'wing copy',
            remaining: 1,
            key: 'k'.repeat(64),
        }));
        await copy.begin();
        expect(called).toEqual([['session.fork', { name: 'wing copy' }]]);
        const { session, token, state } = readFragment(opened[0]!);
        expect([session, token]).toEqual(['session-9', 'k'.repeat(64)]);
        expect(state?.view.camera?.position).toEqual([1, 2, 3]);
        expect(state?.rakes).toEqual([]);
    });

    it('needs no key where the server’s token is there', async () => {
        const { copy, opened } = bench(() => ({ session: 'session-9', name: 'wing copy', remaining: 1 }));
        await copy.begin();
        expect(readFragment(opened[0]!).token).toBeNull();
    });

    it('leads back to the session that it was made of', () => {
        const { copy, state, opened } = bench(() => ({}));
        copy.back();
        expect(opened).toEqual([]);
        state.copyOf.value = { session: 'main', name: 'wing' };
        copy.back();
        expect(readFragment(opened[0]!).session).toBe('main');
    });

    it('is not there where the server refuses it, which is said, or where it does not hear', async () => {
        const { copy, state, called, opened } = bench(() => {
            throw new CallError({ kind: 'rpc', code: -32014, message: 'too many', hint: '' });
        });
        await copy.begin();
        expect(opened).toEqual([]);
        expect([...state.problems.all.value.values()].join()).toContain('too many');
        expect(copy.possible.value).toBe(true);
        state.stage.value = 'starting';
        await copy.begin();
        expect(called.length).toBe(1);
    });
});
