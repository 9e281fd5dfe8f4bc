// How long after opening the page the domain is on the screen, and the first surface, with nothing in the browser's cache;
// and how long after the command, of a case that was never imported. Prints one line of JSON. Starts its own servers, for
// $WAKESURF_DATA or the bundled simulation.
import { ask, finalSurface, launchBrowser, newContext, openPage } from './support/browser_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';

const visits = 7;
const commands = 3;

const store = temporaryFolder();
const server = await ServerProcess.start({ store: store.path });
const browser = await launchBrowser();

async function fromCommandToSurface(): Promise<number> {
    const empty = temporaryFolder();
    const context = await newContext(browser, { width: 1280, height: 720 });
    const start = performance.now();
    const started = await ServerProcess.start({ store: empty.path });
    try {
        await finalSurface(await openPage(context, started.link));
        return performance.now() - start;
    } finally {
        await context.close();
        await started.stop();
        empty.remove();
    }
}

try {
    const imported: number[] = [];
    for (let command = 0; command < commands; ++command) {
        imported.push(await fromCommandToSurface());
    }
    const pictures: number[] = [];
    const surfaces: number[] = [];
    for (let visit = 0; visit < visits; ++visit) {
        const context = await newContext(browser, { width: 1280, height: 720 });
        const page = await openPage(context, await server.newSession());
        await finalSurface(page);
        pictures.push((await ask(page, (hook) => hook.firstPictureMs)) ?? Number.NaN);
        surfaces.push(await page.evaluate(() => performance.now()));
        await context.close();
    }
    const median = (values: number[]): number => Math.round(values.sort((a, b) => a - b)[values.length >> 1] ?? Number.NaN);
    const figures = {
        domainMs: median(pictures),
        surfaceMs: median(surfaces),
        slowestDomainMs: Math.round(pictures.at(-1) ?? 0),
        commandToSurfaceMs: median(imported),
    };
    console.log(JSON.stringify({ name: 'browser-first-picture', ...figures, visits }));
} finally {
    await browser.close();
    await server.stop();
    store.remove();
}
