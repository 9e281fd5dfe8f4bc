// Slices from the panel: a plane is added, moved and taken back, its values are drawn, and those who come later see the same.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SliceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1100, height: 760 });
    await finalSurface(page);
});

async function records(): Promise<SliceRecord[]> {
    const session = await ask(page, (hook) => hook.session);
    return ((await rig.server.call('slice.list', { session })) as { slices: SliceRecord[] }).slices;
}

/** All slices are as fine as the screen. */
async function drawn(): Promise<void> {
    await page.waitForFunction(() => window.wakesurf?.unfinished(null) === '');
}

describe('a slice', () => {
    it('is added across an axis, is coloured and named by its field, moves with the slider, and is taken back by one undo', async () => {
        await page.getByRole('button', { name: 'New slice' }).click();
        await page.locator('#slice-z').click();
        await drawn();
        const [first] = await records();
        expect(first).toMatchObject({ field: 'U', normal: [0, 0, 1] });
        const bar = page.locator('wakesurf-scalar-bar');
        await bar.getByRole('figure').nth(1).waitFor();
        await page.locator('#slice-field').selectOption('vorticity_z');
        await bar.getByRole('figure', { name: /Vorticity z/ }).waitFor();
        const slider = page.locator('#slice-offset');
        await slider.scrollIntoViewIfNeeded();
        const { x, y, width, height } = (await slider.boundingBox())!;
        await page.mouse.move(x + width / 2, y + height / 2);
        await page.mouse.down();
        for (let i = 0; i < 12; ++i) await page.mouse.move(x + width * (0.5 - 0.02 * i), y + height / 2);
        await page.mouse.up();
        await drawn();
        const [moved] = await records();
        expect(moved!.origin[2]).toBeLessThan(first!.origin[2] - 0.5);
        await page.keyboard.press('Control+z');
        await expect.poll(async () => (await records())[0]!.origin[2]).toBe(first!.origin[2]);
    }, 120_000);

    it('is dragged by its handle in the picture, as one act, and shows arrows of the flow in it', async () => {
        const [before] = await records();
        const handle = await page.evaluate((z) => {
            const [x0, x1, y0, y1] = window.wakesurf!.bounds!;
            return window.wakesurf!.project([(x0! + x1!) / 2, (y0! + y1!) / 2, z])!;
        }, before!.origin[2]);
        await page.mouse.move(handle.x, handle.y);
        await page.mouse.down();
        for (let i = 1; i <= 12; ++i) await page.mouse.move(handle.x, handle.y - 4 * i);
        await page.locator('.beside-pointer').getByText(/^z = /).waitFor();
        await page.mouse.up();
        await drawn();
        const [moved] = await records();
        expect(moved!.origin[2]).toBeGreaterThan(before!.origin[2] + 0.1);
        expect(moved!.normal).toEqual(before!.normal);
        await page.getByLabel('Arrows of the flow in the plane').check();
        await page.getByText(/^The longest arrow is 1\.\d/).waitFor();
        await page.keyboard.press('Control+z');
        await expect.poll(async () => (await records())[0]!.origin[2]).toBe(before!.origin[2]);
    }, 120_000);

    it('that misses the domain is refused in words, and stays where it was', async () => {
        const [before] = await records();
        const field = page.getByLabel('Origin z');
        await field.fill('99');
        await field.press('Enter');
        await page.getByText('the plane misses the domain by').waitFor();
        expect((await records())[0]!.origin).toEqual(before!.origin);
    }, 60_000);

    it('is there for those who come later', async () => {
        await page.reload();
        await page.getByRole('list', { name: 'In the picture' }).getByText('z =').waitFor();
        await drawn();
        await page
            .locator('wakesurf-scalar-bar')
            .getByRole('figure', { name: /Vorticity z/ })
            .waitFor();
    }, 120_000);
});
