// Every kind of surface from the panel: what a person chooses is what the server builds and the page shows.
import type { BrowserContext, Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
let context: BrowserContext;
let page: Page;

beforeEach(async () => {
    context = await newContext(stand.browser, { height: 900 });
    page = await openPage(context, await stand.server.newSession());
    await finalSurface(page);
});

afterEach(async () => {
    await context.close();
});

/** The record after an edit has reached the screen. */
async function edited(edit: () => Promise<unknown>): Promise<SurfaceRecord> {
    const before = await ask(page, (hook) => hook.displayed?.epoch ?? 0);
    await edit();
    await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before);
    await finalSurface(page);
    const session = await ask(page, (hook) => hook.session);
    const { surfaces } = (await stand.server.call('surface.list', { session })) as { surfaces: SurfaceRecord[] };
    expect(await ask(page, (hook) => hook.displayed?.cells ?? 0)).toBeGreaterThan(100);
    return surfaces[0]!;
}

describe('the kinds of surface', () => {
    it('releases a streak surface until the slider says', async () => {
        const streak = await edited(() => page.getByRole('radio', { name: 'Streak' }).check());
        expect(streak).toMatchObject({ kind: 'streak', from: 8.5, to: 16 });
        expect(streak.releaseUntil).toBeUndefined();
        const slider = page.getByRole('slider', { name: 'Release until' });
        const sheet = await edited(async () => {
            await slider.focus();
            for (let i = 0; i < 25; ++i) await slider.press('ArrowLeft');
        });
        expect(sheet.releaseUntil).toBeCloseTo(12.25);
        const keep = page.getByRole('checkbox', { name: /Keep releasing/ });
        expect((await edited(() => keep.check())).releaseUntil).toBeUndefined();
        expect((await edited(() => keep.uncheck())).releaseUntil).toBeCloseTo(12.25);
    });

    it('sweeps a time surface across the flow until told otherwise', async () => {
        const patch = await edited(() => page.getByRole('radio', { name: 'Time' }).check());
        expect(patch).toMatchObject({ kind: 'time', from: 8.5, to: 16 });
        expect(patch.sweep?.map((each) => each !== 0)).toEqual([false, true, false]);
        const z = page.getByRole('spinbutton', { name: 'Sweep along z' });
        const slanted = await edited(async () => {
            await z.fill('0.5');
            await z.press('Enter');
        });
        expect(slanted.sweep).toEqual([0, patch.sweep![1], 0.5]);
        const path = await edited(() => page.getByRole('radio', { name: 'Path' }).check());
        expect(path.sweep).toBeUndefined();
        await page.getByText(/end of data/).waitFor();
    });
});
