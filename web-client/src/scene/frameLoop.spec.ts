import { beforeEach, describe, expect, it } from 'vitest';
import {
    FrameLoop,
    leastRatio,
    limitMs,
    sparingMs,
    Movement,
    MovingResolution,
    restMs,
    Stillness,
    type Timers,
} from './frameLoop.ts';

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

describe('movement', () => {
    let movement: Movement;

    beforeEach(() => {
        movement = new Movement();
    });

    it('is not what one picture alone shows, but what one shows that follows closely', () => {
        expect(movement.at(0)).toBe(false);
        movement.drawn(1000);
        expect(movement.at(1000 + restMs - 1)).toBe(true);
        expect(movement.at(1000 + restMs)).toBe(false);
    });

    it('begins with the first push, before any picture', () => {
        movement.stir(5000);
        expect(movement.at(5001)).toBe(true);
        expect(movement.at(5000 + restMs)).toBe(false);
    });

    it('is what surfaces do that change more than once a second, and not one change alone', () => {
        movement.surfaceChanged(0);
        expect(movement.at(1)).toBe(false);
        movement.surfaceChanged(900);
        expect(movement.at(901)).toBe(true);
        movement.surfaceChanged(3000);
        expect(movement.at(3001)).toBe(false);
    });

    it('lasts as long as something is held', () => {
        movement.hold(true);
        expect(movement.at(1e6)).toBe(true);
        movement.hold(false);
        expect(movement.at(1e6)).toBe(false);
    });
});

/** Draws on graphics that take so long for the picture, and so long for a whole pixel of CSS; ratios as they
 *  come. */
function drawOn(resolution: MovingResolution, pictures: number, fixedMs: number, msPerPixel: number): number[] {
    return Array.from({ length: pictures }, () => {
        const { ratio } = resolution;
        resolution.drawn(fixedMs + msPerPixel * ratio ** 2);
        return ratio;
    });
}

describe('the resolution while things move', () => {
    it('stays full where pictures are quick', () => {
        const ratios = drawOn(new MovingResolution(2, 2), 100, 4, 3);
        expect(new Set(ratios)).toEqual(new Set([2]));
    });

    it('becomes the highest at which a picture keeps the limit, within a second of slow ones', () => {
        const ratios = drawOn(new MovingResolution(1, 1), 40, 10, 100);
        // 10 + 100 / 4 = 35 ms; at half of the pixels it would be 60 ms.
        expect(ratios.slice(6)).toEqual(Array(34).fill(0.5));
        expect(10 + 100 * ratios.at(-1)! ** 2).toBeLessThan(limitMs);
    });

    it('never falls below the least, however slow pictures are', () => {
        for (const full of [1, 1.5, 2]) {
            const ratios = drawOn(new MovingResolution(full, full), 200, 900, 900);
            expect(Math.min(...ratios)).toBeGreaterThanOrEqual(leastRatio);
            expect(ratios.at(-1)).toBeLessThan(1.5 * leastRatio);
        }
        expect(new MovingResolution(0.3, 0.3).ratio).toBe(0.3);
    });

    it('comes back where pictures have become quick, and does not go to and fro at any speed', () => {
        const resolution = new MovingResolution(1, 1);
        drawOn(resolution, 40, 300, 0);
        expect(drawOn(resolution, 60, 2, 10).at(-1)).toBe(1);
        for (let msPerPixel = 1; msPerPixel < 1000; msPerPixel *= 1.13) {
            const ratios = drawOn(new MovingResolution(1, 0.5), 400, 8, msPerPixel).slice(60);
            expect(new Set(ratios).size, `${msPerPixel} ms`).toBe(1);
        }
    });

    it('does not mind a late picture now and then', () => {
        const resolution = new MovingResolution(1, 1);
        for (let i = 0; i < 300; ++i) resolution.drawn(i % 3 === 0 ? 400 : 30);
        expect(resolution.ratio).toBe(1);
    });

    it('seldom tries to draw all again where less is quick and all is not, and does so once that is quick', () => {
        const resolution = new MovingResolution(1, 1);
        let changes = 0;
        const draw = (pictures: number, allMs: number): void => {
            for (let i = 0; i < pictures; ++i) {
                const before = resolution.sparing;
                resolution.drawn(before ? 30 : allMs);
                if (resolution.sparing !== before) ++changes;
            }
        };
        draw(1000, 2 * sparingMs);
        expect(changes).toBeLessThan(16);
        draw(1100, 30);
        expect(resolution.sparing).toBe(false);
    });

    it('draws less where the fewest pixels take too long, until they take half as long, and not to and fro between', () => {
        const resolution = new MovingResolution(1, 1);
        const sparing = (ms: number, count = 12): boolean => {
            for (let i = 0; i < count; ++i) resolution.drawn(ms);
            return resolution.sparing;
        };
        expect([sparing(sparingMs + 20, 9), resolution.ratio < 1.5 * leastRatio], 'first fewer pixels').toEqual([false, true]);
        expect(sparing(sparingMs - 20)).toBe(false);
        expect(sparing(sparingMs + 20)).toBe(true);
        expect(sparing(0.6 * sparingMs)).toBe(true);
        expect([sparing(0.4 * sparingMs), sparing(0.9 * sparingMs)]).toEqual([false, false]);
        expect([sparing(5, 100), resolution.ratio], 'quick again').toEqual([false, 1]);
    });

    it('begins where it is told to', () => {
        expect(new MovingResolution(1, 0.5).ratio).toBe(0.5);
        expect(new MovingResolution(2, 2).ratio).toBe(2);
    });
});

class Clock implements Timers {
    now = 0;
    private readonly waiting = new Map<number, { at: number; act: () => void }>();
    private count = 0;

    set(act: () => void, ms: number): number {
        this.waiting.set(++this.count, { at: this.now + ms, act });
        return this.count;
    }

    clear(timer: unknown): void {
        this.waiting.delete(timer as number);
    }

    pass(ms: number): void {
        this.now += ms;
        for (const [timer, { at, act }] of [...this.waiting]) {
            if (at > this.now) continue;
            this.waiting.delete(timer);
            act();
        }
    }
}

describe('stillness', () => {
    let clock: Clock;
    let reached: number;
    let stillness: Stillness;

    beforeEach(() => {
        clock = new Clock();
        reached = 0;
        stillness = new Stillness(() => ++reached, 300, clock);
    });

    it('is reached once, 300 ms after the last picture', () => {
        for (let i = 0; i < 10; ++i) {
            stillness.drawn(true);
            clock.pass(299);
        }
        expect(reached).toBe(0);
        clock.pass(1);
        expect(reached).toBe(1);
        clock.pass(10_000);
        expect(reached).toBe(1);
    });

    it('takes longer where that is asked for, and as long as ever after that', () => {
        stillness.drawn(true, 900);
        clock.pass(899);
        expect(reached).toBe(0);
        clock.pass(1);
        expect(reached).toBe(1);
        stillness.drawn(true);
        clock.pass(300);
        expect(reached).toBe(2);
    });

    it('is not waited for after a picture that cannot be better', () => {
        stillness.drawn(true);
        clock.pass(100);
        stillness.drawn(false);
        clock.pass(10_000);
        expect(reached).toBe(0);
    });

    it('is not reached while something is held, however long the hand rests, but 300 ms after it is let go', () => {
        stillness.drawn(true);
        clock.pass(200);
        stillness.hold(true);
        clock.pass(10_000);
        stillness.drawn(true);
        clock.pass(10_000);
        stillness.hold(false);
        clock.pass(299);
        expect(reached).toBe(0);
        clock.pass(1);
        expect(reached).toBe(1);
    });

    it('is not reached again by a press that draws nothing', () => {
        stillness.drawn(false);
        stillness.hold(true);
        stillness.hold(false);
        clock.pass(10_000);
        expect(reached).toBe(0);
    });
});
