// A page for measurements and tests of the scene alone, without a server: one module of support/, bundled as the page is.
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join, normalize } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { build } from 'vite';
import { resolveFromWebClient } from '../../../web-client/tools/resolve_from_web_client.js';
import { projectRoot } from './project_root.ts';
import { temporaryFolder } from './server_process.ts';

const types: Record<string, string> = { js: 'text/javascript', wasm: 'application/wasm', html: 'text/html' };

const built = new Map<string, Promise<string>>();

/** The folder of a page, made once for all files of tests. It goes with the process. */
function pageOf(module: string): Promise<string> {
    const made = built.get(module) ?? buildPage(module);
    built.set(module, made);
    return made;
}

async function buildPage(module: string): Promise<string> {
    const { path, remove } = temporaryFolder();
    process.once('exit', remove);
    await build({
        configFile: false,
        root: join(projectRoot, 'web-client'),
        base: './',
        publicDir: false,
        logLevel: 'error',
        plugins: [resolveFromWebClient(join(projectRoot, 'tests/end_to_end/'))],
        build: {
            outDir: path,
            target: 'es2022',
            assetsInlineLimit: 0,
            modulePreload: false,
            rollupOptions: {
                input: join(projectRoot, 'tests/end_to_end/support', module),
                output: { entryFileNames: 'page.js' },
            },
        },
    });
    return path;
}

export interface BundledPage {
    page: Page;
    close: () => Promise<void>;
}

/** @param module  a file of support/ */
export async function openBundledPage(
    browser: Browser,
    module: string,
    viewport: { width: number; height: number },
): Promise<BundledPage> {
    const folder = await pageOf(module);
    const server = createServer(({ url = '/' }, response) => {
        const path = normalize(url).replace(/^\/+/, '') || 'index.html';
        response.setHeader('Content-Type', types[path.split('.').at(-1) ?? ''] ?? 'application/octet-stream');
        if (path === 'index.html') response.end('<!doctype html><script type="module" src="page.js"></script>');
        else if (/\.(js|wasm)$/.test(path)) response.end(readFileSync(join(folder, path)));
        else response.writeHead(404).end();
    });
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    const page = await browser.newPage({ viewport });
    await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`);
    const close = async (): Promise<void> => {
        await page.close();
        server.close();
    };
    return { page, close };
}
