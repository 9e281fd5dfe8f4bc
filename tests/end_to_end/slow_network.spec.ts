// What the page says about itself on a slow network: where the time goes.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { ask } from './support/browser_page.ts';
import { dragHandle } from './support/rake_drag.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const size = { width: 780, height: 440 };

/** The number in front of a unit. */
async function numberIn(page: Page, selector: string): Promise<number> {
    return Number.parseFloat(((await page.locator(selector).textContent()) ?? '').replaceAll(/[\s\u202f]/g, ''));
}

describe('on a slow network', () => {
    it('says where the time goes, follows the pointer all the same, and ends with the server’s mesh', async () => {
        const page = await rig.visit({ ...size, link: await rig.networkLink() });
        rig.network.delay(60);
        await page.locator('#latency summary').click();
        // dragHandle checks that the handle is under the pointer after every step.
        await dragHandle(page, 1, 25, -10, 5);
        await expectServersMesh(rig.server, page);
        const sample = await ask(page, (hook) => hook.latencySamples.at(-1)!);
        expect(sample.milliseconds).toBeGreaterThan(120);
        const sum = Object.values(sample.parts).reduce((a, b) => a + b);
        expect(sum).toBeGreaterThanOrEqual(sample.milliseconds * 0.999);
        // The next ping knows how far away the server is.
        await page.waitForFunction(() => (window.wakesurf?.roundTripMs ?? 0) > 115);
        await dragHandle(page, 1, -25, 10, 5);
        await expectServersMesh(rig.server, page);
        expect(await numberIn(page, '[data-part=network]')).toBeGreaterThan(115);
        expect(await numberIn(page, '#latency-total')).toBeGreaterThan(120);
    });
});
