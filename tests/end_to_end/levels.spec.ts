// A level set from the panel: its field is chosen, its level dragged and typed, and what is shown has that value at every vertex.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SurfaceRecord, SurfaceStats } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 780, height: 560 });
});

async function record(): Promise<SurfaceRecord> {
    const session = await ask(page, (hook) => hook.session);
    const { surfaces } = (await rig.server.call('surface.list', {
        session,
    })) as { surfaces: SurfaceRecord[] };
    return surfaces[0]!;
}

/** The record once what was edited is on the screen. */
async function edited(edit: () => Promise<unknown>): Promise<SurfaceRecord> {
    const before = await ask(page, (hook) => hook.displayed?.epoch ?? 0);
    await edit();
    await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before);
    await finalSurface(page);
    return await record();
}

/** Of what is drawn, how far its speed is from a level in the mean: between nodes the speed of a mean is not the mean of speeds. */
async function offLevel(level: number): Promise<number> {
    const off = (await ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar))).map((scalar) =>
        Math.abs(scalar - level),
    );
    return off.reduce((sum, each) => sum + each, 0) / off.length;
}

describe('a level set', () => {
    it('is dragged over the range of its field, typed, shown at the time of the clock, and there after a reload', async () => {
        const first = await edited(() => page.getByRole('radio', { name: 'Level set' }).check());
        expect(first).toMatchObject({
            kind: 'level',
            field: 'U',
            from: 8.5,
            to: 16,
        });
        const range = page.locator('#level-range');
        await range.waitFor();
        const session = await ask(page, (hook) => hook.session);
        const stats = (await rig.server.call('surface.stats', {
            session,
            surface: first.surface,
        })) as unknown as SurfaceStats;
        const [low, high] = stats.fieldRange!;
        expect(low).toBeLessThan(first.level!);
        expect(high).toBeGreaterThan(first.level!);

        // With the mouse, along the slider: the newest level wins.
        const slider = page.getByRole('slider', { name: 'Level' });
        await slider.scrollIntoViewIfNeeded();
        const box = (await slider.boundingBox())!;
        const at = (part: number): [number, number] => [box.x + part * box.width, box.y + box.height / 2];
        const dragged = await edited(async () => {
            await page.mouse.move(...at(0.5));
            await page.mouse.down();
            for (let i = 0; i <= 10; ++i) await page.mouse.move(...at(0.5 + 0.015 * i));
            await page.mouse.up();
        });
        expect(dragged.level).toBeGreaterThan(low + 0.6 * (high - low));
        expect(dragged.level).toBeLessThan(low + 0.7 * (high - low));
        await expect.poll(() => offLevel(dragged.level!)).toBeLessThan(0.01);
        expect(await slider.inputValue()).toBe(String(dragged.level));

        const typed = await edited(async () => {
            await page.getByRole('textbox', { name: 'Level' }).fill('0.6');
            await page.keyboard.press('Enter');
        });
        expect(typed.level).toBe(0.6);
        const ends = await ask(page, (hook) => hook.displayed!.stateSum);
        await rig.server.call('time.set', { session, time: 10 });
        await page.waitForFunction(() => window.wakesurf?.displayed?.time === 10);
        expect(await ask(page, (hook) => hook.displayed!.stateSum)).not.toBe(ends);

        await page.reload();
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.displayed!.time)).toBe(10);
        expect(await offLevel(0.6)).toBeLessThan(0.01);
    });
});
