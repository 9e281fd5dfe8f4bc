// Depth in the picture: arrows move a rake along one axis alone, the probe takes a place of the rake, and a rake behind the body does not look
// as if it were in front of it.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { RakeRecord, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1440, height: 900 });
});

async function recordedRake(): Promise<RakeRecord> {
    const session = await ask(page, (hook) => hook.session);
    return ((await rig.server.call('rake.list', { session }))['rakes'] as RakeRecord[])[0]!;
}

describe('an arrow of the rake', () => {
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
});

describe('the probe', () => {
    it('takes a place of the rake, and says beside the pointer where there is nothing', async () => {
        await page.getByRole('tab', { name: 'View' }).click();
        await page.evaluate(() => window.wakesurf!.setCamera([-25, 1, 9], [5, 0, 3]));
        const [a, b] = await ask(page, (hook) => hook.rakePoints);
        const point = a!.map((value, k) => value + 0.3 * (b![k]! - value)) as Vec3;
        const at = (await page.evaluate((each) => window.wakesurf!.project(each), point))!;
        await page.getByRole('button', { name: 'Probe', exact: true }).click();
        await page.mouse.move(at.x - 3, at.y);
        await page.mouse.move(at.x, at.y);
        await page.locator('#probe-values').waitFor();
        // Whatever the panel shows.
        await page.getByRole('tab', { name: 'Look' }).click();
        const empty = await page.evaluate(() => {
            const xs = Array.from({ length: 40 }, (_, i) => 200 + 20 * i);
            return xs.map((x) => ({ x, y: 150 })).find((place) => window.wakesurf!.pick(place) === null)!;
        });
        await page.mouse.move(empty.x, empty.y);
        await page.mouse.move(empty.x + 4, empty.y);
        const said = page.locator('.beside-pointer');
        await said.getByText('There is nothing under the pointer').waitFor();
        const box = (await said.boundingBox())!;
        expect(Math.hypot(box.x - empty.x - 4, box.y - empty.y)).toBeLessThan(60);
        await page.keyboard.press('Escape');
    });
});

describe('a rake behind the body', () => {
    it('is paler there than in front of it', async () => {
        const session = await ask(page, (hook) => hook.session);
        const rake = await recordedRake();
        const brightness = async (x: number): Promise<number> => {
            const points = [
                [x, -0.3, 1],
                [x, -0.3, 5],
            ];
            await rig.server.call('rake.set', { session, rake: rake.rake, kind: 'line', points, seeds: 8 });
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
