// The browser of the tests: one for all files, for to start one and to compile its shaders takes as long as some tests. It ends with
// the process that launched it.
import type { Browser } from 'playwright-core';
import { launchBrowser } from './browser_page.ts';

/**
 * Chromium without the windows, bars and menus around the page, which the other one draws too. Putting the page together costs a
 * software GPU more than the processor: a third of all time of the tests.
 */
export const shell = { executable: '/usr/bin/chromium-headless-shell', flags: ['--disable-gpu-compositing'] };

let launched: Promise<Browser> | null = null;

export function testBrowser(): Promise<Browser> {
    launched ??= launchBrowser(shell.flags, shell.executable);
    return launched;
}

/** Of everyone who visits: at the end of a file, before its server stops. */
export async function closePages(): Promise<void> {
    const browser = await launched;
    if (browser !== null) await Promise.all(browser.contexts().map((context) => context.close()));
}
