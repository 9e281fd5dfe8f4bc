// Every kind of surface from the panel: what a person chooses is what the server builds and the page shows.
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
        // Of what was released until then, half of the time is as old as a particle gets.
        await edited(() => keep.check());
        const young = await edited(() => page.getByRole('checkbox', { name: 'Particles live on' }).uncheck());
        expect(young.life).toBeCloseTo(3.75);
        const ages = (await ask(page, (hook) => hook.vertices(1))).map(({ t }) => 16 - t);
        expect(Math.max(...ages)).toBeGreaterThan(3.7);
        expect(Math.max(...ages)).toBeLessThan(3.751);
    });

    it('sweeps a time surface across the flow until told otherwise', async () => {
        const patch = await edited(() => page.getByRole('radio', { name: 'Time' }).check());
        // Released late enough that it has not left the domain.
        expect(patch).toMatchObject({ kind: 'time', to: 16 });
        expect(patch.from).toBeGreaterThan(8.5);
        expect(patch.sweep?.map((each) => each !== 0)).toEqual([false, true, false]);
        const z = page.getByRole('spinbutton', { name: 'Sweep along z' });
        const slanted = await edited(async () => {
            await z.fill('0.5');
            await z.press('Enter');
        });
        expect(slanted.sweep).toEqual([0, patch.sweep![1], 0.5]);
        const path = await edited(() => page.getByRole('radio', { name: 'Path' }).check());
        expect(path.sweep).toBeUndefined();
        await page.getByText('To the end of the data.').waitFor();
        const slider = page.getByRole('slider', { name: 'Integration time' });
        await slider.focus();
        await page.keyboard.press('End');
        expect(await slider.inputValue()).toBe(String(path.to - path.from));
        const shorter = await edited(() => page.keyboard.press('Home'), 0);
        expect(shorter.to).toBeCloseTo(path.from + (path.to - path.from) / 100);
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

    it('offers both directions only where a surface need not be there at one time, and says what becomes of them', async () => {
        const direction = page.getByRole('combobox', { name: 'Direction' });
        expect(await direction.locator('option').count()).toBe(3);
        await edited(() => direction.selectOption('both'));
        const path = await edited(() => page.getByRole('radio', { name: 'Path' }).check());
        expect(path).toMatchObject({ kind: 'path', direction: 'both', from: 8.5, to: 16 });
        await page.getByText(/Forward only: the data begin at its release/).waitFor();
        await page.getByRole('slider', { name: 'Release' }).focus();
        const uneven = await edited(() => page.keyboard.press('PageUp'));
        expect(uneven).toMatchObject({ direction: 'both', to: 16 });
        expect(uneven.from).toBeGreaterThan(8.5);
        await page.getByText(/Back to .* only, where the data begin/).waitFor();
        const streak = await edited(() => page.getByRole('radio', { name: 'Streak' }).check());
        expect(streak).toMatchObject({ kind: 'streak', direction: 'forward', from: uneven.from, to: 16 });
        await page.getByText('A streak surface goes one way in time: this one goes forward.').waitFor();
        expect(await direction.inputValue()).toBe('forward');
        expect(await direction.locator('option').count()).toBe(2);
        await screenshot(page, 'streak-after-both');
    });
});
