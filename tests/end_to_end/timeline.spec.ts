// The timeline: what of the data is in memory, and one time that mouse, keys and other people move. What the page says is
// compared with the server's records, and where it stops with the server's mesh. Its controls are tested beside the time bar.
import type { BrowserContext, Locator, Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import type { ClockRecord, SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage, screenshot } from './support/browser_page.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
let context: BrowserContext;
let page: Page;

beforeEach(async () => {
    context = await newContext(stand.browser, { width: 900, height: 480 });
    page = await openPage(context, await stand.server.newSession());
    await finalSurface(page);
});

afterEach(() => context.close());

async function records(): Promise<{ clock: ClockRecord; surface: SurfaceRecord }> {
    const session = await ask(page, (hook) => hook.session);
    const state = await stand.server.call('session.state', { session });
    const { clock, surfaces } = state as unknown as { clock: ClockRecord; surfaces: SurfaceRecord[] };
    return { clock, surface: surfaces[0]! };
}

/** The first value that is as expected. */
async function becomes<T>(read: () => Promise<T>, expected: (value: T) => void): Promise<T> {
    let value: T;
    await expect
        .poll(
            async () => {
                value = await read();
                try {
                    expected(value);
                    return 'as expected';
                } catch {
                    return value;
                }
            },
            { timeout: 30_000, interval: 30 },
        )
        .toBe('as expected');
    return value!;
}

async function streak(): Promise<void> {
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    await finalSurface(page);
}

/** Where the picture is of this time, drawn. */
async function shownAt(time: number): Promise<void> {
    await page.waitForFunction((at) => Math.abs(window.wakesurf!.displayed!.time - at) < 1e-6, time);
    await finalSurface(page);
}

function marks(): Promise<{ state: string; middle: number }[]> {
    return page.locator('wakesurf-timeline [data-state]').evaluateAll((all) =>
        all.map((each) => {
            const box = each.getBoundingClientRect();
            return { state: (each as SVGElement).dataset['state']!, middle: box.x + box.width / 2 };
        }),
    );
}

/** Middle of a handle, and the window's x of a time. */
async function lineOf(handle: Locator): Promise<{ x: (time: number) => number; y: number }> {
    const box = (await handle.boundingBox())!;
    const thumb = 14;
    const [left, width] = [box.x + thumb / 2, box.width - thumb];
    return { x: (time) => left + (width * (time - 8.5)) / 7.5, y: box.y + box.height / 2 };
}

describe('the timeline', () => {
    it('shows which time-steps are in memory, each at its time, as the server has it', async () => {
        const status = async () =>
            (await stand.server.call('cache.status', { dataset: 'sqcyl' })) as unknown as { steps: string[] };
        const { times } = (await stand.server.call('dataset.describe', { dataset: 'sqcyl' })) as unknown as {
            times: number[];
        };
        // What is read ahead may still be coming.
        const { steps } = await becomes(status, (now) => expect(now.steps).not.toContain('loading'));
        expect(steps).toContain('cold');
        expect(steps).toContain('resident');
        const drawn = await becomes(marks, (now) => expect(now.map(({ state }) => state)).toEqual(steps));
        const line = await lineOf(page.locator('#time'));
        for (const [i, { middle }] of drawn.entries()) expect(Math.abs(middle - line.x(times[i]!))).toBeLessThan(1);
        // Full, half or hollow: not by colour alone.
        const fills = await page.locator('wakesurf-timeline [data-state] .filled').count();
        expect(fills).toBe(steps.filter((state) => state === 'resident').length);
        await expect.poll(() => page.locator('#resident').textContent()).toBe(`${fills} of 16 time-steps in memory`);
        await screenshot(page, 'timeline-frozen');
        await streak();
        const allResident = steps.map(() => 'resident');
        await becomes(marks, (now) => expect(now.map(({ state }) => state)).toEqual(allResident));
        expect((await status()).steps).toEqual(allResident);
        expect(await page.locator('#resident').textContent()).toBe('16 of 16 time-steps in memory');
    });

    it('is scrubbed by mouse and keys, back to the mesh that the server computes for that time from the start', async () => {
        await streak();
        const handle = page.locator('#clock');
        const line = await lineOf(handle);
        await page.mouse.move(line.x(16), line.y);
        await page.mouse.down();
        await page.mouse.move(line.x(14), line.y, { steps: 4 });
        await page.mouse.move(line.x(11), line.y, { steps: 4 });
        await page.mouse.up();
        await page.waitForFunction(() => Math.abs(window.wakesurf!.displayed!.time - 11) < 0.03);
        await finalSurface(page);
        await handle.focus();
        await page.keyboard.press('Home');
        // Nothing has been released for any time yet.
        await page.waitForFunction(() => window.wakesurf!.displayed!.time === 8.5 && window.wakesurf!.phase === 'empty');
        for (const _ of [1, 2, 3]) await page.keyboard.press('ArrowRight');
        await shownAt(10);
        await page.keyboard.press('PageUp');
        await shownAt(12.5);
        await screenshot(page, 'timeline-scrubbed');
        // A surface of its own that ends there: no clock, no checkpoint, the same mesh.
        const { clock, surface: record } = await records();
        expect(clock.time).toBe(12.5);
        const { surface: _surface, rev: _rev, epoch: _epoch, fields: _fields, ...setting } = record;
        const session = await ask(page, (hook) => hook.session);
        const { surface } = await stand.server.call('surface.set', { ...setting, session, to: 12.5 });
        const fresh = await stand.server.call('surface.wait', { session, surface, timeoutMs: 20_000 });
        const shown = await ask(page, (hook) => hook.displayed!);
        expect(fresh).toMatchObject({ complete: true, vertices: shown.vertices, quads: shown.cells });
        await page.keyboard.press('End');
        await shownAt(16);
        await expectServersMesh(stand.server, page);
    });

    it('follows others who move the clock, and lets no viewer play', async () => {
        await streak();
        const session = await ask(page, (hook) => hook.session);
        const { link } = (await stand.server.call('session.share', { session, role: 'viewer' })) as { link: string };
        const other = await newContext(stand.browser, { width: 900, height: 480, colorScheme: 'light' });
        const viewer = await openPage(other, new URL(link, stand.server.link).href);
        await finalSurface(viewer);
        expect(await viewer.getByRole('button', { name: 'Play' }).isDisabled()).toBe(true);
        const line = await lineOf(page.locator('#clock'));
        await page.mouse.click(line.x(10), line.y);
        const { clock } = await becomes(records, (now) => expect(Math.abs(now.clock.time! - 10)).toBeLessThan(0.03));
        await viewer.waitForFunction((at) => Math.abs(window.wakesurf!.displayed!.time - at) < 1e-6, clock.time!);
        await expect.poll(async () => Number(await viewer.locator('#clock').inputValue())).toBeCloseTo(clock.time!);
        await stand.server.call('time.set', { session, time: 13 });
        await shownAt(13);
        await expect.poll(() => page.locator('#go-to').inputValue()).toBe('13');
        await screenshot(viewer, 'timeline-light');
        await other.close();
    });

    it('lets a viewer play, scrub and colour in a copy, from the same time and view, and come back', async () => {
        await streak();
        const session = await ask(page, (hook) => hook.session);
        await stand.server.call('time.set', { session, time: 12 });
        await shownAt(12);
        const { link } = (await stand.server.call('session.share', { session, role: 'viewer' })) as { link: string };
        const other = await newContext(stand.browser, { width: 900, height: 480 });
        const viewer = await openPage(other, new URL(link, stand.server.link).href);
        await finalSurface(viewer);
        await viewer.evaluate(() => window.wakesurf!.setCamera([5, -26, 8], [5, 0, 3]));
        const camera = await ask(viewer, (hook) => hook.camera);
        await screenshot(viewer, 'viewer-time');
        await viewer.locator('wakesurf-time-bar').getByRole('button', { name: 'Continue in a copy' }).click();

        await viewer.getByText('A copy of').waitFor();
        await finalSurface(viewer);
        expect(viewer.url()).not.toContain('token');
        expect(await ask(viewer, (hook) => hook.session)).not.toBe(session);
        expect(await ask(viewer, (hook) => hook.displayed!.time)).toBeCloseTo(12, 6);
        const there = (await ask(viewer, (hook) => hook.camera)).position;
        camera.position.forEach((each, axis) => expect(there[axis]).toBeCloseTo(each, 3));
        const line = await lineOf(viewer.locator('#clock'));
        await viewer.mouse.click(line.x(9), line.y);
        await viewer.waitForFunction(() => Math.abs(window.wakesurf!.displayed!.time - 9) < 0.03);
        await viewer.getByRole('button', { name: 'Play' }).click();
        await viewer.waitForFunction(() => window.wakesurf!.displayed!.time > 9.2);
        await viewer.getByRole('button', { name: 'Pause' }).click();
        await viewer.getByRole('tab', { name: 'Look' }).click();
        await viewer.getByLabel('Colour by').selectOption('q_criterion');
        await viewer.getByText('Q, ').first().waitFor();
        await finalSurface(viewer);
        await screenshot(viewer, 'viewer-in-a-copy');
        expect((await records()).clock.time, 'nobody else sees any of it').toBe(12);
        expect((await records()).surface.fields).not.toContain('q_criterion');

        await viewer.getByRole('button', { name: /^Back to/ }).click();
        await viewer.getByText('Your link is for looking').waitFor();
        await finalSurface(viewer);
        expect(await ask(viewer, (hook) => hook.session)).toBe(session);
        await other.close();
    });
});
