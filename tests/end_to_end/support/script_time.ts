// How much script a page runs for each move of the pointer over its picture, and for each animation frame: listeners and
// callbacks are timed from outside, so that the page itself need not measure.
import type { BrowserContext, Page } from 'playwright-core';

declare global {
    interface Window {
        scriptTimes: { moves: Record<number, number>; frames: number[] };
    }
}

export async function timeScripts(context: BrowserContext): Promise<void> {
    await context.addInitScript(() => {
        window.scriptTimes = { moves: {}, frames: [] };
        const listen = EventTarget.prototype.addEventListener;
        EventTarget.prototype.addEventListener = function (this: EventTarget, type, listener, options) {
            const timed = type === 'pointermove' && typeof listener === 'function' && this instanceof HTMLCanvasElement;
            if (!timed) {
                listen.call(this, type, listener, options);
                return;
            }
            const call = (event: Event): void => {
                const start = performance.now();
                listener.call(this, event);
                const { moves } = window.scriptTimes;
                moves[event.timeStamp] = (moves[event.timeStamp] ?? 0) + performance.now() - start;
            };
            listen.call(this, type, call, options);
        };
        const request = window.requestAnimationFrame.bind(window);
        window.requestAnimationFrame = (callback) =>
            request((time) => {
                const start = performance.now();
                callback(time);
                window.scriptTimes.frames.push(performance.now() - start);
            });
    });
}

/** Milliseconds, shortest first, since the last time they were taken. */
export async function takeScriptTimes(page: Page): Promise<{ moves: number[]; frames: number[] }> {
    const taken = await page.evaluate(() => {
        const { moves, frames } = window.scriptTimes;
        window.scriptTimes = { moves: {}, frames: [] };
        return { moves: Object.values(moves), frames };
    });
    for (const times of [taken.moves, taken.frames]) times.sort((a, b) => a - b);
    return taken;
}
