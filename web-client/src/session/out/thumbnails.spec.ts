import { signal } from '@preact/signals-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { answering } from '../../testing/fakes.ts';
import { displayedOf } from '../../testing/records.ts';
import { CallError } from '../../worker/workerClient.ts';
import { leastBetweenMs, maxBytes, restMs, Thumbnails } from './thumbnails.ts';

class Bench {
    state = new AppState();
    taken = signal(0);
    sent: string[] = [];
    drawn = 0;
    busy = false;
    /** Bytes of a picture of quality 1. */
    whole = 10_000;
    refusal: CallError | null = null;
    thumbnails: Thumbnails;

    constructor() {
        this.state.stage.value = 'running';
        this.state.session.value = 'session-1';
        this.state.activeSurface.value = 's1';
        this.final(true);
        const worker = answering((method, { image }) => {
            this.sent.push(`${method} ${atob(String(image)).length}`);
            if (this.refusal !== null) throw this.refusal;
            return {};
        });
        this.thumbnails = new Thumbnails({
            state: this.state,
            worker,
            edits: { history: { taken: this.taken } },
            picture: () => {
                ++this.drawn;
                return {} as HTMLCanvasElement;
            },
            busy: () => this.busy,
            encode: async (_, quality) => new Blob([new Uint8Array(Math.round(quality * this.whole))]),
            now: () => Date.now(),
        });
    }

    final(yes: boolean): void {
        const shown = displayedOf('s1', { phase: yes ? 'final' : 'coarse' });
        this.state.displayed.value = new Map([['s1', shown]]);
    }

    /** An edit of this page's user, and the patch that every user gets of it. */
    edit(): void {
        this.thumbnails.patched();
        ++this.taken.value;
    }
}

describe('a picture of the session for the list', () => {
    beforeEach(() => {
        vi.useFakeTimers();
    });
    afterEach(() => {
        vi.useRealTimers();
    });

    it('is sent once the last edit has rested, and not before another half minute', async () => {
        const bench = new Bench();
        await vi.advanceTimersByTimeAsync(60_000);
        expect(bench.sent).toEqual([]);
        for (let i = 0; i < 20; ++i) {
            bench.edit();
            await vi.advanceTimersByTimeAsync(restMs / 4);
        }
        expect(bench.drawn).toBe(0);
        await vi.advanceTimersByTimeAsync(restMs);
        expect(bench.sent).toEqual(['session.thumbnail 8500']);
        bench.edit();
        await vi.advanceTimersByTimeAsync(leastBetweenMs / 2);
        expect(bench.sent).toHaveLength(1);
        await vi.advanceTimersByTimeAsync(leastBetweenMs);
        expect(bench.sent).toHaveLength(2);
    });

    it('waits until the surface is final and nothing is held', async () => {
        const bench = new Bench();
        bench.final(false);
        bench.busy = true;
        bench.edit();
        await vi.advanceTimersByTimeAsync(2 * restMs);
        bench.final(true);
        await vi.advanceTimersByTimeAsync(2 * restMs);
        expect(bench.drawn).toBe(0);
        bench.busy = false;
        await vi.advanceTimersByTimeAsync(restMs);
        expect(bench.sent).toHaveLength(1);
    });

    it('is left to who has edited since', async () => {
        const bench = new Bench();
        bench.edit();
        await vi.advanceTimersByTimeAsync(restMs / 2);
        bench.thumbnails.patched();
        await vi.advanceTimersByTimeAsync(3 * restMs);
        expect(bench.drawn).toBe(0);
    });

    it('is made worse until the server takes it, and not sent where that does not do', async () => {
        const bench = new Bench();
        bench.whole = 2 * maxBytes;
        bench.edit();
        await vi.advanceTimersByTimeAsync(2 * restMs);
        expect(bench.sent).toEqual([`session.thumbnail ${maxBytes}`]);
        bench.whole = 5 * maxBytes;
        bench.edit();
        await vi.advanceTimersByTimeAsync(2 * leastBetweenMs);
        expect(bench.sent).toHaveLength(1);
    });

    it('is given up without a word where the server does not want any', async () => {
        const bench = new Bench();
        bench.refusal = new CallError({ kind: 'rpc', code: -32601, message: 'there is no such method', hint: '' });
        for (let i = 0; i < 3; ++i) {
            bench.edit();
            await vi.advanceTimersByTimeAsync(2 * leastBetweenMs);
        }
        expect(bench.sent).toHaveLength(1);
        expect(bench.state.problems.all.value.size + bench.state.notices.all.value.size).toBe(0);
    });
});
