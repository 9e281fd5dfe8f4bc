// Bad networks and restarted servers: the page says what is wrong and goes on by itself.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { ask, finalSurface, newContext, openPage, screenshot } from './support/browser_page.ts';
import { allowLostConnections } from './support/complaints.ts';
import { dragHandle } from './support/rake_drag.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const folder = temporaryFolder();
const store = join(folder.path, 'store');
const tokenFile = join(folder.path, 'token');
let server: ServerProcess;
let browser: Browser;
let context: BrowserContext;

beforeAll(async () => {
    writeFileSync(tokenFile, 'a-token-that-survives-a-restart-0123456789abcdef\n', { mode: 0o600 });
    server = await ServerProcess.start({ store, tokenFile });
    browser = await testBrowser();
});

afterEach(async () => context?.close());

afterAll(async () => {
    await closePages();
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
        await page.getByRole('spinbutton', { name: 'Start x' }).fill('-2');
        await page.keyboard.press('Enter');
        await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
        await finalSurface(page);
        const before = await ask(page, (hook) => hook.displayed);
        await server.stop('SIGKILL');
        const banner = page.getByText(/Connection lost/);
        await banner.waitFor();
        await screenshot(page, 'connection-lost');

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

    it('comes back by itself to the session that a server with --state has kept', async () => {
        const kept = { store, tokenFile, state: join(folder.path, 'state') };
        let keeping = await ServerProcess.start(kept);
        try {
            const page = await open(keeping.link);
            await finalSurface(page);
            const epoch = (await ask(page, (hook) => hook.displayed))?.epoch ?? 0;
            await dragHandle(page, 1, 30, 20, 6);
            await page.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, epoch);
            await expectServersMesh(keeping, page);
            const session = await ask(page, (hook) => hook.session);
            const rake = await ask(page, (hook) => hook.rakePoints);
            const before = await ask(page, (hook) => hook.displayed!);
            await keeping.stop('SIGKILL');
            await connectionIs(page, 'down', 30_000);
            keeping = await ServerProcess.start({ ...kept, port: keeping.port });
            await connectionIs(page, 'open', 30_000);
            await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before.epoch);
            await expectServersMesh(keeping, page);
            expect(await ask(page, (hook) => hook.session)).toBe(session);
            expect(await ask(page, (hook) => hook.rakePoints)).toEqual(rake);
            const after = await ask(page, (hook) => hook.displayed);
            expect(after).toMatchObject({ vertices: before.vertices, cells: before.cells });
            const { rakes } = await keeping.call('rake.list', { session });
            expect(rakes).toHaveLength(1);
        } finally {
            await keeping.stop();
        }
    });

    it('notices by itself that the network is silent, and resumes when it is back', async () => {
        const page = await open(server.link);
        await finalSurface(page);
        const session = await ask(page, (hook) => hook.session);
        const before = await ask(page, (hook) => hook.displayed);
        await context.setOffline(true);
        await connectionIs(page, 'down', 40_000); // after 10 s of silence (connection/liveSocket.spec.ts)
        await page.getByText(/Connection lost/).waitFor();
        // The mesh stays, and nothing has happened to it meanwhile.
        expect(await ask(page, (hook) => hook.displayed)).toEqual(before);
        await context.setOffline(false);
        await connectionIs(page, 'open', 30_000);
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.session)).toBe(session);
        expect(await ask(page, (hook) => hook.displayed)).toEqual(before);
        // It goes on from there.
        await page.getByRole('spinbutton', { name: 'Start x' }).fill('-1.5');
        await page.keyboard.press('Enter');
        await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before?.epoch ?? 0);
        await finalSurface(page);
    });
});

describe('a page that cannot work says why', () => {
    it('without a token', async () => {
        const page = await open(server.link.replace(/#.*/, ''));
        await page.getByText(/needs the access token/).waitFor();
    });

    it('with a wrong token', async () => {
        const page = await open(server.link.replace(/token=.*/, 'token=wrong'));
        await page.getByText(/does not accept the access token/).waitFor();
        expect(page.url()).not.toContain('token');
    });

    it('without WebGL2', async () => {
        context = await newContext(browser);
        await context.addInitScript(() => {
            HTMLCanvasElement.prototype.getContext = () => null;
        });
        const page = await openPage(context, server.link);
        await page.getByText(/not offer WebGL2/).waitFor();
    });
});
