// A slider that is dragged sends more edits than the server keeps steps, and is one step all the same: with the mouse, over the
// wire, in the server's history.
import { expect, it } from 'vitest';
import type { Page } from 'playwright-core';
import type { RakeRecord, SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask } from './support/browser_page.ts';
import { dragHandle } from './support/rake_drag.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();

/** The server keeps so many steps of one person. */
const kept = 100;

async function records(page: Page): Promise<{ rake: RakeRecord; surface: SurfaceRecord }> {
    const session = await ask(page, (hook) => hook.session);
    const state = await stand.server.call('session.state', { session });
    const { rakes, surfaces } = state as unknown as { rakes: RakeRecord[]; surfaces: SurfaceRecord[] };
    return { rake: rakes[0]!, surface: surfaces[0]! };
}

async function becomes<T>(read: () => Promise<T>, holds: (fact: T) => boolean): Promise<T> {
    let fact = await read();
    await expect.poll(async () => holds((fact = await read())), { timeout: 30_000, interval: 40 }).toBe(true);
    return fact;
}

it('a slider dragged over more edits than are kept is taken back at once, and what was done before it after that', async () => {
    const page = await stand.visit({ width: 780, height: 320 });
    const { rake: first } = await records(page);
    await dragHandle(page, 1, 12, 8, 4);
    const moved = await becomes(
        () => records(page),
        ({ rake }) => !rake.dragging && JSON.stringify(rake.points) !== JSON.stringify(first.points),
    );
    const { to, rev } = moved.surface;

    const slider = page.locator('#length');
    await slider.scrollIntoViewIfNeeded();
    const box = (await slider.boundingBox())!;
    const y = box.y + box.height / 2;
    const at = (share: number): number => box.x + 8 + (box.width - 16) * share;
    const shown = (): Promise<number> => slider.evaluate((each: HTMLInputElement) => each.valueAsNumber);
    const value = await shown();
    const [least, most] = await slider.evaluate((each: HTMLInputElement) => [Number(each.min), Number(each.max)] as const);
    await page.mouse.move(at((value - least) / (most - least)), y);
    await page.mouse.down();
    // To and fro where the surface is short; of the places of one frame the newest is sent.
    let told = rev;
    while (told < rev + kept + 5) {
        for (let i = 0; i < 20; ++i) await page.mouse.move(at(i % 2 === 0 ? 0.05 : 0.1), y);
        told = (await records(page)).surface.rev;
    }
    await page.mouse.move(at(0.2), y);
    const length = await shown();
    await page.mouse.up();
    const asked = ({ surface }: { surface: SurfaceRecord }): boolean =>
        Math.abs(surface.to - surface.from - length) < 1e-6 * length;
    const slid = (await becomes(() => records(page), asked)).surface.to;

    await page.keyboard.press('Control+Z');
    const back = await becomes(
        () => records(page),
        ({ surface }) => surface.to === to,
    );
    expect(back.rake.points).toEqual(moved.rake.points);
    await expect.poll(shown).toBeCloseTo(value, 6);
    await page.keyboard.press('Control+Shift+Z');
    await becomes(
        () => records(page),
        ({ surface }) => surface.to === slid,
    );
    await page.keyboard.press('Control+Z');
    await page.keyboard.press('Control+Z');
    const start = await becomes(
        () => records(page),
        ({ rake }) => JSON.stringify(rake.points) === JSON.stringify(first.points),
    );
    expect(start.surface.to).toBe(to);
    await page.getByText('Undone.').first().waitFor();
});
