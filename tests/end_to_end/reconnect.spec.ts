// Bad networks and restarted servers: the page says what is wrong and goes on by itself.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { allowLostConnections } from './support/complaints.ts';
import { NetworkProxy } from './support/network_proxy.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { bundledStore, ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const folder = temporaryFolder();
const store = bundledStore();
const tokenFile = join(folder.path, 'token');
let server: ServerProcess;
let network: NetworkProxy;
let browser: Browser;
let context: BrowserContext;

beforeAll(async () => {
    writeFileSync(tokenFile, 'a-token-that-survives-a-restart-0123456789abcdef\n', { mode: 0o600 });
    server = await ServerProcess.start({ store, tokenFile });
    network = await NetworkProxy.start();
    browser = await testBrowser();
});

afterEach(async () => context?.close());

afterAll(async () => {
    await closePages();
    network?.stop();
    await server?.stop();
    folder.remove();
});

async function open(link: string): Promise<Page> {
    context = await newContext(browser);
    const page = await openPage(context, link);
    return page;
}

function connectionIs(page: Page, wanted: 'open' | 'down', timeout: number): Promise<unknown> {
    return page.waitForFunction((state) => (window.wakesurf?.connection === 'open') === (state === 'open'), wanted, { timeout });
}

describe('the connection', () => {
    beforeEach(allowLostConnections);

    it('resumes after the server was killed and started again, with the same rake', async () => {
        const page = await open(server.link);
        await finalSurface(page);
        // Of one that moves another state follows, with the error between stored times.
        await page.getByRole('radio', { name: 'Stream' }).check();
        await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
        await page.getByRole('textbox', { name: 'Start x' }).fill('-2');
        await page.keyboard.press('Enter');
        await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 2);
        await finalSurface(page);
        const before = await ask(page, (hook) => hook.displayed);
        await server.stop('SIGKILL');
        const banner = page.getByText(/Connection lost/);
        await banner.waitFor();

        const camera = await ask(page, (hook) => hook.camera);
        await page.mouse.move(400, 80);
        await page.mouse.down();
        await page.mouse.move(440, 100, { steps: 3 });
        await page.mouse.up();
        expect(await ask(page, (hook) => hook.camera)).not.toEqual(camera);

        server = await ServerProcess.start({ store, tokenFile, port: server.port });
        await connectionIs(page, 'open', 30_000);
        await finalSurface(page);
        await banner.waitFor({ state: 'hidden' });
        const after = await ask(page, (hook) => hook.displayed);
        // Made again in other passes, the same surface may have its vertices in another order.
        expect(after).toMatchObject({ vertices: before?.vertices, cells: before?.cells });
        await expectServersMesh(server, page);
        expect((await ask(page, (hook) => hook.rakePoints))[0]?.[0]).toBe(-2);
    });

    it('resumes when a network that was cut is back', async () => {
        network.lead(server.port);
        const page = await open(`${network.origin}/${new URL(server.link).hash}`);
        await finalSurface(page);
        const session = await ask(page, (hook) => hook.session);
        const before = await ask(page, (hook) => hook.displayed);
        network.cut();
        await connectionIs(page, 'down', 30_000);
        await page.getByText(/Connection lost/).waitFor();
        // The mesh stays, and nothing has happened to it meanwhile.
        expect(await ask(page, (hook) => hook.displayed)).toEqual(before);
        network.mend();
        await connectionIs(page, 'open', 30_000);
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.session)).toBe(session);
        expect(await ask(page, (hook) => hook.displayed)).toEqual(before);
        // It goes on from there.
        await page.getByRole('textbox', { name: 'Start x' }).fill('-1.5');
        await page.keyboard.press('Enter');
        await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before?.epoch ?? 0);
        await finalSurface(page);
    });
});

describe('a page without WebGL2', () => {
    it('says that it cannot work', async () => {
        context = await newContext(browser);
        await context.addInitScript(() => {
            HTMLCanvasElement.prototype.getContext = () => null;
        });
        const page = await openPage(context, server.link);
        await page.getByText(/not offer WebGL2/).waitFor();
    });
});
