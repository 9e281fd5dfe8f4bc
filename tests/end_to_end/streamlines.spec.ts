// Streamlines from the panel: they are added, drawn and coloured, follow the clock, are taken back, and those who come later see the same.
import type { Page } from 'playwright-core';
import { beforeAll, expect, it } from 'vitest';
import type { LinesRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1100, height: 760 });
    await finalSurface(page);
});

async function records(): Promise<LinesRecord[]> {
    const session = await ask(page, (hook) => hook.session);
    return ((await rig.server.call('lines.list', { session })) as { lines: LinesRecord[] }).lines;
}

it('streamlines are released from a sphere, named by their field, taken back by one undo, and there for those who come later', async () => {
    await page.getByRole('button', { name: 'New lines' }).click();
    await page.locator('#streamlines-sphere').click();
    await page.getByText('50 lines.').waitFor();
    await page.waitForFunction(() => window.wakesurf?.unfinished(null) === '');
    expect((await records())[0]).toMatchObject({ kind: 'sphere', seeds: 50, field: 'U', direction: 'both' });
    const bar = page.locator('wakesurf-scalar-bar');
    await page.locator('#streamlines-field').selectOption('vorticity_z');
    await bar.getByRole('figure', { name: /Vorticity z/ }).waitFor();
    await page.locator('#streamlines-direction').selectOption('forward');
    await expect.poll(async () => (await records())[0]!.direction).toBe('forward');
    await page.keyboard.press('Control+z');
    await expect.poll(async () => (await records())[0]!.direction).toBe('both');
    await page.reload();
    await page
        .getByRole('button', { name: /50 from a sphere/ })
        .first()
        .waitFor();
    await bar.getByRole('figure', { name: /Vorticity z/ }).waitFor();
}, 120_000);

it('streamlines along the walls are added, and go off into the flow instead where that is chosen', async () => {
    await page.getByRole('button', { name: 'New lines' }).click();
    await page.locator('#streamlines-along').click();
    await page.getByText('200 lines.').waitFor();
    await page
        .getByRole('button', { name: /200 along walls/ })
        .first()
        .waitFor();
    await page.locator('#streamlines-course').selectOption('walls');
    await expect.poll(async () => (await records()).at(-1)).toMatchObject({ kind: 'walls', seeds: 200, patches: [] });
    await page
        .getByRole('button', { name: /200 from .* off the walls/ })
        .first()
        .waitFor();
}, 120_000);
