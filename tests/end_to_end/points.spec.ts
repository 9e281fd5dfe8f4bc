// A surface as points: discs at its vertices, against its cells on the same pixels.
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { SurfaceStyle } from '../../web-client/src/scene/surface/surfaceStyle.ts';
import { type BundledPage, openBundledPage } from './support/bundled_page.ts';
import { finalSurface } from './support/browser_page.ts';
import type { FlatFlow } from './support/looks_page.ts';
import { useStand } from './support/stand.ts';
import { testBrowser } from './support/test_browser.ts';

const stand = useStand();
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

    it('has none in a wake either, where cells are split and the surface is torn', async () => {
        const page = await stand.visit({ width: 780, height: 560 });
        await page.getByRole('radio', { name: 'Streak' }).check();
        await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
        await finalSurface(page);
        const places = await page.evaluate(() => {
            const box = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
            const middle = { x: Math.round(box.left + box.width / 2), y: Math.round(box.top + box.height / 2) };
            const { hits, corner, size } = window.wakesurf!.pickGrid(middle, Math.floor(box.height / 2) - 2);
            return hits.flatMap((hit, i) => {
                const at = { x: corner.x + (i % size), y: corner.y + Math.floor(i / size) };
                return hit?.surface == null || at.y % 3 !== 0 ? [] : [at];
            });
        });
        const colours = (): Promise<number[][]> => page.evaluate((at) => window.wakesurf!.pixelsAt(at), places);
        const cells = await colours();
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#opacity-group summary').click();
        await page.getByLabel('Points instead of cells').check();
        const points = await colours();
        expect(places.length).toBeGreaterThan(4_000);
        const apart = points.map((colour, i) => Math.max(...colour.map((c, k) => Math.abs(c - cells[i]![k]!))));
        // The background is darker than any colour of the surface. A border that is trimmed may end between vertices.
        const holes = points.filter((colour, i) => Math.max(...colour) < 30 && Math.max(...cells[i]!) >= 30);
        expect(holes.length / places.length).toBeLessThan(0.001);
        // At folds and borders discs reach over what is behind.
        expect(apart.filter((by) => by > 40).length / apart.length).toBeLessThan(0.06);
    });
});
