// The flow texture of a body, switched on in the panel and looked at pixel by pixel: its grain lies along the velocity's part in the
// wall, goes with the flow while the clock does, and stands while that stands.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { finalSurface, newContext, openPage } from './support/browser_page.ts';
import { degreesOff, type Ground, lightAround, momentsAround, places, shiftRatio } from './support/grain.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig(['flow:sphere']);
const label = 'Show the flow along the body';

/** A page on a dataset, with what is in the look of its body. */
async function open(dataset: string): Promise<{ page: Page; session: string }> {
    const { session } = (await rig.server.call('session.create', { name: dataset })) as { session: string };
    const link = `${rig.server.link}&session=${session}&dataset=${dataset}`;
    const page = await openPage(await newContext(rig.browser, { width: 1100, height: 760 }), link);
    await finalSurface(page);
    await page.getByRole('tab', { name: 'Look' }).click();
    await page.locator('#body-group summary').click();
    return { page, session };
}

async function textured(page: Page, on: boolean): Promise<void> {
    await page.getByLabel(label).setChecked(on);
    await page.waitForFunction((wanted) => window.wakesurf!.bodyVertices(1).some(({ flow }) => flow !== null) === wanted, on);
}

describe('the flow texture of a body', () => {
    it('has its grain along the flow within 5 degrees on at least 95 % of what is seen, and is in the link', async () => {
        const { page, session } = await open('sphere');
        // What is in the way of the body.
        const { rakes } = (await rig.server.call('rake.list', { session })) as { rakes: { rake: string }[] };
        for (const { rake } of rakes) await rig.server.call('rake.delete', { session, rake });
        await page.waitForFunction(() => window.wakesurf!.allDisplayed.length === 0);
        const ground: Ground = { of: 'body', near: 0.02, across: 0.08 };
        await textured(page, true);
        const off: number[] = [];
        // From the side, and from ahead, where the flow meets the sphere and stands still.
        for (const eye of [
            [0.2, -1.5, 0.4],
            [-1.1, -1.1, 0.4],
        ] as [number, number, number][]) {
            await page.evaluate((at) => window.wakesurf!.setCamera(at, [0, 0, 0]), eye);
            const around = await places(page, 1, ground);
            off.push(...degreesOff(around, [(await momentsAround(page, around)).moments]));
        }
        expect(off.length).toBeGreaterThan(500);
        expect(off.filter((angle) => angle <= 5).length / off.length).toBeGreaterThanOrEqual(0.95);
        // The address has had time to follow.
        await page.reload();
        await page.waitForFunction(() => window.wakesurf?.bodyVertices(1).some(({ flow }) => flow !== null) === true);
    }, 120_000);

    it('goes with the flow while the time goes on, and stands while that stands', async () => {
        const { page, session } = await open('sqcyl');
        await page.getByRole('tab', { name: 'Flow' }).click();
        await page.getByRole('radio', { name: 'Path' }).check();
        await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
        await finalSurface(page);
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#body-group summary').click();
        await page.evaluate(() => window.wakesurf!.setCamera([-1.5, -4, 3.4], [0, 0, 3]));
        const shownAt = async (time: number): Promise<void> => {
            await rig.server.call('time.set', { session, time });
            await page.waitForFunction((at) => Math.abs(window.wakesurf!.displayed!.time - at) < 1e-6, time);
            await page.waitForFunction(() => window.wakesurf!.unfinished(null) === '');
        };
        await textured(page, true);
        await shownAt(13);
        const ground: Ground = { of: 'body', near: 0.05, across: 0.3 };
        const around = (await places(page, 1, ground)).filter(({ speed }) => speed > 10).slice(0, 300);
        expect(around.length).toBeGreaterThan(30);
        await textured(page, false);
        const plain = await lightAround(page, around);
        await textured(page, true);
        const before = await lightAround(page, around);
        expect(await lightAround(page, around)).toEqual(before);
        // Some four pixels, an eighth of a wave.
        const passed = 4 / (around.reduce((sum, { speed }) => sum + speed, 0) / around.length);
        await shownAt(13 + passed);
        const gone = shiftRatio(around, plain, [before, await lightAround(page, around)], passed);
        expect(gone).toBeGreaterThan(0.65);
        expect(gone).toBeLessThan(1.1);
        await page.getByRole('button', { name: 'Play' }).click();
        await page.waitForFunction((from) => window.wakesurf!.displayed!.time > from + 0.5, 13 + passed);
        await page.getByRole('button', { name: 'Pause' }).click();
        await page.waitForFunction(() => window.wakesurf!.phase === 'final' && window.wakesurf!.unfinished(null) === '');
        const later = await lightAround(page, around);
        expect(later).not.toEqual(before);
        expect(await lightAround(page, around)).toEqual(later);
    }, 120_000);
});
