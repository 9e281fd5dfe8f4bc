// What a surface says that is empty.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { screenshot } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const size = { width: 1000, height: 700 };

/** With what the statistics say of its vertices. */
const finished = /^Final, 99 % of vertices within \S+(, \S+ uncertain)?$/;
const status = (page: Page) => page.locator('wakesurf-status').getByRole('status');

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
