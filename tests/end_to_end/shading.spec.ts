// Light, sides, opacity and outlines of surfaces, in numbers: pixels of flat sheets and of a tube against what the formulas of the
// shader give there (support/shading_formula.ts).
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import type { SurfaceLook } from '../../web-client/src/state/surfaceLook.ts';
import { newContext, openPage } from './support/browser_page.ts';
import { finalSheets, FlatSheets, ground, lookFrom, middle, type Sheet, type Side, spread } from './support/flat_sheets.ts';
import { type Colour, layerAlpha, layered, litColour } from './support/shading_formula.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

let flow: FlatSheets;
let browser: Browser;

beforeAll(async () => {
    flow = await FlatSheets.start();
    browser = await testBrowser();
});

afterAll(async () => {
    await closePages();
    await flow?.stop();
});

const colour = '#40a0e0';
const constant: Partial<SurfaceLook> = { colourBy: 'constant', colour };
/** Where sheets begin, and the middles of the bands of z that they are released in. */
const left = 0.5;
const right = 3.9;
const bands = [1.7, middle, 5.3] as const;
const length = 2.5;

function band(x: number, z: number, look: Partial<SurfaceLook>, fields: string[] = []): Sheet {
    return {
        points: [
            [x, middle, z - 0.7],
            [x, middle, z + 0.7],
        ],
        length,
        look: { ...constant, ...look },
        fields,
    };
}

const sheets: readonly Sheet[] = [
    band(left, bands[0], { backSide: 'same' }),
    band(left, bands[1], { backSide: 'shaded' }),
    band(left, bands[2], { backSide: 'tinted' }),
    band(right, bands[0], { opacity: 0.6, angleOpacity: true, backSide: 'same' }),
    band(right, bands[1], { opacity: 0.8, smoke: 1, backSide: 'same' }, ['deformation']),
    band(right, bands[2], { opacity: 0.8, smoke: 1, backSide: 'same' }),
];

/** In the middle of a band, so much after its release. */
function placeIn(start: number, z: number, t: number): Vec3 {
    return [start + t, middle, middle + (z - middle) * Math.exp(spread * t)];
}

function pixels(page: Page, points: readonly Vec3[], exact: boolean): Promise<number[][]> {
    return page.evaluate(
        ({ all, exactly }) => {
            const hook = window.wakesurf!;
            return hook.pixelsAt(
                all.map((point) => hook.project(point)!),
                exactly,
            );
        },
        { all: points, exactly: exact },
    );
}

const apart = (a: readonly number[], b: readonly number[]): number => Math.max(...a.map((c, i) => Math.abs(c - b[i]!)));
const inBytes = (colour: Colour): number[] => colour.map((c) => 255 * c);

describe('flat sheets', () => {
    let page: Page;
    // Where stretching changes a colour by more than the 2 it may be off and the 3 it has to show: 6.5 at the least.
    const times = [0.9, 1.4, 2];

    beforeAll(async () => {
        const { session, surfaces } = await flow.session(sheets);
        const context = await newContext(browser, { width: 900, height: 440 });
        const looks = Object.fromEntries(surfaces.map((id, i) => [id, sheets[i]!.look]));
        page = await openPage(context, flow.link(session, 'before', looks));
        await finalSheets(page, sheets.length);
    });

    it('have two sides that are told apart as their look says', async () => {
        const drawn: Record<Side, number[][]> = { before: [], behind: [] };
        for (const side of ['before', 'behind'] as const) {
            await lookFrom(page, side);
            drawn[side] = await pixels(
                page,
                // Beyond the arrows of the chosen rake.
                bands.map((z) => placeIn(left, z, 2.3)),
                false,
            );
        }
        const fronts = inBytes(litColour(colour, [0, 0, 1]));
        const backs = (['same', 'shaded', 'tinted'] as const).map((side) => inBytes(litColour(colour, [0, 0, 1], side)));
        // Which is the front depends on which way round the quads are.
        const [front, back] = apart(drawn.before[2]!, fronts) < 2 ? [drawn.before, drawn.behind] : [drawn.behind, drawn.before];
        for (const [i] of bands.entries()) {
            expect(apart(front[i]!, fronts)).toBeLessThan(1.5);
            expect(apart(back[i]!, backs[i]!)).toBeLessThan(1.5);
        }
        expect(apart(back[0]!, front[0]!)).toBeLessThan(1.5);
        expect(apart(back[1]!, front[1]!)).toBeGreaterThan(15);
        // Orange instead of blue.
        expect(front[2]![2]! - front[2]![0]!).toBeGreaterThan(50);
        expect(back[2]![0]! - back[2]![2]!).toBeGreaterThan(50);
    });

    it('are thinned as smoke by stretching and by age, as the server measures it and as the picture guesses it', async () => {
        await lookFrom(page, 'before');
        const alphas = times.map((t) => layerAlpha({ opacity: 0.8, smoke: 1, areaRatio: Math.exp(spread * t), age: t / length }));
        const aged = times.map((t) => layerAlpha({ opacity: 0.8, smoke: 1, age: t / length }));
        const expected = alphas.map((alpha) => layered([{ colour: litColour(colour, [0, 0, 1]), alpha }], ground));
        const unstretched = aged.map((alpha) => layered([{ colour: litColour(colour, [0, 0, 1]), alpha }], ground));
        for (const exact of [false, true]) {
            const known = await pixels(
                page,
                times.map((t) => placeIn(right, bands[1], t)),
                exact,
            );
            const guessed = await pixels(
                page,
                times.map((t) => placeIn(right, bands[2], t)),
                exact,
            );
            for (const [i] of times.entries()) {
                expect(apart(known[i]!, expected[i]!)).toBeLessThan(2);
                // Whether by the mean speed, or by that of the seeds: a few in a hundred.
                expect(apart(guessed[i]!, expected[i]!)).toBeLessThan(4);
                expect(apart(known[i]!, unstretched[i]!)).toBeGreaterThan(3);
            }
        }
    });

    it('are denser edge-on, as the way through a layer is longer, and lit from over the shoulder', async () => {
        await lookFrom(page, 'before', 60);
        const [sine, cosine] = [Math.sin(Math.PI / 3), 0.5];
        const seen = litColour(colour, [-sine, 0, cosine]);
        const dense = layered([{ colour: seen, alpha: 1 - (1 - 0.6) ** 2 }], ground);
        const places = times.map((t) => placeIn(right, bands[0], t));
        expect(layerAlpha({ opacity: 0.6, facing: cosine })).toBeCloseTo(0.84, 9);
        const [blended, exact] = [await pixels(page, places, false), await pixels(page, places, true)];
        const opaque = await pixels(page, [placeIn(left, bands[0], 1.2)], false);
        for (const pixel of [...blended, ...exact]) expect(apart(pixel, dense)).toBeLessThan(2);
        expect(apart(opaque[0]!, inBytes(seen))).toBeLessThan(2);
    });
});

describe('outlines', () => {
    it('are dark where a surface turns away from the eye, and nowhere else, also on one that can be seen through', async () => {
        // A tube along x, its rim at z = 3.5 +- 1 where it begins.
        const centre: Vec3 = [0.5, middle, middle];
        const tube: Sheet = { points: [centre, [0.5, middle, middle + 1], [0.5, middle + 1, middle]], length: 5, look: {} };
        const { session, surfaces } = await flow.session([tube]);
        const context = await newContext(browser, { width: 900, height: 434, colorScheme: 'light' });
        const look: Partial<SurfaceLook> = { ...constant, backSide: 'same' };
        const page = await openPage(context, flow.link(session, 'before', { [surfaces[0]!]: look }));
        await finalSheets(page, 1);
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#opacity-group summary').click();
        /** A column of pixels across the upper edge of the tube, from inside to outside. */
        const edge = (): Promise<number[][]> =>
            page.evaluate(() => {
                const hook = window.wakesurf!;
                const top = Math.max(
                    ...hook
                        .vertices(1)
                        .filter(({ point: [x] }) => Math.abs(x - 3.5) < 0.2)
                        .map(({ point }) => point[2]),
                );
                const at = hook.project([3.5, 3.5, top])!;
                return hook.pixelsAt(
                    Array.from({ length: 24 }, (_, i) => ({ x: at.x, y: at.y + 12 - i })),
                    true,
                );
            });
        const plain = await edge();
        await page.locator('#silhouettes').check();
        const outlined = await edge();
        await page.locator('#opacity').fill('0.3');
        const glass = await edge();
        await context.close();
        const sum = (pixel: readonly number[]): number => pixel[0]! + pixel[1]! + pixel[2]!;
        const covered = plain.filter((pixel) => pixel[0]! < 120).length;
        expect(covered).toBeGreaterThan(8);
        expect(covered).toBeLessThan(16);
        for (const [i, pixel] of plain.entries()) {
            const isEdge = i >= covered - 2 && i < covered;
            // Light falls off towards the edge, but not by half.
            if (i < covered) expect(sum(pixel)).toBeGreaterThan(0.8 * sum(plain[0]!));
            if (!isEdge) expect(apart(outlined[i]!, pixel)).toBeLessThan(2);
            if (!isEdge && i < covered) expect(sum(glass[i]!)).toBeGreaterThan(1.15 * sum(pixel));
        }
        const last = covered - 1;
        expect(sum(outlined[last]!)).toBeLessThan(0.45 * sum(plain[last]!));
        // An outline hides what is behind it, however much the surface lets through.
        expect(apart(glass[last]!, outlined[last]!)).toBeLessThan(4);
    });
});
