// What the page says about itself: where time goes, how good a surface is, how far it has come; a first visit; a slow network.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { ask, finalSurface, screenshot } from './support/browser_page.ts';
import { dragHandle } from './support/rake_drag.ts';
import { expectServersMesh, serverStats } from './support/server_mesh.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const size = { width: 900, height: 600 };

/** The number in front of a unit. */
async function numberIn(page: Page, selector: string): Promise<number> {
    return Number.parseFloat(((await page.locator(selector).textContent()) ?? '').replaceAll(/[\s\u202f]/g, ''));
}

describe('a first visit', () => {
    it('is led from the rake to sharing, by doing what the tour says', async () => {
        const page = await stand.visit({ ...size, firstVisit: true });
        const step = (): Promise<string | null> => page.getByRole('region', { name: 'Tour' }).getAttribute('data-step');
        expect(await step()).toBe('drag');
        await screenshot(page, 'tour');
        await dragHandle(page, 0, 14, 6, 4);
        await expect.poll(step).toBe('turn');
        await page.mouse.move(500, 300);
        await page.mouse.down();
        await page.mouse.move(520, 310, { steps: 3 });
        await page.mouse.up();
        await expect.poll(step).toBe('streak');
        await page.getByRole('radio', { name: 'Streak' }).click();
        await expect.poll(step).toBe('play');
        await finalSurface(page);
        await page.getByRole('button', { name: 'Play' }).click();
        await expect.poll(step).toBe('look');
        await page.getByRole('button', { name: 'Pause' }).click();
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.getByText('Cividis').click();
        await expect.poll(step).toBe('share');
        await page.getByRole('button', { name: 'Done' }).click();
        expect(await page.getByRole('region', { name: 'Tour' }).count()).toBe(0);

        const again = await stand.open(page, page.url());
        expect(await again.getByRole('region', { name: 'Tour' }).count()).toBe(0);
        await again.keyboard.press('?');
        await again.getByRole('button', { name: 'Show the tour' }).click();
        expect(await again.getByRole('region', { name: 'Tour' }).getAttribute('data-step')).toBe('drag');
        await again.close();
    });
});

describe('numbers about the surface', () => {
    it('are the server’s, on demand', async () => {
        const page = await stand.visit(size);
        await page.getByText('Quality', { exact: true }).click();
        const stats = await serverStats(stand.server, page);
        const share = (100 * stats.approximated) / stats.vertices;
        await expect.poll(() => numberIn(page, '[data-name=approximated]')).toBeCloseTo(share, 0);
        // Why curves ended, each as often as the server has it; those that never came are left out.
        const reasons = ['time', 'domain', 'obstacle'] as const;
        const ended = reasons.filter((reason) => stats.terminated[reason] > 0);
        expect(ended.length).toBeGreaterThan(0);
        const shown = page.locator('[data-name]').evaluateAll((rows) => rows.map((row) => row.getAttribute('data-name')));
        expect((await shown).filter((name) => reasons.some((reason) => reason === name))).toEqual(ended);
        for (const reason of ended) {
            expect(await numberIn(page, `[data-name=${reason}]`)).toBe(stats.terminated[reason]);
        }
        expect(await numberIn(page, '[data-name=vertexSteps]')).toBe(stats.vertexSteps);
        await screenshot(page, 'quality');
    });
});

describe('a surface that takes long', () => {
    it('shows how far it is, and can be stopped and computed again', async () => {
        const page = await stand.visit(size);
        const session = await ask(page, (hook) => hook.session);
        const { surfaces } = await stand.server.call('surface.list', { session });
        const { rev: _rev, epoch: _epoch, ...record } = (surfaces as Record<string, unknown>[])[0]!;
        const fine = { ...record, separation: 0.004, maxQuads: 4_000_000, session };
        const { epoch } = await stand.server.call('surface.set', fine);
        const bar = page.getByRole('progressbar', { name: 'Surface' });
        await bar.waitFor();
        await expect.poll(async () => Number(await bar.getAttribute('value'))).toBeGreaterThan(0);
        await screenshot(page, 'progress');
        await page.getByRole('button', { name: 'Stop', exact: true }).click();
        await page.getByText('Stopped before it was final').waitFor();
        await page.getByText(/stopped by guest 1/).waitFor();
        const stats = await stand.server.call('surface.stats', { session, surface: record['surface'] });
        expect(stats).toMatchObject({ epoch, complete: false, error: { kind: 'cancelled' } });
        // What was there by then stays on the screen.
        expect((await ask(page, (hook) => hook.displayed!.cells)) > 100).toBe(true);
        await screenshot(page, 'stopped');

        await page.getByRole('button', { name: 'Compute it again' }).click();
        await bar.waitFor();
        await stand.server.call('surface.set', { ...record, session });
        await expectServersMesh(stand.server, page);
        await expect.poll(() => bar.count()).toBe(0);
    });
});

describe('on a slow network', () => {
    it('says where the time goes, follows the pointer all the same, and ends with the server’s mesh', async () => {
        const page = await stand.visit({ ...size, link: await stand.networkLink() });
        stand.network.delay(60);
        await page.locator('#latency summary').click();
        // dragHandle checks that the handle is under the pointer after every step.
        await dragHandle(page, 1, 25, -10, 5);
        await expectServersMesh(stand.server, page);
        const sample = await ask(page, (hook) => hook.latencySamples.at(-1)!);
        expect(sample.milliseconds).toBeGreaterThan(120);
        const sum = Object.values(sample.parts).reduce((a, b) => a + b);
        expect(sum).toBeGreaterThanOrEqual(sample.milliseconds * 0.999);
        // The next ping knows how far away the server is.
        await page.waitForFunction(() => (window.wakesurf?.roundTripMs ?? 0) > 115);
        await dragHandle(page, 1, -25, 10, 5);
        await expectServersMesh(stand.server, page);
        expect(await numberIn(page, '[data-part=network]')).toBeGreaterThan(115);
        expect(await numberIn(page, '#latency-total')).toBeGreaterThan(120);
        await screenshot(page, 'latency');
    });
});
