// What a surface says that is not what was asked for: coarser than its separation, or empty.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { finalSurface, screenshot } from './support/browser_page.ts';
import { serverStats } from './support/server_mesh.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const size = { width: 1000, height: 700 };

/** With what the statistics say of its vertices. */
const finished = /^Final, 99 % of vertices within \S+(, \S+ uncertain)?$/;
const status = (page: Page) => page.locator('wakesurf-status').getByRole('status');

async function limitQuads(page: Page, most: number): Promise<void> {
    const field = page.getByRole('spinbutton', { name: 'Quad limit' });
    if (!(await field.isVisible())) await page.getByText('Mesh', { exact: true }).click();
    await field.fill(String(most));
    await page.keyboard.press('Enter');
}

describe('a surface that its quad limit made coarser', () => {
    it('says to what, also after a reload, and is as asked for once the limit is raised', async () => {
        const page = await stand.visit(size);
        expect(await status(page).textContent()).toMatch(finished);
        const limit = Math.floor(0.6 * (await serverStats(stand.server, page)).quads);
        await limitQuads(page, limit);
        await expect.poll(() => status(page).textContent()).toMatch(/^Coarsened to [\d.]+: raise the quad limit$/);
        const stats = await serverStats(stand.server, page);
        expect(stats.coarsened).toBe(true);
        expect(stats.quads).toBeLessThanOrEqual(limit);
        expect(await status(page).textContent()).toContain(`to ${Number(stats.separation.toPrecision(4))}`);
        await screenshot(page, 'coarsened');
        await page.reload();
        await expect.poll(() => status(page).textContent(), { timeout: 30_000 }).toMatch(/^Coarsened to/);
        for (let i = 0; i < 4 && !finished.test((await status(page).textContent()) ?? ''); ++i) {
            await page.getByRole('button', { name: /^Allow / }).click();
            await expect.poll(() => status(page).textContent()).toMatch(/^(Coarsened|Final)/);
        }
        await finalSurface(page);
        expect((await serverStats(stand.server, page)).coarsened).toBe(false);
    });
});

describe('an empty surface', () => {
    it('says why, in the panel and beside its rake, until the rake is moved', async () => {
        const page = await stand.visit(size);
        // Inside the cylinder, whose axis is along z.
        const coordinates = { 'Start x': 0.1, 'Start y': 0.1, 'Start z': 2, 'End x': -0.1, 'End y': -0.1, 'End z': 3 };
        for (const [name, value] of Object.entries(coordinates)) {
            await page.getByRole('spinbutton', { name }).fill(String(value));
            await page.keyboard.press('Enter');
        }
        await expect.poll(() => status(page).textContent(), { timeout: 30_000 }).toBe('Nothing to see');
        await expect
            .poll(() => page.locator('#empty-reason').textContent())
            .toBe('The whole rake lies inside the body: move the rake into the fluid.');
        await page.locator('.rake-label', { hasText: 'the whole rake lies inside the body' }).waitFor();
        await screenshot(page, 'empty');
        await page.getByRole('spinbutton', { name: 'Start x' }).fill('-1.5');
        await page.keyboard.press('Enter');
        await page.getByRole('spinbutton', { name: 'End x' }).fill('-1.5');
        await page.keyboard.press('Enter');
        await expect.poll(() => status(page).textContent(), { timeout: 30_000 }).toMatch(finished);
        await page.locator('.rake-label').waitFor({ state: 'hidden' });
    });
});
