// Debian's Chromium with software WebGL2, and what the tests do with a page in it.
import { type Browser, type BrowserContext, chromium, type Page } from 'playwright-core';
import { hearComplaints } from './complaints.ts';
import { type PageFacts, showFacts } from './page_facts.ts';

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

export async function launchBrowser(extra: readonly string[] = [], executable = '/usr/bin/chromium'): Promise<Browser> {
    const browser = await chromium.launch({
        executablePath: process.env['WAKESURF_CHROMIUM'] ?? executable,
        headless: true,
        args: [...flags, ...extra],
    });
    hearComplaints(browser);
    return browser;
}

export interface PageOptions {
    width?: number;
    height?: number;
    colorScheme?: 'dark' | 'light';
    /** Someone who has never been here is shown the tour. */
    firstVisit?: boolean;
    /** Of the browser, as `de-DE`. */
    locale?: string;
}

export async function newContext(browser: Browser, options: PageOptions = {}): Promise<BrowserContext> {
    const { width = 1000, height = 600, colorScheme = 'dark', firstVisit = false, locale = 'en-US' } = options;
    const context = await browser.newContext({
        viewport: { width, height },
        deviceScaleFactor: 1,
        reducedMotion: 'reduce',
        colorScheme,
        locale,
    });
    await showFacts(context);
    // Scripts also run in the empty page before the first, which may keep nothing.
    if (!firstVisit) await context.addInitScript(() => origin !== 'null' && localStorage.setItem('wakesurf.tour', 'done'));
    return context;
}

/** A new page of the context, at the link. */
export async function openPage(context: BrowserContext, link: string): Promise<Page> {
    const page = await context.newPage();
    await page.goto(link);
    return page;
}

/** Waits for the newest surface at its finest, drawn. */
export async function finalSurface(page: Page): Promise<void> {
    await page.waitForFunction(() => window.wakesurf?.phase === 'final', null, { timeout: 60_000 });
}

/** Waits until the page is in a session, whatever is drawn of it; which one. */
export async function entered(page: Page): Promise<string> {
    const session = await page.waitForFunction(() => window.wakesurf?.connection === 'open' && window.wakesurf.session);
    return (await session.jsonValue()) as string;
}

/** Reads facts from the page. */
export function ask<Result>(page: Page, read: (hook: PageFacts) => Result): Promise<Result> {
    return page.evaluate<Result>(`(${read.toString()})(window.wakesurf)`);
}
