// A streak surface that moves with the session's clock: what the page plays are changes of the state before, and where
// it stops is the server's state.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 860, height: 700 });
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    // Half a minute from the end, where the loop starts again with nothing to be seen.
    await page.locator('#speed').selectOption('0.25');
    await page.locator('#go-to').fill('11');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.wakesurf!.displayed!.time === 11);
    await finalSurface(page);
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
    it('plays by changes of the state before, in fewer pixels, and stops at the state of the server in all of them', async () => {
        await page.getByRole('button', { name: 'Play' }).click();
        await page.waitForFunction(() => window.wakesurf?.phase === 'live' && window.wakesurf.pixelRatio < 1);
        const begun = await played();
        await playsOn(begun, 20);
        const later = await played();
        // A page that cannot keep up is sent whole states in between.
        expect(later.keys - begun.keys).toBeLessThan(later.deltas - begun.deltas);
        expect(later.time).not.toBe(begun.time);
        await page.getByRole('button', { name: 'Pause' }).click();
        await expectServersMesh(rig.server, page);
        await page.waitForFunction(() => window.wakesurf!.pixelRatio === 1);
    });
});
