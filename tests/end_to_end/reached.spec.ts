// Where people are when they open the page: behind a tunnel to another port, below a prefix of a proxy with two servers beside each
// other, with a tab that is older than the server.
import { join } from 'node:path';
import type { Browser, BrowserContext } from 'playwright-core';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { ask, entered, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { allowLostConnections } from './support/complaints.ts';
import { NetworkProxy } from './support/network_proxy.ts';
import { PrefixProxy } from './support/prefix_proxy.ts';
import { bundledStore, ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const folder = temporaryFolder();
const store = bundledStore();
let browser: Browser;
let context: BrowserContext;

beforeAll(async () => {
    browser = await testBrowser();
});

afterEach(async () => context?.close());

afterAll(async () => {
    await closePages();
    folder.remove();
});

/** The fragment of what a server has printed, at another address of it. */
function at(address: string, server: ServerProcess): string {
    return `${address}${new URL(server.link).hash}`;
}

describe('a server elsewhere', () => {
    it('is reached below a prefix, beside another one, and each keeps its login', async () => {
        const proxy = await PrefixProxy.start();
        const [first, second] = [
            await ServerProcess.start({ store, origin: proxy.origin }),
            await ServerProcess.start({ store, origin: proxy.origin }),
        ];
        try {
            proxy.lead('/a/', first.port);
            proxy.lead('/b/', second.port);
            context = await newContext(browser, { width: 780, height: 420 });
            for (const [prefix, server] of [
                ['/a/', first],
                ['/b/', second],
            ] as const) {
                const page = await openPage(context, at(`${proxy.origin}${prefix}`, server));
                await finalSurface(page);
                await page.close();
            }
            expect(await context.cookies()).toEqual([]);
            for (const prefix of ['/a/', '/b/']) {
                const page = await openPage(context, `${proxy.origin}${prefix}`);
                await entered(page);
                await page.close();
            }
        } finally {
            proxy.stop();
            await Promise.all([first.stop(), second.stop()]);
        }
    });
});

describe('a server that was started again', () => {
    beforeEach(allowLostConnections);

    it('lets in a page that was reloaded before, and a second tab', async () => {
        const options = {
            store,
            tokenFile: join(folder.path, 'token'),
            state: join(folder.path, 'state'),
        };
        let server = await ServerProcess.start(options);
        try {
            context = await newContext(browser, { width: 780, height: 420 });
            const page = await openPage(context, server.link);
            const session = await entered(page);
            await page.reload();
            await entered(page);
            const { port } = server;
            await server.stop('SIGKILL');
            await page.getByText(/Connection lost/).waitFor();
            server = await ServerProcess.start({ ...options, port });
            expect(await entered(page)).toBe(session);
            const tab = await openPage(context, page.url());
            expect(await entered(tab)).toBe(session);
        } finally {
            await server.stop();
        }
    });

    it('is reached through a tunnel with no option, and entered through one on another port by the link that it printed, whatever address is in that', async () => {
        const server = await ServerProcess.start({ store });
        const [tunnel, tomorrow] = [await NetworkProxy.start(), await NetworkProxy.start()];
        try {
            for (const each of [tunnel, tomorrow]) each.lead(server.port);
            context = await newContext(browser, { width: 780, height: 420 });
            const page = await openPage(context, at(`http://localhost:${tunnel.port}/`, server));
            const session = await entered(page);
            await page.reload();
            expect(await entered(page)).toBe(session);
            const other = `http://localhost:${tomorrow.port}/`;
            await page.goto(`${other}#session=${session}`);
            await page.getByText(`this browser is not logged in at ${other.slice(0, -1)}`).waitFor();
            await page.getByText('through a tunnel with another port it is needed again').waitFor();
            await page.getByRole('textbox', { name: 'New link' }).fill(server.link);
            await page.keyboard.press('Enter');
            expect(await entered(page)).toBe(session);
            expect(page.url().split('&')[0]).toBe(`${other}#session=${session}`);
        } finally {
            for (const each of [tunnel, tomorrow]) each.stop();
            await server.stop();
        }
    });

    it('keeps the picture of pages that it does not let in any more, and lets both in by the link that one has pasted', async () => {
        const state = join(folder.path, 'other-state');
        let server = await ServerProcess.start({ store, state });
        try {
            context = await newContext(browser, { width: 780, height: 420 });
            const page = await openPage(context, server.link);
            await finalSurface(page);
            const session = await entered(page);
            const second = await openPage(context, server.link);
            expect(await entered(second)).toBe(session);
            const before = await ask(page, (hook) => hook.displayed!);
            const { port } = server;
            await server.stop('SIGKILL');
            server = await ServerProcess.start({ store, state, port });
            const banner = page.getByText(/does not accept the access token/);
            await banner.waitFor({ timeout: 20_000 });
            await second.getByText(/does not accept the access token/).waitFor({ timeout: 20_000 });
            expect(await ask(page, (hook) => hook.displayed!.stateSum)).toBe(before.stateSum);
            expect(await page.getByRole('img', { name: /The surface in the flow/ }).isVisible()).toBe(true);
            const field = page.getByRole('textbox', { name: 'New link' });
            await field.fill('no link');
            await page.keyboard.press('Enter');
            await page.getByText(/There is no token in this/).waitFor();
            await field.fill(`wakesurf: ${server.link}`);
            await page.keyboard.press('Enter');
            await banner.waitFor({ state: 'hidden' });
            for (const each of [page, second]) {
                expect(await entered(each)).toBe(session);
            }
            expect(page.url()).not.toContain('token');
        } finally {
            await server.stop();
        }
    });
});
