// Shade where things touch, in figures of flat sheets (support/flat_sheets.ts): how much darker a pixel is than without it.
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import { newContext, openPage } from './support/browser_page.ts';
import { pixelsOf } from './support/figure_download.ts';
import { acrossAt, finalSheets, FlatSheets, lookFrom, middle, type Sheet } from './support/flat_sheets.ts';
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

const look = { colourBy: 'constant', colour: '#8090b0', backSide: 'same' } as const;
const upright: Sheet = { points: acrossAt(middle), length: 5, look };
const before: Sheet = {
    points: [
        [0.5, 1, 3],
        [0.5, 1, 4],
    ],
    length: 5,
    look,
};
/** Stands on the first, towards the camera. */
const sessionList: Sheet = {
    points: [
        [0.5, 1.5, middle],
        [0.5, middle, middle],
    ],
    length: 5,
    look,
};
const size = { width: 764, height: 360 };

async function open(sheets: Sheet[], opacity = 1): Promise<Page> {
    const { session, surfaces } = await flow.session(sheets);
    const context = await newContext(browser, { ...size, colorScheme: 'light' });
    const looks = Object.fromEntries(surfaces.map((id) => [id, { ...look, opacity }]));
    const page = await openPage(context, flow.link(session, 'before', looks));
    await finalSheets(page, sheets.length);
    return page;
}

/** Of each pixel, how much light is left of what there is without shade; by places of the page. */
async function shadeOf(page: Page, scale = 1, background: 'white' | 'clear' = 'white') {
    const box = (await page.locator('canvas').first().boundingBox())!;
    const wanted = { width: Math.round(box.width * scale), height: Math.round(box.height * scale) };
    const setting = { ...wanted, background, axes: false, bar: false, rake: false, caption: null };
    const figure = async () => {
        const address = await page.evaluate((each) => window.wakesurf!.picture(each), setting);
        return pixelsOf(page, Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
    };
    await page.getByRole('tab', { name: 'View' }).click();
    const choice = page.getByRole('checkbox', { name: 'Shade where things touch' });
    expect(await choice.isChecked()).toBe(true);
    const shaded = await figure();
    await choice.uncheck();
    const bare = await figure();
    await choice.check();
    const green = ({ pixels }: { pixels: ArrayLike<number> }, at: number): number => pixels[at + 1]!;
    const left = (at: number): number => (green(bare, at) === 0 ? 1 : green(shaded, at) / green(bare, at));
    const all = Array.from({ length: wanted.width * wanted.height }, (_, i) => left(4 * i));
    const alphas = [shaded, bare].map(({ pixels }) => pixels.filter((_, i) => i % 4 === 3));
    /** Of a point in space, moved on the page. */
    const at = async (point: Vec3, down = 0): Promise<number> => {
        const { x, y } = await placed(page, point);
        const [column, row] = [(x - box.x) * scale, (y - box.y + down) * scale].map(Math.floor) as [number, number];
        return all[row * wanted.width + column]!;
    };
    return { all, at, alphas };
}

async function placed(page: Page, point: Vec3): Promise<{ x: number; y: number }> {
    return (await page.evaluate((each) => window.wakesurf!.project(each), point))!;
}

describe('shade where things touch', () => {
    it.each([
        { opacity: 1, turned: 75 },
        { opacity: 0.6, turned: 50 },
    ])('is not on a plane alone, nor round it: opacity $opacity, turned by $turned degrees', async ({ opacity, turned }) => {
        const page = await open([upright], opacity);
        await lookFrom(page, 'before', turned);
        const { all } = await shadeOf(page);
        expect(all.filter((left) => left < 0.985)).toHaveLength(0);
        await page.context().close();
    });

    it('is along the line where two sheets touch and nowhere else, with one pixel or two for one of the page, and stays away where someone has chosen that', async () => {
        const page = await open([upright, sessionList]);
        // From above, where both have an area.
        await page.evaluate(() => window.wakesurf!.setCamera([7.5, -4.5, 9], [3, 3.5, 3.5]));
        for (const scale of [1, 2]) {
            const { all, at } = await shadeOf(page, scale);
            const near: number[] = [];
            const far: number[] = [];
            for (const x of [1.5, 2, 2.5, 3, 3.5, 4]) {
                near.push(await at([x, middle, middle], -2), await at([x, middle, middle], 2));
                far.push(await at([x, middle, middle + 0.9]), await at([x, middle - 1, middle]));
            }
            expect(Math.max(...near)).toBeLessThan(0.85);
            expect(Math.min(...far)).toBeGreaterThan(0.985);
            expect(all.filter((left) => left < 0.97).length / all.length).toBeLessThan(0.1);
        }

        // On the page it comes once that stands still.
        const greenAt = async (): Promise<number> => {
            await page.waitForFunction(() => window.wakesurf!.isAtRest);
            const { x, y } = await placed(page, [3, middle, middle]);
            const { pixels, width } = await pixelsOf(page, await page.screenshot());
            return pixels[4 * (Math.round(y - 2) * width + Math.round(x)) + 1]!;
        };
        const shaded = await greenAt();
        await page.getByRole('checkbox', { name: 'Shade where things touch' }).uncheck();
        expect(shaded / (await greenAt())).toBeLessThan(0.85);
        await page.reload();
        await finalSheets(page, 2);
        await page.getByRole('tab', { name: 'View' }).click();
        expect(await page.getByRole('checkbox', { name: 'Shade where things touch' }).isChecked()).toBe(false);
        await page.context().close();
    });

    it('is not round what is far before something else, and changes no opacity', async () => {
        const page = await open([upright, before]);
        const { all, alphas } = await shadeOf(page, 1, 'clear');
        expect(all.filter((left) => left < 0.97)).toHaveLength(0);
        expect(alphas[0]).toEqual(alphas[1]);
        await page.context().close();
    });
});
