// Debian's Chromium with software WebGL2, and what the tests do with a page in it.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import type { TestHook } from '../../../web-client/src/testHook.ts';
import { projectRoot } from './project_root.ts';

const flags = [
    '--no-sandbox',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
    '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader',
    '--ignore-gpu-blocklist',
    '--force-color-profile=srgb',
    '--hide-scrollbars',
];

const artefacts = join(projectRoot, 'test-artefacts');

export function launchBrowser(extra: readonly string[] = []): Promise<Browser> {
    return chromium.launch({
        executablePath: process.env['WAKESURF_CHROMIUM'] ?? '/usr/bin/chromium',
        headless: true,
        args: [...flags, ...extra],
    });
}

export interface PageOptions {
    width?: number;
    height?: number;
    colorScheme?: 'dark' | 'light';
    /** Someone who has never been here is shown the tour. */
    firstVisit?: boolean;
}

export async function newContext(browser: Browser, options: PageOptions = {}): Promise<BrowserContext> {
    const { width = 1000, height = 600, colorScheme = 'dark', firstVisit = false } = options;
    const context = await browser.newContext({
        viewport: { width, height },
        deviceScaleFactor: 1,
        reducedMotion: 'reduce',
        colorScheme,
    });
    if (!firstVisit) await context.addInitScript(() => localStorage.setItem('wakesurf.tour', 'done'));
    return context;
}

/** Opens a link and collects everything the page complains about. */
export async function openPage(
    context: BrowserContext,
    link: string,
): Promise<{ page: Page; complaints: string[] }> {
    const page = await context.newPage();
    const complaints: string[] = [];
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('console', (message) => {
        if (message.type() === 'error') complaints.push(message.text());
    });
    await page.goto(link);
    return { page, complaints };
}

/** Waits for the newest surface at its finest, drawn. */
export async function finalSurface(page: Page): Promise<void> {
    await page.waitForFunction(() => window.wakesurf?.phase === 'final', null, { timeout: 60_000 });
}

/** Reads facts from the page. */
export function ask<Result>(page: Page, read: (hook: TestHook) => Result): Promise<Result> {
    return page.evaluate(`(${read.toString()})(window.wakesurf)`) as Promise<Result>;
}

export async function screenshot(page: Page, name: string): Promise<void> {
    mkdirSync(artefacts, { recursive: true });
    await page.screenshot({ path: join(artefacts, `${name}.png`) });
}
