// How fast Chromium's worker decodes updates of a moving surface: the frames of the file WAKESURF_FRAMES, each behind its
// length, or else a golden file. Prints one line of JSON.
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join, normalize } from 'node:path';
import { build } from 'vite';
import { launchBrowser } from './support/browser_page.ts';
import type { DecodedUpdate } from './support/decode_worker.ts';
import { projectRoot } from './support/project_root.ts';

const rounds = 5;
const golden = join(projectRoot, 'protocol/wire/fixtures/living.bin');
const types: Record<string, string> = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };

/** The worker alone, with Draco beside it. */
async function buildWorker(into: string): Promise<void> {
    await build({
        configFile: false,
        root: join(projectRoot, 'web-client'),
        base: './',
        publicDir: false,
        logLevel: 'error',
        build: {
            outDir: into,
            target: 'es2022',
            assetsInlineLimit: 0,
            modulePreload: false,
            rollupOptions: {
                input: join(projectRoot, 'tests/end_to_end/support/decode_worker.ts'),
                output: { entryFileNames: 'worker.js' },
            },
        },
    });
}

function serve(folder: string, frames: string): Promise<Server> {
    const server = createServer(({ url = '/' }, response) => {
        const path = normalize(url).replace(/^\/+/, '') || 'index.html';
        response.setHeader('Content-Type', types[path.split('.').at(-1) ?? ''] ?? 'application/octet-stream');
        if (path === 'index.html') response.end('<!doctype html>');
        else if (path === 'frames') response.end(readFileSync(frames));
        else if (path.includes('..') || !existsSync(join(folder, path))) response.writeHead(404).end();
        else response.end(readFileSync(join(folder, path)));
    });
    return new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(server)));
}

async function measure(url: string): Promise<DecodedUpdate[]> {
    const browser = await launchBrowser();
    try {
        const page = await browser.newPage();
        await page.goto(url);
        return await page.evaluate(async (count) => {
            const bytes = await (await fetch('frames')).arrayBuffer();
            const view = new DataView(bytes);
            const frames: Uint8Array[] = [];
            for (let at = 0; at < bytes.byteLength; at += 4 + view.getUint32(at, true)) {
                frames.push(new Uint8Array(bytes.slice(at + 4, at + 4 + view.getUint32(at, true))));
            }
            const worker = new Worker('worker.js', { type: 'module' });
            return new Promise<DecodedUpdate[]>((resolve, reject) => {
                worker.onmessage = ({ data }: MessageEvent<{ error: string } | { updates: DecodedUpdate[] }>) =>
                    'error' in data ? reject(new Error(data.error)) : resolve(data.updates);
                worker.onerror = (event) => reject(new Error(event.message));
                worker.postMessage({ frames, rounds: count });
            });
        }, rounds);
    } finally {
        await browser.close();
    }
}

const rounded = (value: number): number => Math.round(value * 100) / 100;

const folder = mkdtempSync(join(tmpdir(), 'wakesurf-'));
try {
    await buildWorker(folder);
    const server = await serve(folder, process.env['WAKESURF_FRAMES'] ?? golden);
    const updates = await measure(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
    server.close();
    const total = (of: (update: DecodedUpdate) => number): number => updates.reduce((sum, update) => sum + of(update), 0);
    const vertices = total((update) => update.vertices);
    const decodeMs = total((update) => update.decodeMs);
    const arraysMs = total((update) => update.arraysMs);
    console.log(
        JSON.stringify({
            name: 'browser-decode',
            updates: updates.length,
            vertices: Math.round(vertices / updates.length),
            decodeMs: rounded(decodeMs / updates.length),
            arraysMs: rounded(arraysMs / updates.length),
            millionVerticesPerSecond: rounded(vertices / decodeMs / 1000),
            millionVerticesPerSecondToArrays: rounded(vertices / (decodeMs + arraysMs) / 1000),
        }),
    );
} finally {
    rmSync(folder, { recursive: true });
}
