// How long after a pointer move a slice of a field of 128^3 nodes is on the screen where it was dragged to, in a picture of 1280 x 800, for
// some 3 s with the real mouse. Prints one line of JSON.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { ask, entered, launchBrowser, newContext, openPage } from './support/browser_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';

const dragMs = 3000;
const nodes = 128;

/** A vortex that winds round x. */
function writeField(folder: string): string {
    const values = new Float32Array(3 * nodes ** 3);
    for (let k = 0, at = 0; k < nodes; ++k) {
        for (let j = 0; j < nodes; ++j) {
            for (let i = 0; i < nodes; ++i) {
                const [y, z] = [j / 64 - 1 + 0.3 * Math.sin(i / 12), k / 64 - 1 + 0.3 * Math.cos(i / 12)];
                const turn = Math.exp(-4 * (y * y + z * z));
                values.set([1, -z * turn, y * turn], at);
                at += 3;
            }
        }
    }
    const [last, bytes] = [nodes - 1, Buffer.from(values.buffer)];
    const head = `<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="0 ${last} 0 ${last} 0 ${last}" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 ${last} 0 ${last} 0 ${last}">
<PointData Vectors="U"><DataArray type="Float32" Name="U" NumberOfComponents="3" format="appended" offset="0"/></PointData>
</Piece></ImageData><AppendedData encoding="raw">_`;
    const length = Buffer.alloc(8);
    length.writeBigUInt64LE(BigInt(bytes.length));
    const path = join(folder, 'vortex.vti');
    writeFileSync(path, Buffer.concat([Buffer.from(head), length, bytes, Buffer.from('</AppendedData></VTKFile>\n')]));
    return path;
}

/** Up and down by its handle, which is in the middle of the domain at first. */
async function drag(page: Page): Promise<void> {
    const middle = (nodes - 1) / 2;
    const at = await page.evaluate((to) => window.wakesurf!.project([to, to, to])!, middle);
    await page.mouse.move(at.x, at.y);
    await page.mouse.down();
    const start = performance.now();
    for (let elapsed = 0; elapsed < dragMs; elapsed = performance.now() - start) {
        await page.mouse.move(at.x, at.y - 60 * Math.sin(elapsed / 400));
    }
    await page.mouse.up();
}

const folder = temporaryFolder();
const server = await ServerProcess.start({ store: join(folder.path, 'store'), data: writeField(folder.path) });
const browser = await launchBrowser(['--disable-gpu-compositing']);
try {
    await server.imported();
    const { datasets } = (await server.call('dataset.list', {})) as { datasets: { dataset: string }[] };
    const link = await server.newSession();
    const session = new URLSearchParams(new URL(link).hash.slice(1)).get('session');
    const middle = (nodes - 1) / 2;
    const plane = { origin: [middle, middle, middle], normal: [0, 0, 1] };
    const { slice } = await server.call('slice.set', { session, dataset: datasets[0]!.dataset, ...plane });
    const page = await openPage(await newContext(browser, { width: 1280, height: 800 }), link);
    await entered(page);
    const whole = (): Promise<unknown> => page.waitForFunction(() => window.wakesurf?.unfinished(null) === '');
    await whole();
    await page.getByRole('button', { name: /^z = / }).first().click();
    await drag(page);
    await whole();
    const lags = (await ask(page, (hook) => hook.sliceLags)).sort((a, b) => a - b);
    const at = (part: number): number => Math.round(lags[Math.floor(part * (lags.length - 1))] ?? Number.NaN);
    const perSecond = Math.round((10_000 * lags.length) / dragMs) / 10;
    console.log(JSON.stringify({ name: 'slice-drag', slice, medianMs: at(0.5), p95Ms: at(0.95), picturesPerSecond: perSecond }));
} finally {
    await browser.close();
    await server.stop();
    folder.remove();
}
