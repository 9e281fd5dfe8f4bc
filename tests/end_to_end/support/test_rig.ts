// One server for the tests of a file, and people who visit.
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll } from 'vitest';
import { finalSurface, newContext, openPage, type PageOptions } from './browser_page.ts';
import { NetworkProxy } from './network_proxy.ts';
import { bundledStore, ServerProcess } from './server_process.ts';
import { closePages, testBrowser } from './test_browser.ts';

export class TestRig {
    server!: ServerProcess;
    browser!: Browser;
    /** Between the server and those who come by `networkLink`. */
    network!: NetworkProxy;

    /** Someone with a browser of their own, neither cookies nor choices are shared; without a link, in a session of their own that
     *  begins with a stream surface. */
    async visit(options: PageOptions & { link?: string } = {}): Promise<Page> {
        const context = await newContext(this.browser, options);
        const page = await openPage(context, options.link ?? (await this.server.streamSession()));
        await finalSurface(page);
        return page;
    }

    /** To a session of its own, through the network. */
    async networkLink(): Promise<string> {
        return `${this.network.origin}/${new URL(await this.server.streamSession()).hash}`;
    }

    /** Another window of the same browser. */
    async open(beside: Page, link: string): Promise<Page> {
        const page = await openPage(beside.context(), link);
        await finalSurface(page);
        return page;
    }

    /** A number of the server's metrics. @param name  with its labels */
    async metric(name: string): Promise<number> {
        const { origin } = new URL(this.server.link);
        const answer = await fetch(`${origin}/metrics`, { headers: { Authorization: `Bearer ${this.server.token}` } });
        const line = (await answer.text()).split('\n').find((each) => each.startsWith(`${name} `));
        return Number(line!.slice(name.length));
    }

    async close(): Promise<void> {
        await closePages();
        await this.server?.stop();
        this.network?.stop();
    }
}

/** To be called at the top of a file of tests. @param more  datasets beside the bundled one */
export function useTestRig(more: readonly string[] = []): TestRig {
    const rig = new TestRig();
    beforeAll(async () => {
        rig.network = await NetworkProxy.start();
        rig.server = await ServerProcess.start({ store: bundledStore(), origin: rig.network.origin, more });
        await rig.server.imported();
        rig.network.lead(rig.server.port);
        rig.browser = await testBrowser();
    });
    afterAll(() => rig.close());
    return rig;
}
