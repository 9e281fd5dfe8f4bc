// Data of any size and any place: coordinates of a map, micrometres, seconds since 1970, microseconds. What is written of them
// must be what they are, labels must differ where numbers do, and what is drawn must be there.
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { RakeRecord, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { writeScaledFlow } from './support/scaled_flow.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const folder = temporaryFolder();
const onMap = {
    ...{ name: 'map', origin: [512345, 5423456, 100] as Vec3, size: 1000 },
    times: Array.from({ length: 13 }, (_, i) => 1700000000 + 50 * i),
};
const tiny = {
    ...{ name: 'tiny', origin: [0, 0, 0] as Vec3, size: 4e-5 },
    times: Array.from({ length: 6 }, (_, i) => Number((0.1 + i * 1e-4).toFixed(4))),
};
const servers = new Map<string, ServerProcess>();
let browser: Awaited<ReturnType<typeof testBrowser>>;

beforeAll(async () => {
    browser = await testBrowser();
    for (const flow of [onMap, tiny]) {
        const data = writeScaledFlow({ folder: `${folder.path}/${flow.name}`, ...flow });
        const server = await ServerProcess.start({ data, store: `${folder.path}/store-${flow.name}` });
        await server.imported();
        servers.set(flow.name, server);
    }
}, 120_000);

afterAll(async () => {
    await closePages();
    for (const server of servers.values()) await server.stop();
    folder.remove();
});

async function visit(name: string, link?: string): Promise<Page> {
    const context = await newContext(browser, { width: 1440, height: 900 });
    const page = await openPage(context, link ?? (await servers.get(name)!.streamSession()));
    await finalSurface(page);
    return page;
}

async function texts(page: Page, selector: string): Promise<string[]> {
    // Found and read in two steps, between which a frame may have given a label to something else.
    const found = await page
        .locator(selector)
        .evaluateAll(
            (labels, kind) => labels.flatMap((each) => (each.matches(kind) ? [each.textContent ?? ''] : [])),
            selector.split(' ').at(-1),
        );
    return found.map((text) => text.trim()).filter((text) => text !== '');
}

const spoken = (text: string): number => Number(text.replaceAll('−', '-'));

/** Of the three axes and the line of time: labels of each that differ from their neighbours. */
async function expectReadable(page: Page): Promise<void> {
    const ticks = await texts(page, '.labels .tick:not([hidden])');
    expect(ticks.length).toBeGreaterThan(6);
    for (const text of ticks) expect(Number.isFinite(spoken(text)), text).toBe(true);
    const times = (await texts(page, 'wakesurf-timeline text.tick')).map((text) => text.split(' ')[0]!);
    expect(times.length).toBeGreaterThan(3);
    expect(new Set(times).size).toBe(times.length);
}

/** How many of the twelve edges of the domain are drawn: near each, one colour differs from the background's. A few lie behind the surface. */
async function drawnEdges(page: Page): Promise<number> {
    return page.evaluate(() => {
        const hook = window.wakesurf!;
        const b = hook.bounds!;
        let drawn = 0;
        for (let axis = 0; axis < 3; ++axis) {
            for (let side = 0; side < 4; ++side) {
                const point = [0, 1, 2].map((k) => (b[2 * k]! + b[2 * k + 1]!) / 2) as [number, number, number];
                const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                point[u] = b[2 * u + (side & 1)]!;
                point[v] = b[2 * v + (side >> 1)]!;
                // Off the middle, where a rake may end.
                point[axis] = b[2 * axis]! + 0.3 * (b[2 * axis + 1]! - b[2 * axis]!);
                const at = hook.project(point)!;
                const near = [-2, -1, 0, 1, 2].flatMap((dx) => [-2, -1, 0, 1, 2].map((dy) => ({ x: at.x + dx, y: at.y + dy })));
                const colours = hook.pixelsAt(near).map((rgb) => rgb.join());
                if (new Set(colours).size > 1) ++drawn;
            }
        }
        return drawn;
    });
}

describe('a domain on a map, in seconds since 1970', () => {
    it('has axes, times and fields that say where things are, and takes numbers to their last digit', async () => {
        const page = await visit('map');
        await expectReadable(page);
        expect(await texts(page, '.labels .axis-name:not([hidden])')).toContain('y +5.423e6');
        expect(await texts(page, 'wakesurf-timeline text.shared')).toEqual(['+1.7e9']);
        const field = page.getByRole('textbox', { name: 'Start y', exact: true });
        const [start] = await ask(page, (hook) => hook.rakePoints);
        expect(Math.abs(Number(await field.inputValue()) - start![1])).toBeLessThan(0.01);
        await field.fill('5423712.125');
        await page.keyboard.press('Enter');
        const session = await ask(page, (hook) => hook.session);
        const server = servers.get('map')!;
        await expect
            .poll(async () => ((await server.call('rake.list', { session }))['rakes'] as RakeRecord[])[0]!.points[0]![1])
            .toBe(5423712.125);
        expect(await field.inputValue()).toBe('5423712.125');
        // The time that is said is the time of the picture.
        const box = page.locator('#go-to');
        await box.fill('1700000300');
        await page.keyboard.press('Enter');
        await page.keyboard.press('Tab');
        await expect.poll(() => ask(page, (hook) => hook.displayed!.time)).toBe(1700000300);
        expect(await box.inputValue()).toBe('1700000300');
        await page.getByRole('button', { name: 'Fit the whole domain' }).click();
        await expect.poll(() => drawnEdges(page)).toBeGreaterThanOrEqual(9);
        await page.setViewportSize({ width: 390, height: 844 });
        await page.context().close();
    });
});

describe('a domain of 40 micrometres, in steps of 0.1 milliseconds', () => {
    it('is drawn, and read in numbers that differ', async () => {
        const page = await visit('tiny');
        await expectReadable(page);
        expect(await texts(page, '.labels .axis-name:not([hidden])')).toContain('x ×1e−6');
        expect(await drawnEdges(page)).toBeGreaterThanOrEqual(9);
        const times = (await texts(page, 'wakesurf-timeline text.tick')).map(spoken);
        expect([times[0], times.at(-1)]).toEqual([0.1, 0.1005]);
        // Panning is seen, however short its way is.
        const frames = await ask(page, (hook) => hook.framesDrawn);
        const target = await ask(page, (hook) => hook.camera.target);
        await page.mouse.move(500, 150);
        await page.mouse.down({ button: 'right' });
        await page.mouse.move(540, 160, { steps: 4 });
        await page.mouse.up({ button: 'right' });
        await expect.poll(() => ask(page, (hook) => hook.framesDrawn)).toBeGreaterThan(frames);
        expect(await ask(page, (hook) => hook.camera.target)).not.toEqual(target);
        const [start] = await ask(page, (hook) => hook.rakePoints);
        const shown = await page.getByRole('textbox', { name: 'Start y', exact: true }).inputValue();
        expect(Math.abs(Number(shown) - start![1])).toBeLessThan(1e-9);
        expect(shown.length).toBeLessThan(11);
        await page.context().close();
    });
});
