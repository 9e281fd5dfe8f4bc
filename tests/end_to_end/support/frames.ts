// Time that passes in a page, counted in what it could have drawn instead of in seconds.
import type { Page } from 'playwright-core';

/** Waits until the browser has offered the page so many frames. */
export async function framesPass(page: Page, count: number): Promise<void> {
    await page.evaluate(async (left) => {
        for (let i = 0; i < left; ++i) await new Promise(requestAnimationFrame);
    }, count);
}
