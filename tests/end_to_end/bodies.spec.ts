// Bodies and what lies on them, in the picture.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { newContext, openPage } from './support/browser_page.ts';
import { linkTo, readGallery, settled } from './support/gallery_scene.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig(['flow:sphere']);
const scene = readGallery().scenes.find(({ name }) => name === 'tearing')!;

/** Round a place, places one pixel apart in rows: 2 is a surface, 1 the body, 0 nothing. */
function seenRound(page: Page, centre: readonly [number, number, number], radius: number): Promise<number[][]> {
    return page.evaluate(
        ({ centre: at, radius: pixels }) => {
            const hook = window.wakesurf!;
            const { hits, size } = hook.pickGrid(hook.project([...at])!, pixels);
            const kinds = hits.map((hit) => (hit === null ? 0 : hit.surface === null ? 1 : 2));
            return Array.from({ length: size }, (_, row) => kinds.slice(row * size, (row + 1) * size));
        },
        { centre, radius },
    );
}

let page: Page;

beforeAll(async () => {
    const context = await newContext(rig.browser, { width: 1100, height: 620 });
    page = await openPage(context, await linkTo(rig.server, scene));
    await settled(page);
});

describe('a sheet that lies on a body', () => {
    it('is seen, and not the body through it, with perspective and without', async () => {
        for (const projection of ['Perspective', 'Parallel']) {
            if (projection === 'Parallel') await page.getByRole('button', { name: projection }).click();
            const rows = await seenRound(page, [0, 0, 0], 150);
            const reach = 12;
            let [poked, covered] = [0, 0];
            for (let row = reach; row + reach < rows.length; ++row) {
                for (let column = reach; column + reach < rows.length; ++column) {
                    const near = [1, 2, 3, 4].map((quarter) => quarter * 3);
                    const sides = [
                        near.some((by) => rows[row]![column - by] === 2),
                        near.some((by) => rows[row]![column + by] === 2),
                        near.some((by) => rows[row - by]![column] === 2),
                        near.some((by) => rows[row + by]![column] === 2),
                    ];
                    if (!sides.every(Boolean)) continue;
                    if (rows[row]![column] === 2) ++covered;
                    if (rows[row]![column] === 1) ++poked;
                }
            }
            expect(covered).toBeGreaterThan(10_000);
            // There were 1523 and 1302.
            expect(poked, projection).toBeLessThan(5);
        }
    });
});
