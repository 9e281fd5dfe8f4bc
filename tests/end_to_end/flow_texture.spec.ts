// The flow texture of surfaces, looked at pixel by pixel: its grain lies along the velocity's part in the surface. How it goes with that is looked
// at on flat sheets (flow_grain) and on a body.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { finalSurface } from './support/browser_page.ts';
import { degreesOff, type Ground, momentsAround, places } from './support/grain.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const ground: Ground = { of: 'surface', near: 0.05, across: 0.6 };
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1100, height: 760 });
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    await finalSurface(page);
    await page.evaluate(() => window.wakesurf!.setCamera([3, -12, 6], [2, 0, 2.8]));
    await page.getByRole('tab', { name: 'Look' }).click();
    await page.getByLabel('Colour by').selectOption('constant');
    await page.locator('#lines-group summary').click();
});

/** Switches the texture on, and tells how far its grain is off the flow, of several sizes of grain, which are different noise. */
async function grainOff(every: number): Promise<number[]> {
    await page.getByLabel('Flow texture').check();
    await page.waitForFunction(() => window.wakesurf!.vertices(50).some(({ flow }) => flow !== null));
    await finalSurface(page);
    const around = await places(page, every, ground);
    await page.getByLabel('Flow texture').uncheck();
    await finalSurface(page);
    const { light } = await momentsAround(page, around);
    await page.getByLabel('Flow texture').check();
    const pictures = [];
    for (const power of [-1, -0.5, 0, 0.5]) {
        await page.locator('#density').fill(String(power));
        await finalSurface(page);
        pictures.push((await momentsAround(page, around, light)).moments);
    }
    return degreesOff(around, pictures);
}

describe('the flow texture of a streak surface', () => {
    it('has its grain along the flow within 5 degrees on at least 95 % of the surface', async () => {
        const off = await grainOff(4);
        expect(off.length).toBeGreaterThan(100);
        expect(off.filter((angle) => angle <= 5).length / off.length).toBeGreaterThanOrEqual(0.95);
    });
});
