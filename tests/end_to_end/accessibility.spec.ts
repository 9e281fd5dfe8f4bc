// The page for everyone: no finding of axe, in both colour schemes, and every control reachable.
import { source as axeSource } from 'axe-core';
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { useStand } from './support/stand.ts';

interface Findings {
    /** What is wrong, the first place where, and why. */
    violations: [string, string, string][];
    /** How many rules found what they look at, and nothing wrong. */
    passes: number;
}

/** Runs in the page: what axe says of a hundred elements that are right stays there. */
const findings = `axe.run({ resultTypes: ['violations'] }).then(({ violations, passes }) => ({
    violations: violations.map(({ id, nodes }) => [id, nodes[0].html, nodes[0].failureSummary]),
    passes: passes.length,
}))`;

const stand = useStand();

/** Through the debugger, past the content security policy of the page. */
async function expectNoFindings(page: Page, where: string): Promise<void> {
    const { violations, passes } = await page.evaluate<Findings>(findings);
    expect(violations, where).toEqual([]);
    expect(passes).toBeGreaterThan(20);
}

describe('accessibility', () => {
    it.each(['dark', 'light'] as const)('has no violation on any tab and in no dialog in the %s scheme', async (colorScheme) => {
        const page = await stand.visit({ colorScheme, firstVisit: true });
        await page.evaluate(axeSource);
        await expectNoFindings(page, 'tour');
        await page.getByRole('button', { name: 'Skip the tour' }).click();
        const tabs = await page.getByRole('tab').all();
        expect(tabs).toHaveLength(5);
        for (const tab of tabs) {
            await tab.click();
            // What is folded away counts as well.
            const folded = page.locator('[role=tabpanel] details:not([open]) > summary');
            while ((await folded.count()) > 0) await folded.first().click();
            await expectNoFindings(page, (await tab.textContent())!.trim());
        }
        await page.keyboard.press('?');
        await page.getByRole('dialog').waitFor();
        await expectNoFindings(page, 'help');
        await page.getByRole('button', { name: 'Close' }).click();
        const { session } = await stand.server.call('session.create', { name: `Deleted ${colorScheme}` });
        await stand.server.call('session.delete', { session });
        await page.getByRole('button', { name: 'Sessions' }).click();
        await page.getByRole('list', { name: 'Sessions on this server' }).waitFor();
        await expectNoFindings(page, 'sessions');
        await page.getByRole('button', { name: /^Trash/ }).click();
        await page.getByText(`Deleted ${colorScheme}`).waitFor();
        await expectNoFindings(page, 'trash');
        await page.getByRole('button', { name: 'Close' }).click();
        await page.context().close();
    });

    it('names every control', async () => {
        const page = await stand.visit();
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
        await page.context().close();
    });
});
