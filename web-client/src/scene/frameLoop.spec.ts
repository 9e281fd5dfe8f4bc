import { describe, expect, it } from 'vitest';
import { FrameLoop } from './frameLoop.ts';

/** A loop whose animation frames and GPU come when the test says so. */
function steppedLoop() {
    const scheduled: (() => void)[] = [];
    const finishing: (() => void)[] = [];
    let drawn = 0;
    const changes: boolean[] = [];
    const loop = new FrameLoop(
        (finished, changed) => {
            ++drawn;
            changes.push(changed);
            finishing.push(finished);
        },
        (callback) => scheduled.push(callback),
    );
    return {
        loop,
        changes,
        get drawn() {
            return drawn;
        },
        animationFrame: () => scheduled.splice(0).forEach((callback) => callback()),
        gpuFinishes: () => finishing.splice(0).forEach((finished) => finished()),
    };
}

describe('FrameLoop', () => {
    it('draws one frame for any number of requests, and none without', () => {
        const stepped = steppedLoop();
        stepped.animationFrame();
        expect(stepped.drawn).toBe(0);
        stepped.loop.request();
        stepped.loop.request();
        stepped.animationFrame();
        stepped.gpuFinishes();
        stepped.animationFrame();
        expect(stepped.drawn).toBe(1);
    });

    it('keeps at most one frame on its way, and draws the newest state after it', () => {
        const stepped = steppedLoop();
        stepped.loop.request();
        stepped.animationFrame();
        stepped.loop.request();
        stepped.loop.request();
        stepped.animationFrame();
        expect(stepped.drawn).toBe(1);
        stepped.gpuFinishes();
        stepped.animationFrame();
        expect(stepped.drawn).toBe(2);
    });

    it('runs what must come before a frame at its start', () => {
        const stepped = steppedLoop();
        const order: number[] = [];
        stepped.loop.beforeFrame(() => order.push(stepped.drawn));
        stepped.loop.request();
        stepped.animationFrame();
        expect(order).toEqual([0]);
    });

    it('draws what changes at the start of a frame in that frame, and no other for it', () => {
        const stepped = steppedLoop();
        stepped.loop.beforeFrame(() => stepped.loop.request());
        stepped.loop.request();
        for (let i = 0; i < 3; ++i) {
            stepped.animationFrame();
            stepped.gpuFinishes();
        }
        expect(stepped.drawn).toBe(1);
    });

    it('goes on for as long as what is done at the start of a frame asks for the next', () => {
        const stepped = steppedLoop();
        stepped.loop.beforeFrame(() => stepped.drawn < 3 && stepped.loop.requestNext());
        stepped.loop.request();
        for (let i = 0; i < 6; ++i) {
            stepped.animationFrame();
            stepped.gpuFinishes();
        }
        expect(stepped.changes).toEqual([true, true, true, true]);
    });

    it('tells a better picture of the same from one of a change, which goes first', () => {
        const stepped = steppedLoop();
        const frame = (): void => {
            stepped.animationFrame();
            stepped.gpuFinishes();
        };
        stepped.loop.requestBetter();
        frame();
        stepped.loop.requestBetter();
        stepped.loop.request();
        frame();
        stepped.loop.requestBetter();
        frame();
        expect(stepped.changes).toEqual([false, true, false]);
    });
});
