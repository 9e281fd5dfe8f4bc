import { describe, expect, it } from 'vitest';
import { FrameLoop } from './frameLoop.ts';

/** A loop whose animation frames and GPU come when the test says so. */
function steppedLoop() {
    const scheduled: (() => void)[] = [];
    const finishing: (() => void)[] = [];
    let drawn = 0;
    const loop = new FrameLoop(
        (finished) => {
            ++drawn;
            finishing.push(finished);
        },
        (callback) => scheduled.push(callback),
    );
    return {
        loop,
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
});
