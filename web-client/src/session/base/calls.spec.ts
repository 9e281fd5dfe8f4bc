import { describe, expect, it, test } from 'vitest';
import { Announcements } from '../../state/announcements.ts';
import { AppState } from '../../state/appState.ts';
import { answering, settled } from '../../testing/fakes.ts';
import { CallError } from '../../worker/workerClient.ts';
import { Gestures } from '../edits/gestures.ts';
import { UndoHistory } from '../edits/undoHistory.ts';
import { Calls, announceUnlessDisconnected } from './calls.ts';

function bench() {
    const state = new AppState();
    const sent: [method: string, params: Record<string, unknown>][] = [];
    const answers: { resolve: (result: unknown) => void; reject: (error: Error) => void }[] = [];
    const worker = answering((method, params) => {
        sent.push([method, params]);
        return new Promise((resolve, reject) => answers.push({ resolve, reject }));
    });
    const [gestures, history] = [new Gestures(), new UndoHistory(state, worker)];
    const acts = { begin: () => gestures.begin(), taken: (gesture: string) => history.noted(gesture) };
    return { state, sent, answers, gestures, history, calls: new Calls(state, worker, acts) };
}

describe('a note or a view that is kept', () => {
    it('is one step with what plays from when it is sent, and told to the server as such', async () => {
        const { sent, answers, gestures, history, calls } = bench();
        history.noted(gestures.begin());
        void calls.try('annotation.set', { text: 'Here', position: [0, 0, 0] });
        const playing = gestures.current;
        expect(sent).toEqual([['annotation.set', { text: 'Here', position: [0, 0, 0], gesture: playing }]]);
        history.noted(playing);
        answers[0]!.resolve({});
        await settled();
        history.noted(gestures.current);
        expect(history.undoable.value).toBe(2);
    });

    it('counts for nothing when it is refused, and what is no edit is no act', async () => {
        const { state, sent, answers, gestures, history, calls } = bench();
        const refused = calls.try('bookmark.delete', { bookmark: 'b1' });
        answers[0]!.reject(new Error('no'));
        expect(await refused).toBeNull();
        expect(state.problems.all.value.has('bookmark.delete')).toBe(true);
        const before = gestures.current;
        void calls.try('session.fork', {});
        answers[1]!.resolve({});
        await settled();
        expect(sent[1]).toEqual(['session.fork', {}]);
        expect([history.undoable.value, gestures.current]).toEqual([0, before]);
    });
});

test('a call that ends with the connection is not told of, one whose answer the page cannot read is', () => {
    const problems = new Announcements();
    const failure = { code: 0, message: 'This page cannot read what the server sent.', hint: '' };
    announceUnlessDisconnected(problems, 'rake', new CallError({ ...failure, kind: 'disconnected' }));
    expect([...problems.all.value]).toEqual([]);
    announceUnlessDisconnected(problems, 'rake', new CallError({ ...failure, kind: 'unreadable' }));
    expect([...problems.all.value]).toEqual([['rake', failure.message]]);
});
