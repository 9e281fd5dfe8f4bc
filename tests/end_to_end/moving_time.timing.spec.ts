// How well the page keeps up with a time that moves.
import type { Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { allowLostConnections } from './support/complaints.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeEach(async () => {
    page = await rig.visit({ width: 900, height: 480, link: await rig.networkLink() });
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    await finalSurface(page);
});

afterEach(async () => {
    rig.network.mend();
    await page.context().close();
});

interface Played {
    time: number;
    keys: number;
    deltas: number;
}

function played(): Promise<Played> {
    return ask(page, ({ displayed }) => ({ time: displayed!.time, keys: displayed!.keys, deltas: displayed!.deltas }));
}

/** At least so many changes more than then have been applied. */
function playsOn({ deltas }: Played, more: number): Promise<unknown> {
    return page.waitForFunction((least) => window.wakesurf!.displayed!.deltas >= least, deltas + more);
}

/** From 11, half a minute from the end, where the loop starts again with nothing to be seen. */
async function play(): Promise<void> {
    await page.locator('#speed').selectOption('0.25');
    await page.locator('#go-to').fill('11');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => window.wakesurf!.displayed!.time === 11);
    await finalSurface(page);
    await page.getByRole('button', { name: 'Play' }).click();
    await page.waitForFunction(() => window.wakesurf?.phase === 'live');
}

describe('a streak surface', () => {
    it('is shown whole within three seconds of a scrub', async () => {
        const box = (await page.locator('#clock').boundingBox())!;
        const thumb = 14;
        const x = (time: number): number => box.x + thumb / 2 + ((box.width - thumb) * (time - 8.5)) / 7.5;
        const y = box.y + box.height / 2;
        await page.mouse.move(x(16), y);
        await page.mouse.down();
        await page.mouse.move(x(14), y, { steps: 4 });
        const begun = performance.now();
        await page.mouse.move(x(11), y, { steps: 4 });
        await page.mouse.up();
        await page.waitForFunction(() => Math.abs(window.wakesurf!.displayed!.time - 11) < 0.03);
        await finalSurface(page);
        expect(performance.now() - begun).toBeLessThan(3000);
    });

    it('plays by changes: of 20 updates at most one is whole', async () => {
        await play();
        const begun = await played();
        await playsOn(begun, 20);
        expect((await played()).keys - begun.keys).toBeLessThanOrEqual(1);
    });

    it('goes on from the state it has after a short cut of the network', async () => {
        allowLostConnections();
        await play();
        // What was missed is kept for five seconds, and a loop starts again. A page so busy that it falls behind what it has
        // missed goes on with a whole state. Where one of them came between, it was no short cut.
        for (let tries = 1, short = false; !short; ++tries) {
            expect(tries).toBeLessThan(6);
            await playsOn(await played(), 5);
            const fellBehind = await rig.metric('wakesurf_catching_up_total');
            const begun = performance.now();
            rig.network.cut();
            await page.waitForFunction(() => window.wakesurf?.connection !== 'open');
            const before = await played();
            rig.network.mend();
            // What was under way may still have been drawn: news of the new connection count, and before it nothing can be clicked.
            await page.waitForFunction(() => window.wakesurf?.connection === 'open');
            await page.waitForFunction(
                ({ keys, deltas }) => window.wakesurf!.displayed!.keys + window.wakesurf!.displayed!.deltas > keys + deltas,
                await played(),
            );
            const after = await played();
            short =
                performance.now() - begun < 4000 &&
                after.time > before.time &&
                (await rig.metric('wakesurf_catching_up_total')) === fellBehind;
            if (short) expect(after.keys).toBe(before.keys);
        }
        await page.getByRole('button', { name: 'Pause' }).click();
        await expectServersMesh(rig.server, page);
    });
});
