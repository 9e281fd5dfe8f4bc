// The page for everyone: no finding of axe, in both colour schemes, and every control reachable.
import { source as axeSource } from 'axe-core';
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { useTestRig } from './support/test_rig.ts';

interface Findings {
    /** What is wrong, the first place where, and why. */
    violations: [string, string, string][];
    /** How many rules found what they look at, and nothing wrong. */
    passes: number;
}

/** Runs in the page: what axe says of a hundred elements that are right stays there. */
const findings = (rules: readonly string[]): string => `axe.run({
    resultTypes: ['violations'],
    ...(${JSON.stringify(rules)}.length === 0 ? {} : { runOnly: ${JSON.stringify(rules)} }),
}).then(({ violations, passes }) => ({
    violations: violations.map(({ id, nodes }) => [id, nodes[0].html, nodes[0].failureSummary]),
    passes: passes.length,
}))`;

const rig = useTestRig();

/** Through the debugger, past the content security policy of the page. */
async function expectNoFindings(page: Page, where: string): Promise<void> {
    const { violations, passes } = await page.evaluate<Findings>(findings([]));
    expect(violations, where).toEqual([]);
    expect(passes).toBeGreaterThan(20);
    // Between the schemes nothing but colours changes.
    await page.emulateMedia({ colorScheme: 'light' });
    await page.evaluate(() => Promise.all(document.getAnimations().map(({ finished }) => finished)));
    const light = await page.evaluate<Findings>(findings(['color-contrast']));
    expect(light, `${where}, light`).toEqual({ violations: [], passes: 1 });
    await page.emulateMedia({ colorScheme: 'dark' });
}

it('the page has no violation on any tab and in no dialog, in both colour schemes', async () => {
    const page = await rig.visit({ firstVisit: true });
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
    const { session } = await rig.server.call('session.create', { name: 'Deleted' });
    await rig.server.call('session.delete', { session });
    await page.getByRole('button', { name: 'Sessions' }).click();
    await page.getByRole('list', { name: 'Sessions on this server' }).waitFor();
    await expectNoFindings(page, 'sessions');
    await page.getByRole('button', { name: /^Trash/ }).click();
    await page.getByText('Deleted', { exact: true }).waitFor();
    await expectNoFindings(page, 'trash');
});

it('the time controls come before the settings for whoever goes by keyboard, and a switch that is on is seen in high contrast', async () => {
    const page = await rig.visit();
    const name = (): Promise<string | null> =>
        page.evaluate(() => {
            let at = document.activeElement;
            while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
            return at?.getAttribute('aria-label') ?? null;
        });
    await page.getByRole('img', { name: /The surface in the flow/ }).focus();
    let stops = 0;
    while ((await name()) !== 'Play' && ++stops < 30) await page.keyboard.press('Tab');
    expect(stops).toBeLessThan(30);
    await page.emulateMedia({ forcedColors: 'active' });
    const loop = page.getByRole('button', { name: 'Loop' });
    const ground = (): Promise<string> => loop.evaluate((element) => getComputedStyle(element).backgroundColor);
    await loop.click();
    await page.mouse.move(5, 5);
    const off = await ground();
    await loop.click();
    await page.mouse.move(5, 5);
    expect(await ground()).not.toBe(off);
    await page.context().close();
});
