// Edges have no stairs, with whatever graphics: pixels of a flat sheet's border against how much of each it covers, which is known in
// closed form (support/flat_sheets.ts).
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { ask, newContext, openPage } from './support/browser_page.ts';
import { pixelsOf } from './support/figure_download.ts';
import { acrossAt, finalSheets, FlatSheets, middle, type Sheet, spread } from './support/flat_sheets.ts';
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

const sheet: Sheet = {
    points: acrossAt(middle),
    length: 5,
    look: { colourBy: 'constant', colour: '#203060', backSide: 'same' },
};

const pages = new Map<number, Page>();

/** The page with the sheet of that opacity: whatever is saved, it stays as it is. */
async function sheetOf(opacity: number): Promise<Page> {
    const open = pages.get(opacity);
    if (open !== undefined) return open;
    const { session, surfaces } = await flow.session([sheet]);
    const context = await newContext(browser, { width: 764, height: 440, colorScheme: 'light' });
    const page = await openPage(context, flow.link(session, 'before', { [surfaces[0]!]: { ...sheet.look, opacity } }));
    await finalSheets(page, 1);
    pages.set(opacity, page);
    return page;
}

type Background = 'shown' | 'clear';

async function figure(page: Page, background: Background, size: { width: number; height: number }) {
    const setting = { ...size, background, bar: false, axes: false, rake: false, caption: null };
    const address = await page.evaluate((wanted) => window.wakesurf!.picture(wanted), setting);
    return pixelsOf(page, Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
}

const linear = (byte: number): number => {
    const c = byte / 255;
    return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
};

interface Columns {
    /** Of the sheet, in pixels: as the covered parts of pixels add up, and as it is. */
    heights: { drawn: number; is: number }[];
    /** Pixels that are partly covered, in a column. */
    mixed: number[];
}

/** How high the sheet is in columns across its middle. */
async function columnsOf(page: Page, background: Background, height: number): Promise<Columns> {
    const box = (await page.locator('canvas').first().boundingBox())!;
    const scale = height / box.height;
    const width = Math.round(box.width * scale);
    const { pixels } = await figure(page, background, { width, height });
    const found: Columns = { heights: [], mixed: [] };
    const [left, right, unit] = await page.evaluate(() => {
        const hook = window.wakesurf!;
        const at = [1.5, 4.5, 2.5].map((x) => hook.project([x, 3.5, 3.5])!.x);
        return [at[0]!, at[1]!, at[2]! - at[0]!] as const;
    });
    for (let column = Math.ceil((left - box.x) * scale); column < (right - box.x) * scale; column += 7) {
        const pixel = (row: number): number[] => [...pixels.subarray(4 * (row * width + column), 4 * (row * width + column) + 4)];
        const value = (row: number): number => {
            const [red = 0, , , alpha = 0] = pixel(row);
            return background === 'clear' ? alpha / 255 : linear(red);
        };
        const [ground, inside] = [value(2), value(Math.round(height / 2))];
        const covered = Array.from({ length: height }, (_, row) => (value(row) - ground) / (inside - ground));
        // Released at x = 0.5, and further apart since.
        const x = 1.5 + ((column + 0.5) / scale + box.x - left) / unit;
        found.heights.push({
            drawn: covered.reduce((sum, part) => sum + part, 0),
            is: 3 * Math.exp(spread * (x - 0.5)) * unit * scale,
        });
        found.mixed.push(covered.filter((part) => part > 0.05 && part < 0.95).length);
    }
    return found;
}

describe('a figure', () => {
    it.each([
        { opacity: 1, background: 'shown', rows: 1000 },
        { opacity: 0.6, background: 'clear', rows: 440 },
    ] as const)(
        'covers of each pixel what the sheet does: opacity $opacity, background $background, $rows rows',
        async ({ opacity, background, rows }) => {
            const page = await sheetOf(opacity);
            const { heights, mixed } = await columnsOf(page, background, rows);
            expect(heights.length).toBeGreaterThan(25);
            // Four places in a pixel say where an edge is to an eighth, and the surface is right to a part of its size. One place alone
            // is wrong by up to a half, at each of both edges.
            for (const { drawn, is } of heights) expect(Math.abs(drawn - is)).toBeLessThan(0.3 + 3e-4 * rows);
            // Edges that slope by less than a pixel a column are whole at some columns.
            expect(Math.max(...mixed)).toBeLessThanOrEqual(2);
            expect(mixed.filter((count) => count > 0).length / mixed.length).toBeGreaterThan(0.6);
        },
    );
});

describe('a picture on the page', () => {
    it('that stands still has smooth edges soon, is drawn no more then, and keeps them when its pixels are read', async () => {
        const page = await sheetOf(1);
        await page.waitForFunction(() => window.wakesurf!.isAtRest);
        const facts = await page.evaluate(async () => {
            const hook = window.wakesurf!;
            hook.pixelsAt([{ x: 10, y: 10 }]);
            const before = [hook.framesDrawn, hook.samples];
            for (let i = 0; i < 30; ++i) await new Promise(requestAnimationFrame);
            return { before, after: [hook.framesDrawn, hook.samples] };
        });
        expect(facts.after).toEqual(facts.before);
        expect(facts.after[1]).toBe(4);
        const box = (await page.locator('canvas').first().boundingBox())!;
        const { pixels, width, height } = await pixelsOf(page, await page.screenshot());
        const [left, right] = (await ask(page, (hook) => [1.5, 4.5].map((x) => hook.project([x, 3.5, 3.5])!.x))) as [
            number,
            number,
        ];
        let mixed = 0;
        let columns = 0;
        for (let column = Math.ceil(left); column < right; column += 7) {
            ++columns;
            const value = (row: number): number => linear(pixels[4 * (row * width + column)]!);
            const [inside, ground] = [value(Math.round(box.y + box.height / 2) - 30), linear(0xf2)];
            for (let row = Math.round(box.y) + 60; row < Math.min(height, box.y + box.height - 60); ++row) {
                const part = (value(row) - ground) / (inside - ground);
                if (part > 0.1 && part < 0.9) ++mixed;
            }
        }
        expect(mixed / columns).toBeGreaterThan(0.6);
    });
});
