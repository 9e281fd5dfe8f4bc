// The grain of the flow texture on flat sheets whose flow is known: its direction at any scale and place, and how fast it moves.
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { SurfaceStyle } from '../../web-client/src/scene/surface/surfaceStyle.ts';
import { type BundledPage, openBundledPage } from './support/bundled_page.ts';
import type { FlatFlow } from './support/looks_page.ts';
import { testBrowser } from './support/test_browser.ts';

const [width, height] = [320, 200];
let bundled: BundledPage;
let page: Page;

beforeAll(async () => {
    bundled = await openBundledPage(await testBrowser(), 'looks_page.ts', { width, height });
    page = bundled.page;
    await page.waitForFunction(() => window.lookBench !== undefined);
});

afterAll(() => bundled.close());

const flat: FlatFlow = { corner: [0, 0, 0], size: 10, waves: 0, speed: [1, 1], angle: [0, 0] };

/** Brightness by pixels, rows from the bottom. */
async function lightOf(flow: FlatFlow, look: Partial<SurfaceStyle>, time = 0): Promise<number[]> {
    return page.evaluate(([where, style, at]) => window.lookBench!.light(where, style, at), [
        flow,
        { texture: true, ...look },
        time,
    ] as const);
}

/** Degrees between the grain, across which the light changes most, and a direction. */
function offOf(light: readonly number[], direction: number): number {
    let [xx, xy, yy] = [0, 0, 0];
    for (let row = 1; row < height - 1; ++row) {
        for (let column = 1; column < width - 1; ++column) {
            const at = (dr: number, dc: number): number => light[(row + dr) * width + column + dc]!;
            const dx = 3 * (at(-1, 1) - at(-1, -1)) + 10 * (at(0, 1) - at(0, -1)) + 3 * (at(1, 1) - at(1, -1));
            const dy = 3 * (at(1, -1) - at(-1, -1)) + 10 * (at(1, 0) - at(-1, 0)) + 3 * (at(1, 1) - at(-1, 1));
            [xx, xy, yy] = [xx + dx * dx, xy + dx * dy, yy + dy * dy];
        }
    }
    const apart = 0.5 * Math.atan2(2 * xy, xx - yy) - Math.PI / 2 - direction;
    return (180 / Math.PI) * Math.abs(apart - Math.PI * Math.round(apart / Math.PI));
}

/** Pixels along the rows by which the second is the first one moved: where they agree best. */
function shiftOf(first: readonly number[], second: readonly number[]): number {
    const mean = first.reduce((a, b) => a + b) / first.length;
    let [best, found] = [-Infinity, 0];
    for (let shift = -8; shift <= 8; ++shift) {
        let agreement = 0;
        for (let row = 0; row < height; ++row) {
            for (let column = 8; column < width - 8; ++column) {
                agreement += (first[row * width + column]! - mean) * (second[row * width + column + shift]! - mean);
            }
        }
        if (agreement > best) [best, found] = [agreement, shift];
    }
    return found;
}

describe('the grain of the flow texture', () => {
    it('lies along the flow, on a map far from its origin and in micrometres as near the origin', async () => {
        const places = [
            flat,
            { ...flat, corner: [512_345, 5_423_456, 100] as const, size: 1000 },
            { ...flat, size: 4e-5 },
            { ...flat, size: 1e-8 },
        ];
        for (const [i, place] of places.entries()) {
            const angle = [0.3, 1.3, 2.3, 0.8][i]!;
            const off = offOf(await lightOf({ ...place, angle: [angle, angle] }, {}), angle);
            expect(off, `${place.size} long, ${angle}`).toBeLessThan(5);
        }
    });

    it('goes on as fast as the flow where that is slow, over more time than one wave lasts', async () => {
        const slow: FlatFlow = { ...flat, speed: [0.025, 0.025] };
        const pixelsAUnit = (0.025 * width) / flat.size;
        const look = { textureMoves: 'withTime' as const };
        let [gone, before] = [0, await lightOf(slow, look, 0)];
        const step = 3 / pixelsAUnit;
        for (let k = 1; k <= 8; ++k) {
            const after = await lightOf(slow, look, k * step);
            gone += shiftOf(before, after);
            before = after;
        }
        expect(gone / 24).toBeGreaterThan(0.75);
        expect(gone / 24).toBeLessThan(1.1);
    });
});
