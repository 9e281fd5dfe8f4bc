// Layers that can be seen through, in their exact order: against the over operator, worked out from colours and opacities of
// flat sheets, from before and from behind.
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { BackSide, SurfaceLook } from '../../web-client/src/state/surfaceLook.ts';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import type { PageView } from '../../web-client/src/state/pageView.ts';
import { ask, newContext, openPage } from './support/browser_page.ts';
import { savedFigure } from './support/figure_download.ts';
import { acrossAt, finalSheets, FlatSheets, ground, lookFrom, middle, type Side, spread } from './support/flat_sheets.ts';
import { pixelsOfPng } from './support/png_pixels.ts';
import { type Layer, layered, litColour } from './support/shading_formula.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

/** From y = 1 on, one behind the other, so that one to six of them are over one another. */
const sheets = [
    { y: 1, length: 6, colour: '#e03030', opacity: 0.3 },
    { y: 2, length: 2, colour: '#30e030', opacity: 0.7 },
    { y: 3, length: 4, colour: '#3030ff', opacity: 0.5 },
    { y: 4, length: 3, colour: '#e0e020', opacity: 0.6 },
    { y: 5, length: 1, colour: '#20e0e0', opacity: 0.8 },
    { y: 6, length: 5, colour: '#ffffff', opacity: 0.4 },
] as const;
type Drawn = (typeof sheets)[number];
/** In the middle between ends of sheets, where one, two ... six are over one another. */
const places = [6, 5, 4, 3, 2, 1];

let flow: FlatSheets;
let browser: Browser;
let context: BrowserContext;
let session: string;
let surfaces: string[];

beforeAll(async () => {
    flow = await FlatSheets.start();
    browser = await testBrowser();
    context = await newContext(browser, { width: 764, height: 440 });
    ({ session, surfaces } = await flow.session(sheets.map(({ y, length }) => ({ points: acrossAt(y), length, look: {} }))));
});

afterAll(async () => {
    await closePages();
    await flow?.stop();
});

const usual = ({ colour, opacity }: Drawn): Partial<SurfaceLook> => ({ colourBy: 'constant', colour, opacity, backSide: 'same' });

function looksBy(lookOf: typeof usual): Record<string, Partial<SurfaceLook>> {
    return Object.fromEntries(sheets.map((sheet, i) => [surfaces[i]!, lookOf(sheet)]));
}

async function open(side: Side, lookOf = usual, view: PageView = {}): Promise<Page> {
    const page = await openPage(context, flow.link(session, side, looksBy(lookOf), view));
    await finalSheets(page, sheets.length);
    return page;
}

/** Pixels of a place on the screen where so many sheets are; without what the rake and its handles cover. */
function pixels(page: Page, exact: boolean): Promise<number[][]> {
    const points = places.map((reach) => [reach, middle, middle + 0.37] as [number, number, number]);
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

/** Opacity and what of the sheets is there at all, where a look is not the usual one. */
interface Seen {
    sheets?: readonly Drawn[];
    opacityOf?: (sheet: Drawn) => number;
}

/** What the over operator makes of the sheets that reach as far as there; of the nearest `atMost`. */
function expected(
    reach: number,
    side: Side,
    { sheets: of = sheets, opacityOf = ({ opacity }) => opacity }: Seen = {},
    atMost = 6,
): number[] {
    const there = of.filter(({ length }) => length >= reach);
    const nearestFirst = side === 'before' ? there : [...there].reverse();
    const layers = nearestFirst.map((sheet): Layer => ({ colour: litColour(sheet.colour, [0, 0, 1]), alpha: opacityOf(sheet) }));
    return layered(layers.slice(0, atMost), ground);
}

const apart = (a: readonly number[], b: readonly number[]): number => Math.max(...a.map((c, i) => Math.abs(c - b[i]!)));

describe('layers over one another', () => {
    it('are as the over operator says, from both sides; where they are blended instead, the nearer ones show more', async () => {
        const page = await open('before');
        for (const [side, other] of [
            ['before', 'behind'],
            ['behind', 'before'],
        ] as const) {
            await lookFrom(page, side);
            const [blended, exact] = [await pixels(page, false), await pixels(page, true)];
            for (const [i, reach] of places.entries()) {
                // The fifth and the sixth are mixed by weights.
                expect(apart(exact[i]!, expected(reach, side))).toBeLessThan(i < 4 ? 1.5 : 3);
                if (i === 0) {
                    expect(apart(blended[i]!, exact[i]!)).toBeLessThan(1.5);
                    continue;
                }
                // Neither weights nor the order of the other side would do.
                const others = expected(reach, other);
                expect(Math.min(apart(blended[i]!, exact[i]!), apart(exact[i]!, others))).toBeGreaterThan(15);
                // From one of both sides the sheets were made in the order in which they are seen.
                expect(apart(blended[i]!, exact[i]!)).toBeLessThan(apart(blended[i]!, others));
            }
        }
        await page.close();
    });

    it('are shown by weights behind the fourth, which is nearer the truth than leaving them out', async () => {
        const thin = (): number => 0.2;
        const page = await open('before', (sheet) => ({ ...usual(sheet), opacity: 0.2 }));
        const exact = await pixels(page, true);
        const errors = places.map((reach, i) => ({
            drawn: apart(exact[i]!, expected(reach, 'before', { opacityOf: thin })),
            leftOut: apart(expected(reach, 'before', { opacityOf: thin }, 4), expected(reach, 'before', { opacityOf: thin })),
        }));
        for (const { drawn } of errors.slice(0, 4)) expect(drawn).toBeLessThan(1.5);
        for (const { drawn, leftOut } of errors.slice(4)) expect(drawn).toBeLessThan(leftOut / 4);
        await page.close();
    });

    it('may be cut, hidden, painted or opaque', async () => {
        const looks: Record<number, Partial<SurfaceLook>> = {
            1: { hiddenParts: [[0.5, 0.5]] },
            2: { painting: true, faded: 0.4 },
            4: { opacity: 1 },
        };
        const clip = { planes: [{ on: true, at: 4.5 / 7, flipped: false }, null, null], body: false };
        const page = await open('before', (sheet) => ({ ...usual(sheet), ...looks[sheet.y] }), { clip } as unknown as PageView);
        await page.waitForFunction(() => window.wakesurf!.transparency !== 'none');
        const seen: Seen = {
            sheets: sheets.filter(({ y }) => y !== 1),
            opacityOf: ({ y, opacity }) => (y === 2 ? 0.4 * opacity : y === 4 ? 1 : opacity),
        };
        await expect.poll(async () => apart((await pixels(page, true))[5]!, expected(1, 'before', seen))).toBeLessThan(1.5);
        const exact = await pixels(page, true);
        for (const [i, reach] of places.entries()) {
            expect(apart(exact[i]!, reach > 4.5 ? ground : expected(reach, 'before', seen))).toBeLessThan(1.5);
        }
        await page.close();
    });

    it('may be folds of one surface, each showing its own side', async () => {
        // Up at y = 2, back down to y = 4 and up again there: one, three and one layers over one another.
        const turns: Vec3[] = [
            [0.5, 2, 2],
            [0.5, 2, 4],
            [0.5, 4, 3],
            [0.5, 4, 5],
        ];
        const look: Partial<SurfaceLook> = { colourBy: 'constant', colour: '#4080ff', opacity: 0.5, backSide: 'tinted' };
        const folded = await flow.session([{ points: turns, length: 3, look }]);
        const at = 3;
        const grown = Math.exp(spread * (at - 0.5));
        const page = await openPage(context, flow.link(folded.session, 'before', { [folded.surfaces[0]!]: look }));
        await finalSheets(page, 1);
        for (const side of ['before', 'behind'] as const) {
            await lookFrom(page, side);
            const drawn = await page.evaluate((x) => {
                const hook = window.wakesurf!;
                return hook.pixelsAt(
                    [2.4, 3.5, 4.6].map((z) => hook.project([x, 3, z])!),
                    true,
                );
            }, at);
            const back = (is: boolean): BackSide | null => (is ? 'tinted' : null);
            // What goes down between turns its other side to the viewer, from above or from below.
            const [up, straight] = [side === 'before' ? -2 : 2, grown];
            const slant = [0, up / Math.hypot(up, straight), straight / Math.hypot(up, straight)] as const;
            const upright: Layer = { colour: litColour(look.colour!, [0, 0, 1], back(side === 'before')), alpha: 0.5 };
            const slanted: Layer = { colour: litColour(look.colour!, slant, back(side === 'behind')), alpha: 0.5 };
            for (const [i, layers] of [[upright], [upright, slanted, upright], [upright]].entries()) {
                expect(apart(drawn[i]!, layered(layers, ground))).toBeLessThan(2.5);
            }
        }
        await page.close();
    });
});

describe('a picture', () => {
    const whole = (page: Page): Promise<string> => ask(page, (hook) => hook.transparency);

    it('that stands still is drawn once more in exact order, and no more, where that is wanted', async () => {
        const page = await open('before');
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#opacity-group summary').click();
        // Software rendering, as here, leaves it to its user.
        expect(await page.getByLabel('Exact order when still').isChecked()).toBe(false);
        // While things move, a slow page draws what can be seen through as screen doors.
        await expect.poll(() => whole(page)).toBe('blended');
        await page.getByLabel('Exact order when still').check();
        await page.waitForFunction(() => window.wakesurf!.transparency === 'exact');
        const spots = await page.evaluate((all) => all.map((reach) => window.wakesurf!.project([reach, 3.5, 3.87])!), places);
        // Whatever asks for another picture, it is blended first, and exact again a little later.
        const furthest = async (): Promise<number> => {
            const { at } = await pixelsOfPng(page, await page.screenshot(), spots);
            return Math.max(...places.map((reach, i) => apart(at[i]!.slice(0, 3), expected(reach, 'before'))));
        };
        await expect.poll(furthest, { timeout: 20_000 }).toBeLessThan(3);
        // Nothing more is drawn in a time in which there could be two more of them, and it stays as it is.
        const drawnMeanwhile = (): Promise<number> =>
            page.evaluate(async () => {
                const before = window.wakesurf!.framesDrawn;
                for (let i = 0; i < 45; ++i) await new Promise(requestAnimationFrame);
                return window.wakesurf!.framesDrawn - before;
            });
        await expect.poll(async () => [await drawnMeanwhile(), await whole(page)], { timeout: 20_000 }).toEqual([0, 'exact']);

        // A picture in exact order comes after one that is not, when the camera has stopped.
        const frames = await ask(page, (hook) => hook.framesDrawn);
        await page
            .locator('canvas')
            .first()
            .hover({ position: { x: 60, y: 60 } });
        await page.mouse.wheel(0, 120);
        await page.waitForFunction(
            (count) => window.wakesurf!.framesDrawn >= count + 2 && window.wakesurf!.transparency === 'exact',
            frames,
        );
        // The choice stays with the browser.
        await page.reload();
        await page.waitForFunction(() => window.wakesurf?.transparency === 'exact');
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#opacity-group summary').click();
        await page.getByLabel('Exact order when still').uncheck();
        await page.close();
    });

    it('that is saved before no ground is in exact order, and as opaque as its layers', async () => {
        const page = await open('behind');
        await page.getByRole('tab', { name: 'Export' }).click();
        const canvas = (await page.locator('canvas').first().boundingBox())!;
        const spots = await page.evaluate((all) => all.map((reach) => window.wakesurf!.project([reach, 3.5, 3.87])!), places);
        const inPicture = spots.map(({ x, y }) => ({ x: x - canvas.x, y: y - canvas.y }));
        await page.getByLabel('Background').selectOption('clear');
        const { at: bare } = await pixelsOfPng(page, await savedFigure(page), inPicture);
        for (const [i, reach] of places.entries()) {
            const [red, green, blue, alpha] = bare[i]! as [number, number, number, number];
            const passes = sheets
                .filter(({ length }) => length >= reach)
                .reduce((light, { opacity }) => light * (1 - opacity), 1);
            expect(Math.abs(alpha - 255 * (1 - passes))).toBeLessThan(3);
            const laid = [red, green, blue].map((c, k) => (c * alpha) / 255 + ground[k]! * (1 - alpha / 255));
            expect(apart(laid, expected(reach, 'behind'))).toBeLessThan(3.5);
        }
        // It costs nothing on the screen afterwards.
        await page.waitForFunction(() => window.wakesurf!.transparency === 'blended');
        await page.close();
    });
});
