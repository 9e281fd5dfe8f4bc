// Isosurfaces from the panel: the level is dragged and typed, what is shown has that value at every vertex, and several stand beside the
// surface of a rake, in one list.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SurfaceRecord, SurfaceStats } from '../../web-client/src/protocol/messages.ts';
import { readFragment } from '../../web-client/src/session/view/urlState.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 780, height: 560 });
});

async function records(): Promise<SurfaceRecord[]> {
    const session = await ask(page, (hook) => hook.session);
    const { surfaces } = (await rig.server.call('surface.list', {
        session,
    })) as { surfaces: SurfaceRecord[] };
    return surfaces;
}

async function added(): Promise<SurfaceRecord> {
    const before = (await records()).length;
    await page.getByRole('button', { name: 'New isosurface' }).click();
    await expect.poll(async () => (await records()).length).toBe(before + 1);
    const made = (await records()).at(-1)!;
    await page.locator(`[data-thing="${made.surface}"][aria-pressed="true"]`).waitFor();
    await finalSurface(page);
    return made;
}

/** The record once what was edited is on the screen. */
async function edited(edit: () => Promise<unknown>): Promise<SurfaceRecord> {
    const before = await ask(page, (hook) => hook.displayed?.epoch ?? 0);
    await edit();
    await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before);
    await finalSurface(page);
    return (await records()).at(-1)!;
}

/** Of what is drawn, how far its speed is from a level in the mean: between nodes the speed of a mean is not the mean of speeds. */
async function offLevel(level: number): Promise<number> {
    const off = (await ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar))).map((scalar) =>
        Math.abs(scalar - level),
    );
    return off.reduce((sum, each) => sum + each, 0) / off.length;
}

describe('an isosurface', () => {
    it('is dragged over the range of its field, typed, shown at the time of the clock, and there after a reload', async () => {
        const first = await added();
        expect(first.rake).toBeUndefined();
        expect(first).toMatchObject({
            kind: 'level',
            field: 'U',
            from: 8.5,
            to: 16,
        });
        const range = page.locator('#level-range');
        await range.waitFor();
        const session = await ask(page, (hook) => hook.session);
        const stats = (await rig.server.call('surface.stats', {
            session,
            surface: first.surface,
        })) as unknown as SurfaceStats;
        const [low, high] = stats.fieldRange!;
        expect(low).toBeLessThan(first.level!);
        expect(high).toBeGreaterThan(first.level!);

        // With the mouse, along the slider: the newest level wins.
        const slider = page.getByRole('slider', { name: 'Level' });
        await slider.scrollIntoViewIfNeeded();
        const box = (await slider.boundingBox())!;
        const at = (part: number): [number, number] => [box.x + part * box.width, box.y + box.height / 2];
        const dragged = await edited(async () => {
            await page.mouse.move(...at(0.5));
            await page.mouse.down();
            for (let i = 0; i <= 10; ++i) await page.mouse.move(...at(0.5 + 0.015 * i));
            await page.mouse.up();
        });
        expect(dragged.level).toBeGreaterThan(low + 0.6 * (high - low));
        expect(dragged.level).toBeLessThan(low + 0.7 * (high - low));
        await expect.poll(() => offLevel(dragged.level!)).toBeLessThan(0.01);
        expect(await slider.inputValue()).toBe(String(dragged.level));

        const typed = await edited(async () => {
            await page.getByRole('textbox', { name: 'Level' }).fill('0.6');
            await page.keyboard.press('Enter');
        });
        expect(typed.level).toBe(0.6);
        const ends = await ask(page, (hook) => hook.displayed!.stateSum);
        await rig.server.call('time.set', { session, time: 10 });
        await page.waitForFunction(() => window.wakesurf?.displayed?.time === 10);
        expect(await ask(page, (hook) => hook.displayed!.stateSum)).not.toBe(ends);

        await page.reload();
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.displayed!.time)).toBe(10);
        expect(await offLevel(0.6)).toBeLessThan(0.01);
    });

    it('is one of several, shown alone until that is taken back, also after a reload, and stays where the rake is deleted', async () => {
        const thing = (name: string | RegExp) => page.getByRole('button', { name });
        const shown = (): Promise<number> => ask(page, (hook) => hook.allDisplayed.length);
        const second = await added();
        await page.locator('#level-field').selectOption('velocity_x');
        await expect.poll(async () => (await records()).at(-1)!.field).toBe('velocity_x');
        await expect.poll(shown).toBe(3);
        await thing(/^Show only velocity_x/).click();
        await expect.poll(shown).toBe(1);
        // The address follows within half a second.
        await expect.poll(() => readFragment(new URL(page.url()).hash).state?.view.shown).toMatchObject({ only: second.surface });
        await page.reload();
        await finalSurface(page);
        expect(await shown()).toBe(1);
        await thing(/^Show only velocity_x/).click();
        await expect.poll(shown).toBe(3);
        await page.locator('[data-thing="r1"]').click();
        await page.getByRole('button', { name: 'Delete', exact: true }).click();
        await expect.poll(async () => (await records()).map(({ kind }) => kind)).toEqual(['level', 'level']);
        expect((await records()).at(-1)!.surface).toBe(second.surface);
    });
});
