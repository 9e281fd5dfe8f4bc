// How well the page keeps up with a time that moves.
import type { Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
let page: Page;

beforeEach(async () => {
    page = await stand.visit({ width: 900, height: 480 });
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    await finalSurface(page);
});

describe('a streak surface', () => {
    it('is shown whole within three seconds of a scrub', async () => {
        const box = (await page.locator('#clock').boundingBox())!;
        const thumb = 14;
        const x = (time: number): number => box.x + thumb / 2 + ((box.width - thumb) * (time - 8.5)) / 7.5;
        const y = box.y + box.height / 2;
        await page.mouse.move(x(16), y);
        await page.mouse.down();
        await page.mouse.move(x(14), y, { steps: 4 });
        const begun = performance.now();
        await page.mouse.move(x(11), y, { steps: 4 });
        await page.mouse.up();
        await page.waitForFunction(() => Math.abs(window.wakesurf!.displayed!.time - 11) < 0.03);
        await finalSurface(page);
        expect(performance.now() - begun).toBeLessThan(3000);
    });

    it('plays by changes: of 20 updates at most one is whole', async () => {
        await page.locator('#speed').selectOption('0.25');
        await page.locator('#go-to').fill('11');
        await page.keyboard.press('Enter');
        await page.waitForFunction(() => window.wakesurf!.displayed!.time === 11);
        await finalSurface(page);
        await page.getByRole('button', { name: 'Play' }).click();
        await page.waitForFunction(() => window.wakesurf?.phase === 'live');
        const begun = await ask(page, (hook) => hook.displayed!);
        await page.waitForFunction((least) => window.wakesurf!.displayed!.deltas >= least, begun.deltas + 20);
        expect((await ask(page, (hook) => hook.displayed!)).keys - begun.keys).toBeLessThanOrEqual(1);
    });
});
