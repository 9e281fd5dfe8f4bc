// A surface that takes minutes: how far it is, what one can have instead, and what is taken out of the page meanwhile. The surface has hundreds of
// thousands of quads, so that it is under way whatever the machine; the seconds that people wait are those of the page's clock, moved on by hand.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import type { SurfaceRecord, SurfaceStats } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { chooseFigure, pixelsOf, savedFigure } from './support/figure_download.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;
let before: SurfaceRecord;

async function record(): Promise<SurfaceRecord> {
    const session = await ask(page, (hook) => hook.session);
    const { surfaces } = await rig.server.call('surface.list', { session });
    return (surfaces as SurfaceRecord[])[0]!;
}

async function set(change: Partial<SurfaceRecord>): Promise<void> {
    const session = await ask(page, (hook) => hook.session);
    const { rev: _rev, epoch: _epoch, ...all } = { ...before, ...change } as SurfaceRecord & { epoch?: number };
    await rig.server.call('surface.set', { ...all, session });
}

/** A streak surface to the end of the data, as fine as nobody needs it. */
async function beginLongPass(): Promise<void> {
    await set({ kind: 'streak', from: 8.5, to: 16, separation: 0.02, maxQuads: 4_000_000 });
    await page.getByRole('progressbar', { name: 'Surface' }).waitFor();
    await page.waitForFunction(() => window.wakesurf?.phase === 'coarse');
}

const offers = (): ReturnType<Page['getByRole']> => page.getByRole('group', { name: 'Instead of waiting' });

beforeAll(async () => {
    page = await rig.visit({ width: 1000, height: 800 });
    before = await record();
    await page.clock.install();
});

beforeEach(async () => {
    await beginLongPass();
    return async () => {
        await set({});
        await finalSurface(page);
    };
});

describe('a long pass', () => {
    it('can be stopped and computed again; what was there by then stays on the screen', async () => {
        await page.getByRole('button', { name: 'Stop', exact: true }).click();
        await page.getByText('Stopped before it was final').waitFor();
        await page.getByText(/stopped by guest 1/).waitFor();
        const session = await ask(page, (hook) => hook.session);
        const stats = await rig.server.call('surface.stats', { session, surface: before.surface });
        expect(stats).toMatchObject({ complete: false, error: { kind: 'cancelled' } });
        expect(await ask(page, (hook) => hook.displayed!.cells)).toBeGreaterThan(100);
        await page.getByRole('button', { name: 'Compute it again' }).click();
        const bar = page.getByRole('progressbar', { name: 'Surface' });
        await bar.waitFor();
        await set({});
        await expectServersMesh(rig.server, page);
        await expect.poll(() => bar.count()).toBe(0);
    });

    it('can be had as it is now: the file says that it is coarse', async () => {
        await page.clock.fastForward(10_000);
        const session = await ask(page, (hook) => hook.session);
        const stats = async (): Promise<SurfaceStats> =>
            (await rig.server.call('surface.stats', { session, surface: before.surface })) as unknown as SurfaceStats;
        const earlier = await stats();
        const waiting = page.waitForEvent('download');
        await offers().getByRole('button', { name: 'As it is now' }).click();
        const download = await waiting;
        expect(download.suggestedFilename()).toMatch(/-streak-coarse\.vtp$/);
        const file = readFileSync(await download.path(), 'latin1');
        const points = Number(/NumberOfPoints="(\d+)"/.exec(file)?.[1]);
        // The surface goes on meanwhile.
        const later = await stats();
        expect(later.complete).toBe(false);
        expect(points).toBeGreaterThanOrEqual(Math.min(earlier.vertices, later.vertices));
        expect(points).toBeLessThanOrEqual(Math.max(earlier.vertices, later.vertices));
    });

    it('is marked in pictures that are saved meanwhile, in the name always and in the picture unless one wants it otherwise', async () => {
        await chooseFigure(page, { width: 500, height: 400, rake: false, axes: false, bar: false });
        const mark = page.getByRole('checkbox', { name: 'Say that it is coarse' });
        expect(await mark.isChecked()).toBe(true);
        const drawn = (): Promise<number | undefined> => ask(page, (hook) => hook.displayed?.stateSum);
        const pair = async () => {
            await mark.check();
            const [of, waiting] = [await drawn(), page.waitForEvent('download')];
            const marked = await pixelsOf(page, await savedFigure(page));
            expect((await waiting).suggestedFilename()).toMatch(/-coarse-500x400\.png$/);
            await mark.uncheck();
            const plain = await pixelsOf(page, await savedFigure(page));
            return { marked, plain, same: of === (await drawn()) };
        };
        // The pass goes on, and may show more of the surface in the second picture.
        let { marked, plain, same } = await pair();
        while (!same) ({ marked, plain, same } = await pair());
        let [inCorner, elsewhere] = [0, 0];
        for (let i = 0; i < marked.pixels.length; i += 4) {
            if (marked.pixels[i] === plain.pixels[i]) continue;
            const [x, y] = [(i / 4) % 500, Math.floor(i / 4 / 500)];
            if (y < 40 && x < 250) ++inCorner;
            else ++elsewhere;
        }
        expect(inCorner).toBeGreaterThan(100);
        expect(elsewhere).toBe(0);
    });
});
