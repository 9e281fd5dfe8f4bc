// A server that died again and again while it started, as a page sees the next one: nothing is computed, the page says so, and has a
// button for it.
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { allowLostConnections } from './support/complaints.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const [store, state] = [temporaryFolder(), temporaryFolder()];
let server: ServerProcess;
let page: Page;

function start(port = 0): Promise<ServerProcess> {
    return ServerProcess.start({ port, store: store.path, state: state.path, data: 'flow:lamb-oseen' });
}

beforeAll(async () => {
    allowLostConnections();
    server = await start();
    page = await openPage(await newContext(await testBrowser(), {}), server.link);
    await finalSurface(page);
    const { port } = server;
    for (let i = 0; i < 3; ++i) {
        await server.stop('SIGKILL');
        server = await start(port);
    }
});

afterAll(async () => {
    await closePages();
    await server?.stop();
    store.remove();
    state.remove();
});

const status = (): Promise<string | null> => page.locator('wakesurf-status').getByRole('status').textContent();

describe('after a careful start', () => {
    it('the page says that a surface is not computed, and computes it on request', async () => {
        await page.goto('about:blank');
        await page.goto(server.link);
        await page.waitForFunction(() => window.wakesurf?.stage === 'running');
        await expect.poll(status).toBe('Not computed');
        await page.getByRole('button', { name: 'Compute it' }).click();
        await finalSurface(page);
        expect(await status()).toMatch(/^Final/);
        expect(await ask(page, (hook) => hook.displayed!.vertices)).toBeGreaterThan(10);
    });
});
