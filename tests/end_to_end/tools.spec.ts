// The tools over the picture: what the probe says is what the server samples there, what is measured is how far apart the
// clicked places are, and while a tool is chosen the pointer is its own.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SampledPoints, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 900, height: 560 });
    await page.evaluate(() => window.wakesurf!.setCamera([5, -26, 8], [5, 0, 3]));
    await page.getByRole('tab', { name: 'View' }).click();
});

interface Seen {
    x: number;
    y: number;
    point: Vec3;
}

/** Two places of the surface on the screen, away from its rake. */
async function places(): Promise<[Seen, Seen]> {
    const seen = await page.evaluate(() => {
        const hook = window.wakesurf!;
        const at = (x: number, y: number) => ({ x, y, hit: hook.pick({ x, y }) });
        return [at(300, 260), at(430, 240)];
    });
    return seen.map(({ x, y, hit }) => {
        if (hit?.surface == null) throw new Error(`no surface at ${x}, ${y}`);
        return { x, y, point: hit.point };
    }) as [Seen, Seen];
}

async function typed(name: string): Promise<Vec3> {
    const values = ['x', 'y', 'z'].map((axis) => page.getByRole('textbox', { name: `${name} ${axis}` }).inputValue());
    return (await Promise.all(values)).map(Number) as Vec3;
}

function apart(a: Vec3, b: Vec3): number {
    return Math.hypot(...a.map((value, i) => value - b[i]!));
}

async function sampled(point: Vec3): Promise<SampledPoints> {
    const asked = { dataset: 'sqcyl', points: [point], time: await ask(page, (hook) => hook.displayed!.time) };
    return (await rig.server.call('probe.sample', asked)) as unknown as SampledPoints;
}

describe('the probe', () => {
    it('says what the server samples on the surface under the pointer, keeps the clicked place, and goes where numbers say', async () => {
        const [at, elsewhere] = await places();
        await page.getByRole('button', { name: 'Probe', exact: true }).click();
        await page.mouse.move(at.x, at.y);
        await page.mouse.click(at.x, at.y);
        await expect.poll(async () => apart(await typed('Probe'), at.point)).toBeLessThan(0.02);
        const velocity = (await sampled(await typed('Probe'))).values['U']![0] as Vec3;
        const said = page.locator('#probe-values [data-field=U]');
        await expect.poll(async () => Number.parseFloat((await said.textContent())!)).toBeCloseTo(Math.hypot(...velocity), 2);
        await page.mouse.move(elsewhere.x, elsewhere.y);
        await page.mouse.move(elsewhere.x + 5, elsewhere.y);
        expect(apart(await typed('Probe'), at.point)).toBeLessThan(0.02);
        // Where nothing flows.
        await page.getByRole('textbox', { name: 'Probe y' }).fill('0.1');
        await page.keyboard.press('Enter');
        await page.getByRole('textbox', { name: 'Probe x' }).fill('0.1');
        await page.keyboard.press('Enter');
        expect((await sampled([0.1, 0.1, (await typed('Probe'))[2]])).inside).toEqual([false]);
        await page.getByText('There is no flow at this point').waitFor();
    });
});

describe('the measure', () => {
    it('tells how far apart two clicked places of the surface are, in the unit its user gave', async () => {
        const [a, b] = await places();
        await page.getByRole('button', { name: 'Measure', exact: true }).click();
        await page.mouse.click(a.x, a.y);
        await page.mouse.click(b.x, b.y);
        const distance = page.locator('#measured dd').first();
        expect(Number.parseFloat((await distance.textContent())!)).toBeCloseTo(apart(a.point, b.point), 2);
        await page.getByLabel('Unit of length').fill('mm');
        await page.keyboard.press('Enter');
        expect(await distance.textContent()).toMatch(/ mm$/);
        await page.locator('.axis-x', { hasText: 'x (mm)' }).waitFor();
        await page.getByRole('button', { name: 'Measure', exact: true }).click();
    });
});

describe('a chosen tool', () => {
    it('has the pointer to itself: a press on a handle moves no rake until the tool is put away', async () => {
        const before = await ask(page, (hook) => hook.rakePoints);
        const drag = async (): Promise<void> => {
            const at = (await ask(page, (hook) => hook.handleOnScreen(1)))!;
            await page.mouse.move(at.x, at.y);
            await page.mouse.down();
            await page.mouse.move(at.x + 12, at.y + 6, { steps: 3 });
            await page.mouse.up();
        };
        await page.getByRole('button', { name: 'Measure', exact: true }).click();
        const camera = await ask(page, (hook) => hook.camera);
        await drag();
        expect(await ask(page, (hook) => hook.rakePoints)).toEqual(before);
        await page.keyboard.press('Escape');
        await page.evaluate(({ position, target }) => window.wakesurf!.setCamera(position, target), camera);
        await drag();
        expect(await ask(page, (hook) => hook.rakePoints)).not.toEqual(before);
    });
});

it('a line that is clicked on the body becomes a rake off it', async () => {
    await page.getByRole('tab', { name: 'Flow' }).click();
    await page.getByRole('button', { name: 'New line on a body' }).click();
    const onBody = await page.evaluate(() => {
        const found: { x: number; y: number }[] = [];
        for (let y = 60; y < 500; y += 10) {
            for (let x = 60; x < 600; x += 10) if (window.wakesurf!.pick({ x, y })?.surface === null) found.push({ x, y });
        }
        return [found[0]!, found.at(-1)!];
    });
    const session = await ask(page, (hook) => hook.session);
    const polylines = async (): Promise<number> => {
        const { rakes } = (await rig.server.call('rake.list', { session })) as { rakes: { kind: string }[] };
        return rakes.filter(({ kind }) => kind === 'polyline').length;
    };
    const before = await polylines();
    for (const { x, y } of onBody) await page.mouse.click(x, y);
    await page.getByText('2 of its points are set.').waitFor();
    await page.getByRole('button', { name: 'End the line' }).click();
    await expect.poll(polylines).toBe(before + 1);
}, 60_000);
