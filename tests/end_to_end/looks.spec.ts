// How surfaces look: colours, ranges, stripes, windows, planes, parts and painting, set with mouse and keyboard and
// compared with numbers.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { steadyRange } from '../../web-client/src/scene/surface/colourMap.ts';
import { stripePeriodPx } from '../../web-client/src/scene/surface/patternShader.ts';
import { ask, finalSurface, openPage } from './support/browser_page.ts';
import {
    agreement,
    distanceFrom,
    hitsOver,
    hitsRound,
    light,
    type PlacedPick,
    type Rgb,
    seenVertices,
    texelsFrom,
} from './support/look_facts.ts';
import { serverStats } from './support/server_mesh.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { useTestRig } from './support/test_rig.ts';

/** 8 x 8 x 8 points: the flow along x, and a field that is x. */
const slab = `<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 7 0 7 0 7" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 7 0 7 0 7"><PointData>
<DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">${'1 0 0 '.repeat(512)}</DataArray>
<DataArray type="Float32" Name="place" format="ascii">${'0 1 2 3 4 5 6 7 '.repeat(64)}</DataArray>
</PointData></Piece></ImageData></VTKFile>`;

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 860, height: 560 });
    // From the side, near enough that the surface fills the picture.
    await page.evaluate(() => window.wakesurf!.setCamera([4, -16, 7], [3.5, 0, 2.8]));
    await page.getByRole('tab', { name: 'Look' }).click();
});

/** After the next picture. */
async function drawn(on: Page = page): Promise<void> {
    await on.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
}

async function setSlider(id: string, value: number): Promise<void> {
    await page.locator(id).fill(String(value));
    await drawn();
}

const scalarBar = (): Promise<string | null> => page.locator('wakesurf-scalar-bar figure').getAttribute('aria-label');

async function openGroup(id: string, open = true): Promise<void> {
    const group = page.locator(id);
    if ((await group.evaluate((each) => (each as HTMLDetailsElement).open)) !== open) await group.locator('summary').click();
}

describe('colours', () => {
    it('are those of the age: automatic, locked by typed numbers, inverted, logarithmic', async () => {
        await page.getByLabel('Colour by').selectOption('age');
        await drawn();
        const age = ({ t }: { t: number }): number => t;
        const seen = await seenVertices(page, 5);
        const whole: [number, number] = [0, Math.max(...(await ask(page, (hook) => hook.vertices(1).map(({ t }) => t))))];
        expect(await scalarBar()).toBe(`Colours: Age from 0 to ${Number(whole[1].toPrecision(4))}`);
        expect(agreement(seen, age, { map: 'viridis', range: whole })).toBeGreaterThan(0.97);

        await page.getByLabel('Range to').fill('12');
        await page.getByLabel('Range to').press('Enter');
        await page.getByLabel('Range from').fill('2');
        await page.getByLabel('Range from').press('Tab');
        await drawn();
        const locked = await seenVertices(page, 5);
        expect(await page.locator('#lock-range').isChecked()).toBe(true);
        expect(await scalarBar()).toBe('Colours: Age from 2 to 12');
        expect(agreement(locked, age, { map: 'viridis', range: [2, 12] })).toBeGreaterThan(0.97);
        expect(agreement(locked, age, { map: 'viridis', range: whole })).toBeLessThan(0.3);

        await page.locator('#invert').focus();
        await page.keyboard.press('Space');
        await page.locator('#log').focus();
        await page.keyboard.press('Space');
        await drawn();
        const both = await seenVertices(page, 5);
        expect(await scalarBar()).toBe('Colours: Age from 2 to 12, logarithmic');
        expect(
            agreement(both, age, {
                map: 'viridis',
                range: [2, 12],
                log: true,
                invert: true,
            }),
        ).toBeGreaterThan(0.97);
        expect(agreement(both, age, { map: 'viridis', range: [2, 12], invert: true })).toBeLessThan(0.5);

        await page.locator('#lock-range').uncheck();
        await page.locator('#invert').uncheck();
        await page.locator('#log').uncheck();
    });

    it('are those of the place on the rake, in another map chosen by keyboard', async () => {
        await page.getByLabel('Colour by').selectOption('s');
        await page.getByRole('radio', { name: 'Viridis' }).focus();
        for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowRight');
        expect(await page.getByRole('radio', { name: 'Plasma' }).isChecked()).toBe(true);
        await drawn();
        const seen = await seenVertices(page, 5);
        expect(agreement(seen, ({ s }) => s, { map: 'plasma', range: [0, 1] })).toBeGreaterThan(0.95);
        await page.getByRole('radio', { name: 'Viridis' }).click();
    });

    it('are those of what the server computes on demand, once it has come', async () => {
        const field = 'deformation';
        const before = await ask(page, (hook) => hook.displayed!.epoch);
        await page.getByLabel('Colour by').selectOption(field);
        await page.waitForFunction(
            (epoch) => window.wakesurf!.phase === 'final' && window.wakesurf!.displayed!.epoch > epoch,
            before,
        );
        await expect.poll(scalarBar).toMatch(/^Colours: Stretching/);
        await drawn();
        const session = await ask(page, (hook) => hook.session);
        const record = (await rig.server.call('session.state', { session })) as {
            snapshot?: unknown;
        };
        expect(JSON.stringify(record)).toMatch(new RegExp(`"fields":\\[[^\\]]*"${field}"`));
        const values = await ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar));
        // Without the last per cent, where that is far from the rest.
        const half = Number(/ to ([^\s,]+)/.exec((await scalarBar())!)![1]);
        expect(half).toBeGreaterThan(1);
        expect(half).toBeLessThan(1.3 * Math.max(...values.map(Math.abs)));
        const seen = await seenVertices(page, 3);
        expect(await page.getByRole('radio', { name: 'Cool to warm' }).isChecked()).toBe(true);
        expect(
            agreement(seen, ({ scalar }) => scalar, {
                map: 'coolToWarm',
                range: [-half, half],
            }),
        ).toBeGreaterThan(0.95);
    });

    it('are those of the estimated error over powers of ten, of which the status says what 99 % keep within', async () => {
        const before = await ask(page, (hook) => hook.displayed!.epoch);
        await page.getByLabel('Colour by').selectOption('error');
        await page.waitForFunction(
            (epoch) => window.wakesurf!.phase === 'final' && window.wakesurf!.displayed!.epoch > epoch,
            before,
        );
        await expect.poll(scalarBar).toMatch(/^Colours: Estimated error .*, logarithmic, of this surface$/);
        await drawn();
        const error99 = (await serverStats(rig.server, page)).error99!;
        const errors = (await ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar))).sort((a, b) => a - b);
        const most = errors.at(-1)!;
        expect(Math.abs(errors[Math.ceil(0.99 * (errors.length - 1))]! - error99)).toBeLessThanOrEqual(most / 65_535);
        const words = await page.locator('wakesurf-status').getByRole('status').textContent();
        expect(words).toMatch(/^Final, 99 % of vertices within \S+$/);
        const least = errors[0]! > 0 ? errors[0]! : most / 1000;
        const written = /from (\S+) to ([^\s,]+),/
            .exec((await scalarBar())!)!
            .slice(1)
            .map((text) => Number(text.replace('−', '-')));
        [least, most].forEach((end, i) => expect(Math.abs(written[i]! / end - 1)).toBeLessThan(1e-3));
        const seen = await seenVertices(page, 3);
        const colours = { map: 'viridis', range: [least, most], log: true } as const;
        expect(agreement(seen, ({ scalar }) => Math.max(scalar, least), colours)).toBeGreaterThan(0.95);
        await page.locator('#log').uncheck();
    });

    it('are those of the speed again at once', async () => {
        await page.getByLabel('Colour by').selectOption('speed');
        const range = await ask(page, (hook) => hook.speedRange);
        await page.waitForFunction(
            (top) => window.wakesurf!.vertices(1).every(({ scalar }) => scalar >= 0 && scalar <= top),
            range[1],
        );
        await drawn();
        expect(await scalarBar()).toMatch(/^Colours: Speed from/);
        const seen = await seenVertices(page, 5);
        const speeds = await ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar));
        const own = steadyRange(Math.min(...speeds), Math.max(...speeds));
        expect(await scalarBar()).toContain(', of this surface');
        expect(agreement(seen, ({ scalar }) => scalar, { map: 'viridis', range: own })).toBeGreaterThan(0.95);

        await page.getByLabel('Over all the data, not this surface').check();
        await drawn();
        expect(await scalarBar()).toContain(', of all the data');
        const all = await seenVertices(page, 5);
        expect(agreement(all, ({ scalar }) => scalar, { map: 'viridis', range })).toBeGreaterThan(0.95);
        await page.getByLabel('Over all the data, not this surface').uncheck();
    });

    it('are those of a field of the dataset', async () => {
        // A field that is the place along x.
        const folder = temporaryFolder();
        const data = join(folder.path, 'slab.vti');
        writeFileSync(data, slab);
        const other = await ServerProcess.start({ store: folder.path, data });
        try {
            const opened = await openPage(page.context(), other.link);
            await finalSurface(opened);
            await opened.getByRole('tab', { name: 'Look' }).click();
            await opened.getByLabel('Colour by').selectOption({ label: 'place' });
            await opened.getByLabel('Over all the data, not this surface').check();
            await opened
                .locator('wakesurf-scalar-bar figure[aria-label="Colours: place from 0 to 7, of all the data"]')
                .waitFor();
            await drawn(opened);
            const vertices = await ask(opened, (hook) => hook.vertices(1).map(({ point, scalar }) => ({ point, scalar })));
            const furthest = Math.max(...vertices.map(({ point, scalar }) => Math.abs(point[0] - scalar)));
            expect(Math.max(...vertices.map(({ scalar }) => scalar))).toBeGreaterThan(6);
            expect(furthest).toBeLessThan(0.01);
            // Not at the rake, which is drawn over the surface.
            const seen = (await seenVertices(opened, 1)).filter(({ point }) => point[0] > 1.5);
            expect(
                agreement(seen, ({ point }) => point[0], {
                    map: 'viridis',
                    range: [0, 7],
                }),
            ).toBeGreaterThan(0.95);
            await opened.close();
        } finally {
            await other.stop();
            folder.remove();
        }
    });
});

describe('stripes', () => {
    it('follow t, a power of two of them a unit, so wide as the screen wants them', async () => {
        await page.getByLabel('Colour by').selectOption('constant');
        await drawn();
        const plain = await hitsOver(page, 9);
        const read = (): Promise<Rgb[]> =>
            page.evaluate(
                (at) => window.wakesurf!.pixelsAt(at),
                plain.map(({ at }) => at),
            );
        const before = await read();
        await openGroup('#lines-group');
        await page.getByLabel('Stripes').selectOption('timelines');
        await drawn();
        const striped = await read();
        let [bright, dark] = [0, 0];
        const right = plain.flatMap(({ surface, t, slope }, i) => {
            if (surface === null || slope === null || !(slope.t > 0)) return [];
            const wanted = -Math.log2(slope.t * stripePeriodPx);
            const part = wanted - Math.floor(wanted);
            // Between two frequencies, and at the border of stripes, anything may be.
            if (part > 0.15 && part < 0.85) return [];
            const frequency = 2 ** (Math.floor(wanted) + (part >= 0.85 ? 1 : 0));
            const phase = t * frequency - Math.floor(t * frequency);
            const off = Math.abs(phase - 0.5);
            if (Math.abs(off - 0.25) < 0.08) return [];
            const ratio = light(striped[i]!) / light(before[i]!);
            const expected = off < 0.25 ? 1 : 0.5;
            if (expected === 1) ++bright;
            else ++dark;
            return [Math.abs(ratio - expected) < 0.13];
        });
        expect(Math.min(bright, dark)).toBeGreaterThan(40);
        expect(right.filter(Boolean).length / right.length).toBeGreaterThan(0.93);
        await page.getByLabel('Stripes').selectOption('none');
        await openGroup('#lines-group', false);
        await page.getByLabel('Colour by').selectOption('speed');
    });
});

describe('what is shown of a surface', () => {
    it('is what lies before a plane, also for the pointer, and what lies behind it when flipped', async () => {
        await openGroup('#clip-group');
        await page.locator('#clip-x').check();
        await page.locator('#clip-x-at').focus();
        for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowLeft');
        await drawn();
        const [low, high] = (await ask(page, (hook) => hook.bounds))! as [number, number];
        const at = low + 0.4 * (high - low);
        const slack = 1e-4 * (high - low);
        const before = await hitsOver(page, 12);
        expect(before.filter(({ surface }) => surface !== null).length).toBeGreaterThan(50);
        expect(before.every(({ surface, point }) => surface === null || point[0] <= at + slack)).toBe(true);

        await page.locator('#clip-x-flip').click();
        await page.locator('#clip-body').check();
        await drawn();
        const behind = await hitsOver(page, 12);
        expect(behind.length).toBeGreaterThan(50);
        expect(behind.every(({ surface, point }) => surface !== null && point[0] >= at - slack)).toBe(true);
        // Where only what is cut away was, there is the background.
        const gone = before.filter(({ at: { x, y } }) => !behind.some((hit) => hit.at.x === x && hit.at.y === y));
        const pixels = await page.evaluate(
            (places) => window.wakesurf!.pixelsAt(places),
            gone.map((hit) => hit.at),
        );
        const dark = pixels.filter(([r, g, b]) => Math.max(Math.abs(r - 11), Math.abs(g - 16), Math.abs(b - 24)) <= 2);
        expect(dark.length / pixels.length).toBeGreaterThan(0.9);
        await page.locator('#clip-body').uncheck();
        await page.locator('#clip-x').uncheck();
        await openGroup('#clip-group', false);
    });

    it('is what comes from some seeds and is of some age', async () => {
        await openGroup('#windows-group');
        await setSlider('#s-window-from', 0.4);
        await setSlider('#age-window-to', 6.5);
        const hits = (await hitsOver(page, 12)).filter(({ surface }) => surface !== null);
        expect(hits.length).toBeGreaterThan(30);
        expect(hits.every(({ s, t }) => s >= 0.399 && t <= 6.501)).toBe(true);
        await page.getByRole('button', { name: 'Show all of it' }).click();
        await drawn();
        const all = (await hitsOver(page, 12)).filter(({ surface }) => surface !== null);
        expect(all.some(({ s }) => s < 0.3) && all.some(({ t }) => t > 8)).toBe(true);
        await openGroup('#windows-group', false);
    });

    it('is what the brush has revealed, exactly, and what it has not erased', async () => {
        await openGroup('#paint-group');
        const hidden = await page.evaluate(() => window.wakesurf!.project([4, -0.3, 3])!);
        const round = (): Promise<PlacedPick[]> => hitsRound(page, hidden, 100);
        const before = await round();
        const times = await ask(page, (hook) => hook.vertices(1).map(({ t }) => t));
        await page.locator('#painting').check();
        await drawn();
        expect((await hitsOver(page, 12)).filter(({ surface }) => surface !== null)).toHaveLength(0);
        const [from, to] = [
            { x: hidden.x - 60, y: hidden.y },
            { x: hidden.x + 60, y: hidden.y + 10 },
        ];
        await page.mouse.move(from.x, from.y);
        await page.mouse.down();
        await page.mouse.move(to.x, to.y, { steps: 5 });
        await page.mouse.up();
        await drawn();
        const apart = distanceFrom(from, to);
        const revealed = (await hitsOver(page, 7)).filter(({ surface }) => surface !== null);
        expect(revealed.length).toBeGreaterThan(80);
        // What was under the brush, but for a pixel of rounding, and what is within a texel and a half of that in the mask: where s and t
        // change along the same direction of the picture, a texel is long and thin in it.
        const touched = before.filter(({ at }) => apart(at) <= 24 + 1);
        const texelsOff = texelsFrom(touched, times);
        const off = (hit: PlacedPick): number => (apart(hit.at) <= 24 + 1 ? 0 : texelsOff(hit));
        const after = await round();
        expect(after.length).toBeGreaterThan(5000);
        expect(Math.max(...[...revealed, ...after].map(off))).toBeLessThan(1.5);
        expect(after.filter(({ at }) => apart(at) < 24 + 2.5).length / after.length).toBeGreaterThan(0.975);
        await page.getByRole('button', { name: 'Reveal all' }).click();
        await drawn();
        const all = (await hitsOver(page, 7)).filter(({ surface }) => surface !== null);
        const inside = all.filter(({ at }) => apart(at) < 22);
        const found = inside.filter(({ at }) => revealed.some((hit) => hit.at.x === at.x && hit.at.y === at.y));
        expect(found.length / inside.length).toBeGreaterThan(0.98);

        await page.getByRole('button', { name: 'Erase' }).click();
        await page.mouse.click(hidden.x, hidden.y);
        await drawn();
        const erased = await page.evaluate(
            ({ x, y }) => [window.wakesurf!.pick({ x, y }), window.wakesurf!.pick({ x, y: y + 30 })],
            hidden,
        );
        expect([erased[0]?.surface ?? null, typeof erased[1]?.surface]).toEqual([null, 'string']);
    });

    it('is the same after the graphics context was lost, transparency and painting included; the page says so meanwhile', async () => {
        await openGroup('#opacity-group');
        await setSlider('#opacity', 0.5);
        const places = (await hitsOver(page, 25)).map(({ at }) => at);
        const pixels = (): Promise<Rgb[]> => page.evaluate((at) => window.wakesurf!.pixelsAt(at), places);
        const before = await pixels();
        await page.evaluate(() => window.wakesurf!.loseContext());
        const told = page.getByText('The system has reset the graphics');
        await told.waitFor();
        const frames = await ask(page, (hook) => hook.framesDrawn);
        await page.evaluate(() => window.wakesurf!.restoreContext());
        await page.waitForFunction((count) => window.wakesurf!.framesDrawn > count, frames);
        await told.waitFor({ state: 'hidden' });
        expect(await pixels()).toEqual(before);
        await setSlider('#opacity', 1);
        await openGroup('#opacity-group', false);
        await page.locator('#painting').uncheck();
    });

    it('is what belongs to parts that are not hidden', async () => {
        await openGroup('#paint-group');
        const first = page.getByRole('checkbox', { name: /^Part 1:/ });
        expect(await first.isChecked()).toBe(true);
        await page.getByRole('button', { name: 'Hide by clicking' }).click();
        const place = (await hitsOver(page, 25)).find(({ surface }) => surface !== null)!.at;
        await page.mouse.click(place.x, place.y);
        await page.waitForFunction((at) => (window.wakesurf!.pick(at)?.surface ?? null) === null, place);
        await page.getByRole('button', { name: 'Show all parts' }).click();
        await page.waitForFunction((at) => typeof window.wakesurf!.pick(at)?.surface === 'string', place);
        await page.getByRole('button', { name: 'Hide by clicking' }).click();
        await openGroup('#paint-group', false);
    });
});
