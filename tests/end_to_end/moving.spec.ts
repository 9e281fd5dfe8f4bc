// While things move the picture has fewer pixels, so that it keeps up; what stands still, and what is saved, has all of them.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { ask } from './support/browser_page.ts';
import { handleIsAt, takeHandle } from './support/rake_drag.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();

const ratio = (page: Page): Promise<number> => ask(page, (hook) => hook.pixelRatio);

/** Until the picture is sharp and stays so: nothing is on its way any more. */
async function atRest(page: Page): Promise<void> {
    await page.waitForFunction(() => window.wakesurf?.phase === 'final' && window.wakesurf.pixelRatio === 1);
}

describe('a picture that moves', () => {
    it('has fewer pixels while a handle is dragged, all of them when the hand rests, and the handle stays under the pointer', async () => {
        // So large that no software draws it in the time that a movement leaves for a picture.
        const page = await rig.visit({ width: 1800, height: 1100 });
        await atRest(page);
        const from = await takeHandle(page, 'middle');
        const ratios: number[] = [];
        for (let i = 1; i <= 6; ++i) {
            const to = { x: from.x + 8 * Math.sin(i), y: from.y + 5 * Math.cos(i) };
            const frames = await ask(page, (hook) => hook.framesDrawn);
            await page.mouse.move(to.x, to.y);
            await page.waitForFunction((count) => window.wakesurf!.framesDrawn > count, frames);
            await handleIsAt(page, 'middle', to);
            ratios.push(await ratio(page));
        }
        expect(Math.min(...ratios)).toBeLessThan(1);
        expect(Math.min(...ratios)).toBeGreaterThanOrEqual(0.35);
        // The button is still down.
        await expect.poll(() => ratio(page)).toBe(1);
        await page.mouse.up();
        await atRest(page);
    });

    it('has fewer pixels from the first turn of the wheel on, and picks and saves as at rest', async () => {
        const page = await rig.visit();
        await atRest(page);
        const size = page.viewportSize()!;
        const middle = { x: (size.width - 304) / 2, y: size.height / 2 };
        await page.mouse.move(middle.x, middle.y);
        const [moving, resting] = await page.evaluate(async ({ x, y }) => {
            const hook = window.wakesurf!;
            const drawn = async (): Promise<void> => {
                const before = hook.framesDrawn;
                while (hook.framesDrawn === before) await new Promise(requestAnimationFrame);
            };
            const facts = () => ({
                ratio: hook.pixelRatio,
                places: [-60, 0, 60].map((dx) => hook.pick({ x: x + dx, y })?.point ?? null),
                figure: [...hook.figure({ width: 480, height: 300 }, 2048)].reduce(
                    (sum, value, i) => (sum + value * (1 + (i % 251))) % 1e9,
                    0,
                ),
            });
            const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!;
            canvas.dispatchEvent(
                new WheelEvent('wheel', { deltaY: -240, clientX: x, clientY: y, bubbles: true, cancelable: true }),
            );
            await drawn();
            const first = facts();
            while (hook.pixelRatio < 1) await drawn();
            return [first, facts()];
        }, middle);
        expect(moving.ratio).toBeLessThan(1);
        expect(moving.places.some((place) => place !== null)).toBe(true);
        expect({ ...moving, ratio: 1 }).toEqual(resting);
    });
});
