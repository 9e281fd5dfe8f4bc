// The page for everybody: no finding of axe, in both colour schemes, and every control reachable.
import { source as axeSource } from 'axe-core';
import type { Browser } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { finalSurface, launchBrowser, newContext, openPage, screenshot } from './support/browser_page.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';

interface AxeResults {
    violations: { id: string; nodes: { html: string; failureSummary: string }[] }[];
    passes: unknown[];
}

const store = temporaryFolder();
let server: ServerProcess;
let browser: Browser;

beforeAll(async () => {
    server = await ServerProcess.start({ store: store.path });
    browser = await launchBrowser();
});

afterAll(async () => {
    await browser?.close();
    await server?.stop();
    store.remove();
});

describe('accessibility', () => {
    it.each(['dark', 'light'] as const)('has no violation in the %s scheme', async (colorScheme) => {
        const context = await newContext(browser, { colorScheme });
        const { page } = await openPage(context, server.link);
        await finalSurface(page);
        // Through the debugger, past the content security policy of the page.
        await page.evaluate(axeSource);
        const found = (await page.evaluate('axe.run()')) as AxeResults;
        const findings = found.violations.map(({ id, nodes }) => [id, nodes[0]?.html, nodes[0]?.failureSummary]);
        expect(findings).toEqual([]);
        expect(found.passes.length).toBeGreaterThan(20);
        await screenshot(page, `scheme-${colorScheme}`);
        await context.close();
    });

    it('names every control', async () => {
        const context = await newContext(browser);
        const { page } = await openPage(context, server.link);
        await finalSurface(page);
        for (const name of ['Start', 'Middle', 'End']) {
            expect(await page.getByRole('button', { name, exact: true }).count()).toBe(1);
        }
        for (const end of ['Start', 'End']) {
            for (const axis of ['x', 'y', 'z']) {
                expect(await page.getByRole('spinbutton', { name: `${end} ${axis}` }).count()).toBe(1);
            }
        }
        expect(await page.getByRole('slider', { name: 'Integration time' }).count()).toBe(1);
        expect(await page.getByRole('figure', { name: /Speed from/ }).count()).toBe(1);
        await context.close();
    });
});
