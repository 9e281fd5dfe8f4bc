// What a whole state costs from the server's frames to the picture, stage by stage, for surfaces of some 10,000 and 100,000 quads in the bundled
// simulation: bytes on the wire and how long they travel, milliseconds in the worker and on the page, bytes for the GPU. Medians; prints
// a line of JSON for each surface.
import WebSocket from 'ws';
import type { Subscription } from '../../web-client/src/protocol/messages.ts';
import { launchBrowser } from './support/browser_page.ts';
import { openBundledPage } from './support/bundled_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';

const rounds = 25;
const separations = [0.155, 0.0484];
const linksMbits = [10, 100, 1000];

interface WholeState {
    agreed: Subscription;
    frames: Buffer[];
}

/** As someone gets it who comes when the surface is final. */
function wholeState(server: ServerProcess, session: unknown, surface: unknown): Promise<WholeState> {
    const socket = new WebSocket(new URL('/ws', server.link.replace(/^http/, 'ws')), {
        headers: { Authorization: `Bearer ${server.token}` },
    });
    const call = (id: number, method: string, params: object): void => {
        socket.send(JSON.stringify({ jsonrpc: '2.0', id, method, params }));
    };
    return new Promise((resolve, reject) => {
        let agreed: Subscription | null = null;
        const frames: Buffer[] = [];
        socket.on('open', () => call(1, 'session.join', { session }));
        socket.on('error', reject);
        socket.on('message', (data: Buffer, isFrame) => {
            if (!isFrame) {
                const { id, result } = JSON.parse(data.toString()) as { id?: number; result?: Subscription };
                if (id === 1) call(2, 'surface.subscribe', { surface });
                if (id === 2) agreed = result!;
                return;
            }
            frames.push(data);
            if (agreed === null || data.readUInt16LE(16) + 1 < data.readUInt16LE(18)) return;
            socket.close();
            resolve({ agreed, frames });
        });
    });
}

const rounded = (value: number): number => Math.round(value * 10) / 10;
const median = (values: number[]): number => rounded(values.sort((a, b) => a - b)[values.length >> 1] ?? Number.NaN);

const store = temporaryFolder();
const server = await ServerProcess.start({ store: store.path });
const browser = await launchBrowser();
try {
    await server.imported();
    const { session } = await server.call('session.create', {});
    const { datasets } = (await server.call('dataset.list', {})) as { datasets: { dataset: string }[] };
    const { dataset } = datasets[0]!;
    const found = (await server.call('dataset.suggest', { dataset })) as { rake: object; surfaces: { kind: string }[] };
    const { rake } = await server.call('rake.set', { session, ...found.rake });
    const stream = found.surfaces.find(({ kind }) => kind === 'stream');
    for (const separation of separations) {
        const { surface } = await server.call('surface.set', { session, rake, dataset, ...stream, separation });
        const { quads } = await server.call('surface.wait', { session, surface, timeoutMs: 60_000 });
        const { agreed, frames } = await wholeState(server, session, surface);
        const { page, close } = await openBundledPage(browser, 'state_page.ts', { width: 1280, height: 720 });
        await page.waitForFunction(() => window.stateCosts !== undefined);
        const coded = frames.map((frame) => frame.toString('base64'));
        const costs = await page.evaluate(([of, as, times]) => window.stateCosts!(of, as, times), [
            coded,
            agreed,
            rounds,
        ] as const);
        await close();
        const { uploadedBytes, ...stages } = costs;
        const ms = Object.fromEntries(Object.entries(stages).map(([stage, each]) => [stage, median(each)]));
        const bytes = frames.reduce((sum, { length }) => sum + length, 0);
        const travelMs = Object.fromEntries(linksMbits.map((link) => [link, rounded((8 * bytes) / link / 1000)]));
        console.log(JSON.stringify({ name: 'browser-state', quads, bytes, travelMs, ...ms, uploadedBytes, rounds }));
    }
} finally {
    await browser.close();
    await server.stop();
    store.remove();
}
