// What new states of a surface cost the page's main thread: the scene takes them and submits a frame, in real Chromium. Prints one
// line of JSON: 100 000 vertices that all move, 10 000 that come to a surface of 100 000, and the same on 500 000 quads.
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join, normalize } from 'node:path';
import { build } from 'vite';
import { resolveFromWebClient } from '../../web-client/tools/resolve_from_web_client.js';
import { launchBrowser } from './support/browser_page.ts';
import { projectRoot } from './support/project_root.ts';
import type { UploadCosts } from './support/upload_page.ts';

const types: Record<string, string> = { js: 'text/javascript', html: 'text/html' };

async function buildPage(into: string): Promise<void> {
    await build({
        configFile: false,
        root: join(projectRoot, 'web-client'),
        base: './',
        publicDir: false,
        logLevel: 'error',
        plugins: [resolveFromWebClient(join(projectRoot, 'tests/end_to_end/'))],
        build: {
            outDir: into,
            target: 'es2022',
            modulePreload: false,
            rollupOptions: {
                input: join(projectRoot, 'tests/end_to_end/support/upload_page.ts'),
                output: { entryFileNames: 'page.js' },
            },
        },
    });
}

const folder = mkdtempSync(join(tmpdir(), 'wakesurf-'));
const browser = await launchBrowser();
try {
    await buildPage(folder);
    const server = createServer(({ url = '/' }, response) => {
        const path = normalize(url).replace(/^\/+/, '') || 'index.html';
        response.setHeader('Content-Type', types[path.split('.').at(-1) ?? ''] ?? 'application/octet-stream');
        if (path === 'index.html') response.end('<!doctype html><script type="module" src="page.js"></script>');
        else if (path === 'page.js') response.end(readFileSync(join(folder, path)));
        else response.writeHead(404).end();
    });
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    const page = await browser.newPage({ viewport: { width: 640, height: 400 } });
    await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
    await page.waitForFunction(() => window.uploadCosts !== undefined);
    const costs: UploadCosts = await page.evaluate(() => window.uploadCosts!());
    server.close();
    console.log(JSON.stringify({ name: 'browser-uploads', ...costs }));
} finally {
    await browser.close();
    rmSync(folder, { recursive: true });
}
