// The rake by mouse, as a person drags it.
import type { Page } from 'playwright-core';
import { expect } from 'vitest';

export type HandleName = number | 'middle' | 'rotate';

/** Presses on a handle; where on the screen that is. */
export async function takeHandle(page: Page, handle: HandleName): Promise<{ x: number; y: number }> {
    const from = await page.evaluate((name) => window.wakesurf?.handleOnScreen(name) ?? null, handle);
    if (from === null) throw new Error('the handle is not in front of the camera');
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    return from;
}

/** Waits until a handle is drawn at a place on the screen, or not a pixel beside it. */
export async function handleIsAt(page: Page, handle: HandleName, place: { x: number; y: number }): Promise<void> {
    const apart = async (): Promise<number> => {
        const now = await page.evaluate((name) => window.wakesurf?.handleOnScreen(name), handle);
        return Math.hypot((now?.x ?? 0) - place.x, (now?.y ?? 0) - place.y);
    };
    if ((await apart()) >= 1) await expect.poll(apart).toBeLessThan(1);
}

/** Drags a handle by so many pixels; it is under the pointer after every step. */
export async function dragHandle(page: Page, handle: HandleName, dx: number, dy: number, steps: number): Promise<void> {
    const from = await takeHandle(page, handle);
    const size = page.viewportSize();
    for (const [value, limit] of [
        [from.x, size?.width],
        [from.x + dx, size?.width],
        [from.y, size?.height],
        [from.y + dy, size?.height],
    ] as const) {
        expect(value).toBeGreaterThan(0);
        expect(value).toBeLessThan(limit ?? 0);
    }
    for (let i = 1; i <= steps; ++i) {
        const pointer = { x: from.x + (dx * i) / steps, y: from.y + (dy * i) / steps };
        await page.mouse.move(pointer.x, pointer.y);
        await handleIsAt(page, handle, pointer);
    }
    await page.mouse.up();
}
