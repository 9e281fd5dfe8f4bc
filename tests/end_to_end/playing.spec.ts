// A streak surface that moves with the session's clock: what the page plays are changes of the state before, and where
// it stops is the server's state, whatever happened to the network meanwhile.
import type { BrowserContext, Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { ask, finalSurface, newContext, openPage, screenshot } from './support/browser_page.ts';
import { allowLostConnections } from './support/complaints.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
let context: BrowserContext;
let page: Page;

beforeEach(async () => {
    context = await newContext(stand.browser, { width: 860, height: 700 });
    page = await openPage(context, await stand.networkLink());
    await finalSurface(page);
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    // Half a minute from the end, where the loop starts again with nothing to be seen.
    await page.locator('#speed').selectOption('0.25');
    await page.locator('#go-to').fill('11');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.wakesurf!.displayed!.time === 11);
    await finalSurface(page);
});

afterEach(async () => {
    stand.network.mend();
    await context.close();
});

interface Played {
    time: number;
    keys: number;
    deltas: number;
}

function played(): Promise<Played> {
    return ask(page, ({ displayed }) => ({
        time: displayed!.time,
        keys: displayed!.keys,
        deltas: displayed!.deltas,
    }));
}

/** At least so many changes more than then have been applied. */
function playsOn({ deltas }: Played, more: number): Promise<unknown> {
    return page.waitForFunction((least) => window.wakesurf!.displayed!.deltas >= least, deltas + more);
}

describe('a streak surface', () => {
    it('plays by changes of the state before, and stops at the state of the server', async () => {
        await page.getByRole('button', { name: 'Play' }).click();
        await page.waitForFunction(() => window.wakesurf?.phase === 'live');
        const begun = await played();
        await playsOn(begun, 20);
        await screenshot(page, 'playing');
        const later = await played();
        // A page that cannot keep up is sent whole states in between.
        expect(later.keys - begun.keys).toBeLessThan(later.deltas - begun.deltas);
        expect(later.time).not.toBe(begun.time);
        await page.getByRole('button', { name: 'Pause' }).click();
        await expectServersMesh(stand.server, page);
        await screenshot(page, 'paused');
    });

    it('goes on from the state it has after a short cut of the network', async () => {
        allowLostConnections();
        await page.getByRole('button', { name: 'Play' }).click();
        await page.waitForFunction(() => window.wakesurf?.phase === 'live');
        // What was missed is kept for five seconds, and a loop starts again. Where the machine is so busy that one of them came
        // between, it was no short cut.
        for (let tries = 1, short = false; !short; ++tries) {
            expect(tries).toBeLessThan(6);
            await playsOn(await played(), 5);
            const begun = performance.now();
            stand.network.cut();
            await page.waitForFunction(() => window.wakesurf?.connection !== 'open');
            const before = await played();
            stand.network.mend();
            // What was under way may still have been drawn: news of the new connection count, and before it nothing can be clicked.
            await page.waitForFunction(() => window.wakesurf?.connection === 'open');
            await page.waitForFunction(
                ({ keys, deltas }) => window.wakesurf!.displayed!.keys + window.wakesurf!.displayed!.deltas > keys + deltas,
                await played(),
            );
            const after = await played();
            short = performance.now() - begun < 4000 && after.time > before.time;
            if (short) expect(after.keys).toBe(before.keys);
        }
        await page.getByRole('button', { name: 'Pause' }).click();
        await expectServersMesh(stand.server, page);
    });
});
