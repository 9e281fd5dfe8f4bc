// Depth in the picture: arrows move a rake along one axis alone, tools take only what can be seen, and a rake behind the body
// does not look as if it were in front of it.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { RakeRecord, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
let page: Page;

/** One page for the tests of a part. */
function usePage(): void {
    beforeAll(async () => {
        page = await stand.visit({ width: 1440, height: 900 });
        return () => page.context().close();
    });
}

async function recordedRake(): Promise<RakeRecord> {
    const session = await ask(page, (hook) => hook.session);
    return ((await stand.server.call('rake.list', { session }))['rakes'] as RakeRecord[])[0]!;
}

describe('an arrow of the rake', () => {
    usePage();

    it('dragged with the mouse moves the rake along its axis, and nothing along the others', async () => {
        for (const axis of [0, 1, 2] as const) {
            const before = (await recordedRake()).points;
            const at = await page.evaluate((each) => window.wakesurf!.arrowOnScreen(each), axis);
            if (at === null) throw new Error(`no arrow along axis ${axis}`);
            const tip = await page.evaluate((each) => window.wakesurf!.handleOnScreen(each), 'middle' as const);
            const [dx, dy] = [(at.x - tip!.x) / 3, (at.y - tip!.y) / 3];
            await page.mouse.move(at.x, at.y);
            await page.mouse.down();
            await page.mouse.move(at.x + dx, at.y + dy, { steps: 4 });
            await page.mouse.up();
            await expect.poll(async () => JSON.stringify((await recordedRake()).points)).not.toBe(JSON.stringify(before));
            await expect.poll(async () => (await recordedRake()).dragging).toBe(false);
            const after = (await recordedRake()).points;
            after.forEach((point, i) =>
                point.forEach((value, k) => {
                    const moved = value - before[i]![k]!;
                    if (k === axis) expect(moved).toBeGreaterThan(0.1);
                    else expect(Math.abs(moved)).toBeLessThan(1e-9);
                }),
            );
        }
        await finalSurface(page);
    });

    it('stands at the point that was used last, and moves that alone', async () => {
        const start = (await ask(page, (hook) => hook.handleOnScreen(0)))!;
        await page.mouse.click(start.x, start.y);
        const before = (await recordedRake()).points;
        const at = (await ask(page, (hook) => hook.arrowOnScreen(0)))!;
        await page.mouse.move(at.x, at.y);
        await page.mouse.down();
        await page.mouse.move(at.x + 30, at.y, { steps: 4 });
        await page.mouse.up();
        await expect.poll(async () => JSON.stringify((await recordedRake()).points)).not.toBe(JSON.stringify(before));
        const { points } = await recordedRake();
        expect(points[1]).toEqual(before[1]);
        expect(points[0]!.slice(1)).toEqual(before[0]!.slice(1));
    });
});

describe('probe and measure', () => {
    usePage();

    it('tell no number where nothing can be seen, and say so', async () => {
        // Whatever the panel shows.
        await page.getByRole('tab', { name: 'Look' }).click();
        const said = page.locator('.beside-pointer');
        await page.getByRole('button', { name: 'Probe', exact: true }).click();
        const empty = { x: 470, y: 150 };
        expect(await page.evaluate((at) => window.wakesurf!.pick(at), empty)).toBeNull();
        await page.mouse.move(empty.x, empty.y);
        await page.mouse.move(empty.x + 4, empty.y);
        await said.getByText('There is nothing under the pointer').waitFor();
        const box = (await said.boundingBox())!;
        expect(Math.hypot(box.x - empty.x - 4, box.y - empty.y)).toBeLessThan(60);
        expect(await page.locator('#probe-values').count()).toBe(0);
        await page.getByRole('button', { name: 'Measure', exact: true }).click();
        await said.getByText('There is nothing').waitFor({ state: 'detached' });
        await page.mouse.click(empty.x, empty.y);
        await said.getByText('There is nothing under the pointer').waitFor();
        await page.mouse.click(empty.x + 200, empty.y);
        await page.getByRole('tab', { name: 'View' }).click();
        expect(await page.locator('#measured').count()).toBe(0);
    });

    it('take a place of the rake', async () => {
        await page.getByRole('tab', { name: 'View' }).click();
        await page.evaluate(() => window.wakesurf!.setCamera([-25, 1, 9], [5, 0, 3]));
        const [a, b] = await ask(page, (hook) => hook.rakePoints);
        const point = a!.map((value, k) => value + 0.3 * (b![k]! - value)) as Vec3;
        const at = (await page.evaluate((each) => window.wakesurf!.project(each), point))!;
        await page.getByRole('button', { name: 'Probe', exact: true }).click();
        await page.mouse.move(at.x - 3, at.y);
        await page.mouse.move(at.x, at.y);
        await page.locator('#probe-values').waitFor();
    });
});

describe('a rake behind the body', () => {
    usePage();

    it('is paler there than in front of it', async () => {
        const session = await ask(page, (hook) => hook.session);
        const rake = await recordedRake();
        const brightness = async (x: number): Promise<number> => {
            const points = [
                [x, -0.3, 1],
                [x, -0.3, 5],
            ];
            await stand.server.call('rake.set', { session, rake: rake.rake, kind: 'line', points, seeds: 8 });
            await expect.poll(() => ask(page, (hook) => hook.rakePoints[0]![0])).toBe(x);
            await page.evaluate(() => window.wakesurf!.setCamera([-30, 0, 3], [0, 0, 3]));
            return page.evaluate((place) => {
                const hook = window.wakesurf!;
                const at = hook.handleOnScreen(0)!;
                const ring = [-9.5, 9.5].flatMap((d) => [{ x: at.x + d, y: at.y }]);
                void place;
                return Math.max(...hook.pixelsAt(ring).map((rgb) => Math.min(...rgb)));
            }, x);
        };
        const inFront = await brightness(-2);
        const behind = await brightness(2);
        expect(inFront).toBeGreaterThan(behind + 25);
    });
});
