// Data of which it is not clear which field is the velocity: the page asks, and shows data anew that are computed again.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, describe, expect, it } from 'vitest';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const folders = [temporaryFolder(), temporaryFolder(), temporaryFolder()] as const;

afterAll(async () => {
    await closePages();
    for (const folder of folders) folder.remove();
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
    it('ask for it, do not ask again after a restart, and are shown anew when they are computed again', async () => {
        const [data, state, store] = folders.map(({ path }) => path) as [string, string, string];
        const options = {
            data: writeTwoPhases(data),
            state,
            store,
            tokenFile: join(state, 'token'),
        };
        let unclear = await ServerProcess.start(options);
        const context = await newContext(await testBrowser(), { width: 780, height: 420 });
        const page = await openPage(context, unclear.link);
        const question = page.locator('#velocity-unclear');
        await question
            .getByText('It is not clear which field of two is the velocity. Which field do particles follow?')
            .waitFor();
        expect(await question.getByRole('button').allTextContents()).toEqual(['U.air', 'U.water']);
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
