// The timeline: one time that mouse, keys and other people move. What the page says is compared with the server's records, and where
// it stops with the server's mesh. Its controls are tested beside the time bar, and what of the data is in memory in parts_in_memory.
import type { Locator, Page } from 'playwright-core';
import { beforeEach, describe, expect, it } from 'vitest';
import type { ClockRecord, SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const size = { width: 900, height: 480 };
let page: Page;

beforeEach(async () => {
    page = await rig.visit(size);
    return () => page.context().close();
});

async function records(): Promise<{ clock: ClockRecord; surface: SurfaceRecord }> {
    const session = await ask(page, (hook) => hook.session);
    const state = await rig.server.call('session.state', { session });
    const { clock, surfaces } = state as unknown as { clock: ClockRecord; surfaces: SurfaceRecord[] };
    return { clock, surface: surfaces[0]! };
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

/** The window's x of the mark of each time-step that is in memory. */
function residentMarks(): Promise<number[]> {
    return page.locator('wakesurf-timeline [data-state=resident]').evaluateAll((all) =>
        all.map((each) => {
            const box = each.getBoundingClientRect();
            return box.x + box.width / 2;
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
    it('is scrubbed by mouse and keys, back to the mesh that the server computes for that time from the start', async () => {
        await streak();
        const handle = page.locator('#clock');
        const line = await lineOf(handle);
        // The surface has read them all, each is marked at its time.
        await expect.poll(async () => (await residentMarks()).length).toBe(16);
        for (const [i, x] of (await residentMarks()).entries()) expect(Math.abs(x - line.x(8.5 + i / 2))).toBeLessThan(1);
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
        // A surface of its own that ends there: no clock, no checkpoint, the same mesh.
        const { clock, surface: record } = await records();
        expect(clock.time).toBe(12.5);
        const { surface: _surface, rev: _rev, epoch: _epoch, fields: _fields, ...setting } = record;
        const session = await ask(page, (hook) => hook.session);
        const { surface } = await rig.server.call('surface.set', { ...setting, session, to: 12.5 });
        const fresh = await rig.server.call('surface.wait', { session, surface, timeoutMs: 20_000 });
        const shown = await ask(page, (hook) => hook.displayed!);
        expect(fresh).toMatchObject({ complete: true, vertices: shown.vertices, quads: shown.cells });
        await page.keyboard.press('End');
        await shownAt(16);
        await expectServersMesh(rig.server, page);
    });
});
