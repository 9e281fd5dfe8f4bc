// Every kind of surface from the panel: what a person chooses is what the server builds and the page shows. What the panel asks for
// is tested beside it.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 780, height: 520 });
});

async function choose(kind: string): Promise<void> {
    const before = await ask(page, (hook) => hook.displayed?.epoch ?? 0);
    await page.getByRole('radio', { name: kind }).check();
    await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before);
    await finalSurface(page);
    expect(await ask(page, (hook) => hook.displayed?.cells ?? 0)).toBeGreaterThan(100);
}

describe('the kinds of surface', () => {
    it('are all shown at the time of the picture, with at least half of each downstream of the front of the body', async () => {
        for (const kind of ['Stream', 'Path', 'Streak', 'Time']) {
            if (kind !== 'Stream') await choose(kind);
            expect(await ask(page, (hook) => hook.displayed!.time)).toBe(16);
            expect(await page.locator('#surface-remark').isVisible()).toBe(false);
            const xs = await ask(page, (hook) => hook.vertices(1).map(({ point }) => point[0]));
            expect(xs.filter((x) => x > -0.5).length / xs.length).toBeGreaterThan(0.5);
        }
    });
});
