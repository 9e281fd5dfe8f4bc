// Smoke on a flat sheet whose vertices say what a fixed grid cannot resolve: how much light is left of it.
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { type BundledPage, openBundledPage } from './support/bundled_page.ts';
import type { FlatFlow } from './support/looks_page.ts';
import { layerAlpha, layered, litColour } from './support/shading_formula.ts';
import { testBrowser } from './support/test_browser.ts';

const [width, height] = [200, 100];
const colour = '#8fb8de';
let bundled: BundledPage;

beforeAll(async () => {
    bundled = await openBundledPage(await testBrowser(), 'looks_page.ts', { width, height });
    await bundled.page.waitForFunction(() => window.lookBench !== undefined);
});

afterAll(() => bundled.close());

describe('smoke', () => {
    it('hides what its vertices cannot resolve on a fixed grid alone', async () => {
        for (const [shape, turn, fixedGrid] of [
            [0, 0, true],
            [0.4, 0, true],
            [0, 0.7, true],
            [0.4, 0.7, true],
            [0.4, 0.7, false],
        ] as const) {
            const size = 10;
            const flow: FlatFlow = {
                ...{ corner: [0, 0, 0], size, waves: 0, speed: [1, 1], angle: [0, 0], unresolved: [shape, turn] },
            };
            const look = { colour, smoke: 1, opacity: 0.8, fixedGrid, areaPerSeed: (size * size * height) / width };
            const light = await bundled.page.evaluate(([where, style]) => window.lookBench!.light(where, style, 0), [
                flow,
                look,
            ] as const);
            for (const row of [10, 50, 80]) {
                const unresolved = fixedGrid ? ([shape, turn] as const) : ([0, 0] as const);
                const alpha = layerAlpha({ opacity: 0.8, smoke: 1, age: (row + 0.5) / height, unresolved });
                const expected = layered([{ colour: litColour(colour, [0, 0, 1]), alpha }], [0, 0, 0]);
                const sum = expected.reduce((a, b) => a + b);
                expect(Math.abs(light[row * width + 100]! - sum), `${shape}, ${turn}, row ${row}`).toBeLessThan(0.03 * sum + 4);
            }
        }
    });
});
