// Every kind of surface from the panel: what a person chooses is what the server builds and the page shows. What the panel asks for
// is tested beside it.
import type { BrowserContext, Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage, screenshot } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
let context: BrowserContext;
let page: Page;

beforeEach(async () => {
    context = await newContext(stand.browser, { width: 860, height: 700 });
    page = await openPage(context, await stand.server.newSession());
    await finalSurface(page);
});

afterEach(async () => {
    await context.close();
});

/** The record after an edit has reached the screen. */
/** @param cells  the least of the surface then */
async function edited(edit: () => Promise<unknown>, cells = 100): Promise<SurfaceRecord> {
    const before = await ask(page, (hook) => hook.displayed?.epoch ?? 0);
    await edit();
    await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before);
    await finalSurface(page);
    const session = await ask(page, (hook) => hook.session);
    const { surfaces } = (await stand.server.call('surface.list', { session })) as { surfaces: SurfaceRecord[] };
    expect(await ask(page, (hook) => hook.displayed?.cells ?? 0)).toBeGreaterThan(cells);
    return surfaces[0]!;
}

describe('the kinds of surface', () => {
    it('are all shown at the time of the picture, with at least half of each downstream of the front of the body', async () => {
        for (const kind of ['Stream', 'Path', 'Streak', 'Time']) {
            if (kind !== 'Stream') await edited(() => page.getByRole('radio', { name: kind }).check());
            expect(await ask(page, (hook) => hook.displayed!.time)).toBe(16);
            expect(await page.locator('#surface-remark').isVisible()).toBe(false);
            const xs = (await ask(page, (hook) => hook.vertices(1))).map(({ point }) => point[0]);
            expect(xs.filter((x) => x > -0.5).length / xs.length).toBeGreaterThan(0.5);
            await screenshot(page, `first-${kind.toLowerCase()}`);
        }
    });

    it('goes back in time as the direction says, released where the data have time for it, and stays so after a reload', async () => {
        const direction = page.getByRole('combobox', { name: 'Direction' });
        const stream = await edited(() => direction.selectOption('backward'));
        expect(stream).toMatchObject({ kind: 'stream', direction: 'backward', from: 16 });
        expect(stream.to).toBeLessThan(16);
        const streak = await edited(() => page.getByRole('radio', { name: 'Streak' }).check());
        expect(streak).toMatchObject({ kind: 'streak', direction: 'backward', from: 16, to: 8.5 });
        await page.getByText(/^Shown at 8.5 now, no longer at 16:/).waitFor();
        await page.getByText('t = 8.5', { exact: true }).waitFor();
        await screenshot(page, 'streak-backward');
        await page.reload();
        await finalSurface(page);
        expect(await page.getByRole('radio', { name: 'Streak' }).isChecked()).toBe(true);
        expect(await direction.inputValue()).toBe('backward');
    });
});
