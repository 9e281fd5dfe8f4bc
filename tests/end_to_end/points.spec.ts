// A surface as points: discs at its vertices, against its cells on the same pixels of a flat sheet. One that is torn is in wake_streak.
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { SurfaceStyle } from '../../web-client/src/scene/surface/surfaceStyle.ts';
import { type BundledPage, openBundledPage } from './support/bundled_page.ts';
import type { FlatFlow } from './support/looks_page.ts';
import { testBrowser } from './support/test_browser.ts';

let bundled: BundledPage;

beforeAll(async () => {
    bundled = await openBundledPage(await testBrowser(), 'looks_page.ts', { width: 320, height: 200 });
    await bundled.page.waitForFunction(() => window.lookBench !== undefined);
});

afterAll(() => bundled.close());

async function lightOf(flow: FlatFlow, look: Partial<SurfaceStyle>): Promise<number[]> {
    return bundled.page.evaluate(([where, style]) => window.lookBench!.light(where, style, 0), [flow, look] as const);
}

describe('a surface as points', () => {
    it('has no holes, and its colours and depth are those of its cells, at half to 400 times the size', async () => {
        for (const zoom of [0.5, 6, 400]) {
            const flow: FlatFlow = { corner: [0, 0, 0], size: 10, waves: 0.03, speed: [0.5, 1.5], angle: [0, 1], zoom };
            const look = { source: 'scalar', range: [0.4, 1.6], backSide: 'same' } as const;
            const cells = await lightOf(flow, look);
            const points = await lightOf(flow, { ...look, points: true });
            const drawn = cells.flatMap((light, i) => (light > 0 ? [i] : []));
            expect(drawn.length, `${zoom}`).toBeGreaterThan(10_000);
            expect(drawn.filter((i) => points[i] === 0)).toEqual([]);
            const apart = drawn.map((i) => Math.abs(points[i]! - cells[i]!) / cells[i]!).sort((a, b) => a - b);
            expect(apart[Math.floor(0.95 * apart.length)], `${zoom}`).toBeLessThan(0.06);
        }
    });

    const sheet: FlatFlow = { corner: [0, 0, 0], size: 1, waves: 0, speed: [1, 1], angle: [0, 1], zoom: 0.6, grid: [11, 7] };
    const borders: [string, Partial<FlatFlow>, holes: number][] = [
        ['a straight border', {}, 0],
        ['one that leans', { lean: 0.6 }, 0],
        ['corners inwards, round a hole', { hole: [0.3, 0.7, 0.3, 0.7] }, 0],
        ['a notch beside which the sheet is one cell wide', { hole: [0.1, 0.5, 0, 0.8] }, 0],
        ['a bent sheet', { waves: 0.05, grid: [21, 13] }, 0],
        ['a line through cells, which are cut there', { cut: true, grid: [41, 25] }, 0.001],
    ];

    it.each(borders)('ends where its cells do: %s', async (_, border, most) => {
        const flow = { ...sheet, ...border };
        const look = { source: 'constant', backSide: 'same' } as const;
        const [cells, points] = [await lightOf(flow, look), await lightOf(flow, { ...look, points: true })];
        const drawn = cells.filter((light) => light > 0).length;
        expect(drawn).toBeGreaterThan(4000);
        expect(cells.filter((light, i) => light > 0 && points[i] === 0).length / drawn).toBeLessThanOrEqual(most);
        expect(points.filter((light, i) => light > 0 && cells[i] === 0).length / drawn).toBeLessThan(0.005);
    });
});
