// The first minute on a telephone: fingers, little room, and nothing in the way of what the tour asks for.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { showFacts } from './support/page_facts.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

async function visit(width: number, height: number): Promise<void> {
    const context = await rig.browser.newContext({
        viewport: { width, height },
        hasTouch: true,
        isMobile: true,
        reducedMotion: 'reduce',
    });
    await showFacts(context);
    page = await context.newPage();
    await page.goto(await rig.server.newSession());
    await finalSurface(page);
    await page.getByRole('region', { name: 'Tour' }).waitFor();
}

/** What lies over a handle of the rake, or within 8 pixels of it. */
async function partsOver(handle: 0 | 1 | 'middle' | 'rotate'): Promise<string[]> {
    const { x, y } = (await page.evaluate((each) => window.wakesurf!.handleOnScreen(each), handle))!;
    const over: string[] = [];
    for (const part of ['wakesurf-tour section', 'wakesurf-scalar-bar', 'wakesurf-tool-buttons', 'wakesurf-time-bar']) {
        const box = await page.locator(part).first().boundingBox();
        if (box === null) continue;
        const beside = x <= box.x - 8 || x >= box.x + box.width + 8 || y <= box.y - 8 || y >= box.y + box.height + 8;
        if (!beside) over.push(part);
    }
    return over;
}

/** Where nobody has moved the camera, it is fitted to the larger picture. */
async function expectWholeSurfaceWithoutPanel(): Promise<void> {
    await page.getByRole('button', { name: /panel/i }).first().click();
    const outside = (): Promise<number> =>
        ask(page, (hook) => {
            const box = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
            const seen = hook.vertices(5).map(({ point }) => hook.project(point)!);
            return seen.filter(({ x, y }) => x < box.left || x > box.right || y < box.top || y > box.bottom).length;
        });
    await page.waitForFunction(
        () => document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect().height > 500,
    );
    // Fitted by a drawing after the canvas has grown, for which a busy machine takes more than the usual second.
    await expect.poll(outside, { timeout: 20_000 }).toBe(0);
    await page.keyboard.press('p');
}

describe.each([
    ['upright', 390, 844],
    ['on its side', 844, 390],
])('a telephone, %s', (_, width, height) => {
    it('shows the handles beside the card that speaks of them, says how far the surface is without scrolling, and turns by a drag on the bar', async () => {
        await visit(width, height);
        for (const handle of [0, 1, 'middle', 'rotate'] as const) {
            // A busy machine may draw the view that is fitted to the surface after the surface itself.
            await expect.poll(() => partsOver(handle)).toEqual([]);
            const at = (await page.evaluate((each) => window.wakesurf!.handleOnScreen(each), handle))!;
            expect(at.x).toBeGreaterThan(0);
            expect(at.x).toBeLessThan(width);
        }
        await page.getByRole('button', { name: 'Next', exact: true }).click();
        await page.getByText(/with two fingers to pan, and pinch/).waitFor();
        await page.getByRole('button', { name: 'Skip the tour' }).click();
        for (const tab of ['Look', 'Flow']) {
            await page.getByRole('tab', { name: tab }).click();
            const box = (await page
                .locator('wakesurf-status')
                .getByText(/^Final/)
                .boundingBox())!;
            expect(box.y).toBeGreaterThan(0);
            expect(box.y + box.height).toBeLessThanOrEqual(height);
        }
        if (height > width) await expectWholeSurfaceWithoutPanel();

        const bar = (await page.locator('wakesurf-scalar-bar').boundingBox())!;
        const before = await ask(page, (hook) => hook.camera.position);
        const touch = await page.context().newCDPSession(page);
        const points = (dx: number) => [{ x: bar.x + bar.width / 2 + dx, y: bar.y + bar.height / 2 }];
        await touch.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points(0) });
        for (const dx of [10, 30, 60, 90]) {
            await touch.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points(dx) });
        }
        await touch.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
        await expect.poll(() => ask(page, (hook) => hook.camera.position)).not.toEqual(before);
        await page.context().close();
    });
});
