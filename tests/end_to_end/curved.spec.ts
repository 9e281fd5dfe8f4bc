// Curved cells: a surface that stands still is drawn as near to the exact one as a pixel asks, by a switch.
import type { Page } from 'playwright-core';
import { expect, it } from 'vitest';
import { ask, newContext, openPage } from './support/browser_page.ts';
import { linkTo, type Scene, settled } from './support/gallery_scene.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig(['flow:lamb-oseen']);

/** Twisted: particles at radius r turn by (1 - exp(-r r / 0.09)) / (r r) while they drift by a half. */
const scene: Scene = {
    name: 'twisted',
    title: 'A twisted sheet',
    data: 'flow:lamb-oseen',
    surface: {
        kind: 'stream',
        rake: [
            [0.5, 0, 0],
            [2, 0, 0],
        ],
        to: 1.5,
        ...{ seeds: 4, separation: 0.6, angle: 180, merge: 0 },
    },
    look: {},
    camera: { position: [0.5, -0.5, 5], target: [0.5, 0.5, 0.4] },
};

/** Root mean square of the distance along z from the exact sheet, of what is seen. */
async function distance(page: Page): Promise<number> {
    const points = await page.evaluate(() => {
        const { innerWidth, innerHeight, wakesurf } = window;
        const { hits } = wakesurf!.pickGrid({ x: innerWidth / 2, y: innerHeight / 2 }, 150);
        return hits.flatMap((hit) => (hit === null ? [] : [hit.point]));
    });
    expect(points.length).toBeGreaterThan(10_000);
    const squares = points.map(([x, y, z]) => {
        const r = Math.hypot(x, y);
        const perTurn = 0.5 / ((1 - Math.exp((-r * r) / 0.09)) / (r * r));
        const off = z - perTurn * Math.atan2(y, x);
        return (off - 2 * Math.PI * perTurn * Math.round(off / (2 * Math.PI * perTurn))) ** 2;
    });
    return Math.sqrt(squares.reduce((sum, each) => sum + each, 0) / squares.length);
}

it('a surface that stands still is nearer to the exact one with curved cells; its numbers stay, and so does what it says', async () => {
    const context = await newContext(rig.browser, { width: 780, height: 520 });
    const page = await openPage(context, await linkTo(rig.server, scene));
    await settled(page);
    const flat = {
        ...(await ask(page, (hook) => hook.displayed))!,
        distance: await distance(page),
    };
    await page.getByRole('tab', { name: 'Look' }).click();
    await page.locator('#windows-group summary').click();
    await page.getByRole('checkbox', { name: 'Curved cells when still' }).check();
    // The surface comes again with its normals: flat at once, and curved when it stands still.
    await page.waitForFunction(({ triangles, epoch }) => {
        const now = window.wakesurf!.displayed!;
        return now.epoch > epoch && now.triangles > triangles;
    }, flat);
    await settled(page);
    const curved = {
        ...(await ask(page, (hook) => hook.displayed))!,
        distance: await distance(page),
    };
    expect(curved.distance).toBeLessThan(flat.distance / 10);
    expect([curved.vertices, curved.cells]).toEqual([flat.vertices, flat.cells]);
    await page.getByRole('checkbox', { name: 'Curved cells when still' }).uncheck();
    await page.waitForFunction((triangles) => window.wakesurf!.displayed!.triangles === triangles, flat.triangles);
    await settled(page);
    expect(await distance(page)).toBeCloseTo(flat.distance, 6);
    await context.close();
});
