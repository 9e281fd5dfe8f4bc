// How long after a pointer move its surface is on the screen, while a handle is dragged for about 3 s
// with the real mouse, how many states of it come in a second, and how much script that takes, and processor time of the process
// that draws, which says more where a machine is busy. Prints one line of JSON. Starts its own server unless WAKESURF_URL names one.
import type { Browser, Page } from 'playwright-core';
import { ask, finalSurface, launchBrowser, newContext, openPage } from './support/browser_page.ts';
import { takeScriptTimes, timeScripts } from './support/script_time.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';

const dragMs = 3000;

/** Round and round near where the handle is, so that it stays inside the domain. */
async function dragInCircles(page: Page): Promise<void> {
    const at = await ask(page, (hook) => hook.handleOnScreen('middle'));
    if (at === null) throw new Error('the handle is not in front of the camera');
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    const start = performance.now();
    for (let elapsed = 0; elapsed < dragMs; elapsed = performance.now() - start) {
        const angle = elapsed / 250;
        await page.mouse.move(at.x + 24 * Math.sin(angle), at.y + 12 * (1 - Math.cos(angle)));
    }
    await page.mouse.up();
}

function quantile(sorted: readonly number[], fraction: number): number {
    const index = Math.min(sorted.length - 1, Math.floor(fraction * sorted.length));
    return Math.round((sorted[index] ?? Number.NaN) * 100) / 100;
}

function spread(sorted: readonly number[]): { median: number; p95: number } {
    return { median: quantile(sorted, 0.5), p95: quantile(sorted, 0.95) };
}

/** Of the process that draws the pictures, until now. */
async function drawingMs(browser: Browser): Promise<number> {
    const session = await browser.newBrowserCDPSession();
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    await session.detach();
    return processInfo.filter(({ type }) => type === 'GPU').reduce((sum, { cpuTime }) => sum + 1000 * cpuTime, 0);
}

async function measure(link: string): Promise<void> {
    // As a browser without graphics hardware does it: the picture is drawn by software, and so is the page round it.
    const browser = await launchBrowser(['--disable-gpu-compositing']);
    try {
        const context = await newContext(browser, { width: 1440, height: 900 });
        await timeScripts(context);
        const page = await openPage(context, link);
        await finalSurface(page);
        const before = await ask(page, (hook) => hook.latencySamples.length);
        await takeScriptTimes(page);
        const drawnBefore = await drawingMs(browser);
        await dragInCircles(page);
        const drawn = (await drawingMs(browser)) - drawnBefore;
        const { pixelRatio } = await page.evaluate(() => ({ pixelRatio: window.wakesurf?.pixelRatio }));
        const { moves, frames } = await takeScriptTimes(page);
        await finalSurface(page);
        const samples = await ask(page, (hook) => hook.latencySamples);
        const times = samples.slice(before).map(({ milliseconds }) => milliseconds);
        times.sort((a, b) => a - b);
        const quads = await ask(page, (hook) => hook.displayed?.cells ?? 0);
        const figures = { medianMs: quantile(times, 0.5), p95Ms: quantile(times, 0.95) };
        const statesPerSecond = Math.round((10_000 * times.length) / dragMs) / 10;
        const states = { statesPerSecond, drawingMsPerState: Math.round(drawn / Math.max(1, times.length)), pixelRatio };
        const script = { script_per_move_ms: spread(moves), script_per_frame_ms: spread(frames) };
        console.log(JSON.stringify({ name: 'browser-drag', ...figures, ...states, ...script, samples: times.length, quads }));
    } finally {
        await browser.close();
    }
}

const given = process.env['WAKESURF_URL'];
if (given !== undefined) await measure(given);
else {
    const store = temporaryFolder();
    const server = await ServerProcess.start({ store: store.path });
    try {
        await server.imported();
        await measure(await server.streamSession());
    } finally {
        await server.stop();
        store.remove();
    }
}
