// Two pictures side by side: linked, each of its own data, time and settings; and the page as it was once they end.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { pixelsOfPng } from './support/png_pixels.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig(['flow:tornado']);
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1280, height: 760 });
    await finalSurface(page);
});

type Side = 'wakesurf' | 'wakesurfBeside';

/** As far as one can see. */
async function cameraOf(side: Side): Promise<number[]> {
    const { position } = await page.evaluate((name) => window[name]!.camera, side);
    return position.map((each) => Number(each.toFixed(4)));
}
const timeOf = (side: Side): Promise<number | undefined> => page.evaluate((name) => window[name]!.displayed?.time, side);

/** Both pictures have all that they show. */
async function bothDrawn(): Promise<void> {
    await page.waitForFunction(() => {
        const { wakesurf, wakesurfBeside } = window;
        return wakesurf?.unfinished(null) === '' && wakesurfBeside?.unfinished(null) === '';
    });
}

async function drag(canvas: 'left' | 'right', by: number): Promise<void> {
    const box = (await page
        .locator('canvas[role="img"]')
        .nth(canvas === 'left' ? 0 : 1)
        .boundingBox())!;
    const [x, y] = [box.x + box.width * 0.6, box.y + box.height * 0.12];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 6; ++i) await page.mouse.move(x + (by * i) / 6, y);
    await page.mouse.up();
}

async function sessions(): Promise<string[]> {
    const { sessions: all } = (await rig.server.call('session.list', {})) as { sessions: { session: string; name: string }[] };
    return all.filter(({ name }) => name.endsWith('(compared)')).map(({ session }) => session);
}

describe('two pictures side by side', () => {
    it('turn together, whichever is dragged', async () => {
        const before = await cameraOf('wakesurf');
        await page.getByRole('button', { name: 'Side by side' }).click();
        await page.locator('#right-shows').getByText(/sqcyl/).waitFor();
        await bothDrawn();
        expect(await sessions()).toHaveLength(1);
        await drag('right', 90);
        const turned = await cameraOf('wakesurf');
        expect(turned).not.toEqual(before);
        expect(await cameraOf('wakesurfBeside')).toEqual(turned);
        await drag('left', -60);
        expect(await cameraOf('wakesurf')).not.toEqual(turned);
        await expect.poll(() => cameraOf('wakesurfBeside')).toEqual(await cameraOf('wakesurf'));
    }, 120_000);

    it('show a time of their own, and say so', async () => {
        await page.locator('#compare-time').selectOption('at');
        const field = page.getByLabel('Time at');
        await field.fill('10');
        await field.press('Enter');
        await page.locator('#right-shows').getByText('t = 10').waitFor();
        await bothDrawn();
        expect(await timeOf('wakesurfBeside')).toBe(10);
        expect(await timeOf('wakesurf')).not.toBe(10);
        await page.locator('#compare-time').selectOption('same');
        await expect.poll(() => timeOf('wakesurfBeside')).toBe(await timeOf('wakesurf'));
    }, 120_000);

    it('are saved as one picture', async () => {
        await page.getByRole('tab', { name: 'Export' }).click();
        const download = page.waitForEvent('download');
        await page.locator('#save-picture').click();
        const png = readFileSync(await (await download).path());
        const { width, height } = await pixelsOfPng(page, png, []);
        for (const part of [0.25, 0.75]) {
            const column = Array.from({ length: 60 }, (_, i) => ({ x: width * part, y: (height * (i + 0.5)) / 60 }));
            const { at } = await pixelsOfPng(page, png, column);
            expect(new Set(at.map((pixel) => pixel.join())).size, `colours at ${part} of the width`).toBeGreaterThan(10);
        }
    }, 120_000);

    it('have settings of their own in the panel, of the half that is clicked', async () => {
        await page.getByRole('tab', { name: 'Flow' }).click();
        const settings = (name: string): Promise<void> => page.getByRole('complementary', { name, exact: true }).waitFor();
        await page.locator('#choose-right').click();
        await settings('Settings of the right half');
        const pictures = page.locator('canvas[role="img"]');
        await pictures.first().click({ position: { x: 20, y: 300 } });
        await settings('Settings');
        await pictures.last().click({ position: { x: 20, y: 300 } });
        await settings('Settings of the right half');
        await page.locator('#choose-left').click();
        await settings('Settings');
    });

    it('show other data', async () => {
        await page.locator('#compare-data').selectOption('tornado');
        await page
            .locator('#right-shows')
            .getByText(/tornado/)
            .waitFor();
        await expect.poll(sessions).toHaveLength(1);
        await page.getByRole('button', { name: 'Side by side' }).waitFor();
    }, 120_000);

    it('end with their session, and leave one picture', async () => {
        await page.locator('#end-compare').click();
        await page.locator('wakesurf-compare-bar').waitFor({ state: 'detached' });
        expect(await page.locator('canvas[role="img"]').count()).toBe(1);
        await expect.poll(sessions).toEqual([]);
        const { sessions: trash } = (await rig.server.call('session.list', { trash: true })) as { sessions: { name: string }[] };
        expect(trash.filter(({ name }) => name.endsWith('(compared)'))).toEqual([]);
        expect(await ask(page, (hook) => hook.session)).not.toBeNull();
        await finalSurface(page);
    }, 60_000);

    it('end with the page: a reload shows the left one alone', async () => {
        await page.getByRole('button', { name: 'Side by side' }).click();
        await page.locator('#right-shows').getByText(/sqcyl/).waitFor();
        await page.reload();
        await finalSurface(page);
        expect(await page.locator('canvas[role="img"]').count()).toBe(1);
        await expect.poll(sessions).toEqual([]);
    }, 120_000);
});
