// Data that have to be imported before they can be seen: how far that is, Stop, and going on. The importer is the real one, the
// files are many names of one that takes long to read.
import { linkSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { ask, finalSurface, newContext, openPage, screenshot } from './support/browser_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

/** Many: however quick the machine, it is under way until it is stopped. */
const steps = 400;
const side = 56;
let browser: Browser;
const folders = [temporaryFolder(), temporaryFolder()] as const;
const two = [temporaryFolder(), temporaryFolder(), temporaryFolder()] as const;
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
    for (const folder of [...folders, ...two]) folder.remove();
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

/** Air at 1 m/s along x, water at 2 or another speed along z. */
function writeTwoPhases(folder: string, water = 2): string {
    const file = join(folder, 'two.vti');
    const nodes = 5 ** 3;
    const array = (name: string, value: string) =>
        `<DataArray type="Float32" Name="${name}" NumberOfComponents="3" format="ascii">${value.repeat(nodes)}</DataArray>`;
    writeFileSync(
        file,
        `<?xml version="1.0"?>
<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">
<ImageData WholeExtent="0 4 0 4 0 4" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 4 0 4 0 4"><PointData>
${array('U.air', '1 0 0 ')}${array('U.water', `0 0 ${water} `)}
</PointData><CellData></CellData></Piece></ImageData></VTKFile>`,
    );
    return file;
}

describe('data in which it is not clear which field is the velocity', () => {
    it('ask for it, do not ask again after a reload or a restart, and are shown anew when they are computed again', async () => {
        const [data, state, store] = two.map(({ path }) => path) as [string, string, string];
        const options = {
            data: writeTwoPhases(data),
            state,
            store,
            tokenFile: join(state, 'token'),
        };
        let unclear = await ServerProcess.start(options);
        const context = await newContext(browser, { width: 800, height: 500 });
        const page = await openPage(context, unclear.link);
        const question = page.locator('#velocity-unclear');
        await question
            .getByText('It is not clear which field of two is the velocity. Which field do particles follow?')
            .waitFor();
        expect(await question.getByRole('button').allTextContents()).toEqual(['U.air', 'U.water']);
        await screenshot(page, 'velocity-unclear');
        const place = (await question.getByRole('button', { name: 'U.water' }).boundingBox())!;
        await page.mouse.click(place.x + place.width / 2, place.y + place.height / 2);
        await finalSurface(page);
        expect(await question.count()).toBe(0);
        const followed = async (): Promise<unknown> => {
            const { values } = await unclear.call('probe.sample', {
                dataset: 'two',
                time: 0,
                points: [[2, 2, 2]],
            });
            return values;
        };
        expect(await followed()).toEqual({ 'U.water': [[0, 0, 2]] });

        await page.reload();
        await finalSurface(page);
        expect(await question.count()).toBe(0);

        const { port } = unclear;
        await unclear.stop();
        unclear = await ServerProcess.start({ ...options, port });
        await page.reload();
        await finalSurface(page);
        expect(await question.count()).toBe(0);
        expect(await followed()).toEqual({ 'U.water': [[0, 0, 2]] });

        // Computed again into the same file: the page that shows it and one that is loaded anew meanwhile come to the same.
        const other = await openPage(context, unclear.link);
        await finalSurface(other);
        const speeds = (of: Page): Promise<number[]> =>
            ask(of, (hook) => hook.vertices(1).map(({ scalar }) => Math.round(scalar)));
        expect(new Set(await speeds(page))).toEqual(new Set([2]));
        writeTwoPhases(data, 3);
        await other.reload();
        for (const each of [page, other]) {
            await expect.poll(async () => [...new Set(await speeds(each))], { timeout: 30_000 }).toEqual([3]);
        }
        await page.reload();
        await finalSurface(page);
        expect(new Set(await speeds(page))).toEqual(new Set([3]));
        expect(await followed()).toEqual({ 'U.water': [[0, 0, 3]] });
        await page.close();
        await other.close();
        await unclear.stop();
    });
});
