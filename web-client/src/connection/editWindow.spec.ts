import { describe, expect, it } from 'vitest';
import { EditWindow } from './editWindow.ts';
import { settled } from '../testing/fakes.ts';

class Bench {
    sent: number[] = [];
    flushRequests = 0;
    busyHistory: boolean[] = [];
    answers: (() => void)[] = [];
    window = new EditWindow<number>({
        send: (edit) => {
            this.sent.push(edit);
            return new Promise((resolve) => this.answers.push(resolve));
        },
        requestFlush: () => ++this.flushRequests,
        onChange: () => this.busyHistory.push(this.window.busy),
    });

    async answerOne(): Promise<void> {
        this.answers.shift()?.();
        await settled();
    }
}

describe('EditWindow', () => {
    it('sends only the newest edit of a frame', () => {
        const bench = new Bench();
        for (const edit of [1, 2, 3]) bench.window.submit(edit);
        bench.window.flush();
        bench.window.flush();
        expect(bench.sent).toEqual([3]);
    });

    it('keeps at most four edits unanswered, then sends the newest, never the ones between', async () => {
        const bench = new Bench();
        for (let edit = 1; edit <= 50; ++edit) {
            bench.window.submit(edit);
            bench.window.flush();
        }
        expect(bench.sent).toEqual([1, 2, 3, 4]);
        const before = bench.flushRequests;
        await bench.answerOne();
        expect(bench.flushRequests).toBe(before + 1);
        bench.window.flush();
        expect(bench.sent).toEqual([1, 2, 3, 4, 50]);
    });

    it('is busy until the newest edit is answered', async () => {
        const bench = new Bench();
        expect(bench.window.busy).toBe(false);
        bench.window.submit(1);
        expect(bench.window.busy).toBe(true);
        bench.window.flush();
        expect(bench.window.busy).toBe(true);
        await bench.answerOne();
        expect(bench.window.busy).toBe(false);
        expect(bench.busyHistory).toEqual([true, false]);
    });

    it('asks for no frame when nothing waits', async () => {
        const bench = new Bench();
        bench.window.submit(1);
        bench.window.flush();
        const before = bench.flushRequests;
        await bench.answerOne();
        expect(bench.flushRequests).toBe(before);
    });
});
