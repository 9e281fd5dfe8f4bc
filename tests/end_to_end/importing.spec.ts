// Data that have to be imported before they can be seen: how far that is, Stop, and going on. The importer is the real one, the
// files are many names of one that takes long to read.
import { linkSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { finalSurface, newContext, openPage, screenshot } from './support/browser_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

/** Many: however quick the machine, it is under way until it is stopped. */
const steps = 400;
const side = 56;
let browser: Browser;
const folders = [temporaryFolder(), temporaryFolder()] as const;
let server: ServerProcess;

function writeSlowSeries(folder: string): string {
    const extent = `0 ${side - 1} 0 ${side - 1} 0 ${side - 1}`;
    const numbers = '0.5 0.25 0 '.repeat(side ** 3);
    const first = join(folder, 'u_000.vti');
    writeFileSync(
        first,
        `<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="${extent}" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="${extent}"><PointData>
<DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">${numbers}</DataArray>
</PointData><CellData></CellData></Piece></ImageData></VTKFile>`,
    );
    for (let step = 1; step < steps; ++step) linkSync(first, join(folder, `u_${String(step).padStart(3, '0')}.vti`));
    return first;
}

interface Entry {
    state: string;
    steps: { ready: number; total: number };
}

async function entry(): Promise<Entry> {
    return ((await server.call('dataset.list', {}))['datasets'] as Entry[])[0]!;
}

function unfinished(): string[] {
    return readdirSync(folders[1].path, { recursive: true }).filter((name) => String(name).endsWith('.part')) as string[];
}

beforeAll(async () => {
    const data = writeSlowSeries(folders[0].path);
    server = await ServerProcess.start({ store: folders[1].path, data });
    browser = await testBrowser();
});

afterAll(async () => {
    await closePages();
    await server?.stop();
    for (const folder of folders) folder.remove();
});

describe('an import', () => {
    it('is stopped by the last of those who wait, and goes on when it is opened again', async () => {
        const one = await openPage(await newContext(browser, { width: 640, height: 400 }), server.link);
        const two = await openPage(await newContext(browser, { width: 640, height: 400 }), server.link);
        const [stop, stopToo] = [one, two].map((page) => page.locator('#importing').getByRole('button', { name: 'Stop' }));
        await stop!.waitFor();
        await stopToo!.waitFor();
        await one.getByRole('progressbar', { name: 'Import' }).waitFor();
        expect((await entry()).state).toBe('importing');

        await stop!.click();
        await one.getByText(/You stopped waiting for u_000\. Its import continues for others( \(\d+ of \d+\))?\./).waitFor();
        expect((await entry()).state).toBe('importing');
        await screenshot(one, 'import-left');
        await stopToo!.click();
        await two.getByText(/The import of u_000 was stopped/).waitFor();
        const stopped = await entry();
        expect(stopped.state).toBe('stopped');
        expect(stopped.steps.ready).toBeLessThan(steps);
        await expect.poll(unfinished).toEqual([]);
        // The one who had left is told as well.
        await one.getByText(/The import of u_000 was stopped/).waitFor();
        await screenshot(two, 'import-stopped');
        // The step that was being written when it was stopped may be one of them.
        expect((await entry()).steps.ready - stopped.steps.ready).toBeLessThanOrEqual(1);

        await two.getByRole('button', { name: 'Resume the import' }).click();
        await expect.poll(async () => (await entry()).steps.ready, { timeout: 30_000 }).toBeGreaterThan(stopped.steps.ready);
        await two.locator('#importing').getByRole('button', { name: 'Stop' }).waitFor();
        await two.locator('#import-stopped').waitFor({ state: 'detached' });
        await finalSurface(two);
    });
});
