// Outlines without specks: in an even part of a creased surface, where nothing is before anything else, no pixel is dark.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import type { SurfaceLook } from '../../web-client/src/state/surfaceLook.ts';
import { newContext, openPage } from './support/browser_page.ts';
import { pixelsOf } from './support/figure_download.ts';
import { linkTo, readGallery, settled } from './support/gallery_scene.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const scene = readGallery().scenes.find(({ name }) => name === 'wake-streak')!;
/** How far away an edge has nothing to do with a pixel. */
const reach = 5;

let page: Page;

beforeAll(async () => {
    const context = await newContext(stand.browser, { width: 800, height: 500, colorScheme: 'light' });
    const look: Partial<SurfaceLook> = { colourBy: 'constant', colour: '#d8dde6' };
    page = await openPage(context, await linkTo(stand.server, { ...scene, look }));
    await settled(page);
    await page.getByRole('tab', { name: 'View' }).click();
    await page.getByRole('checkbox', { name: 'Shade where things touch' }).uncheck();
    await page.getByRole('tab', { name: 'Look' }).click();
    await page.locator('#opacity-group summary').click();
});

/** The picture on the page, and the side of a square in its middle. */
async function picture() {
    const box = (await page.locator('canvas').first().boundingBox())!;
    const size = { width: Math.round(box.width), height: Math.round(box.height) };
    return { box, size, side: 2 * Math.floor(Math.min(size.width, size.height) / 2 - 4) + 1 };
}

/** By rows of the square: how far what is seen there is away; 0: nothing. */
async function distancesSeen(): Promise<number[]> {
    const { box, size, side } = await picture();
    return page.evaluate(
        ({ x, y, radius }) =>
            window.wakesurf!.pickGrid({ x, y }, radius).hits.map((hit) => (hit?.surface == null ? 0 : hit.distance)),
        { x: box.x + Math.floor(size.width / 2) + 0.5, y: box.y + Math.floor(size.height / 2) + 0.5, radius: (side - 1) / 2 },
    );
}

/** How bright each of these pixels is in a figure as large as the picture. */
async function brightness(outlined: boolean): Promise<number[]> {
    await page.locator('#silhouettes').setChecked(outlined);
    const { size, side } = await picture();
    const setting = { ...size, background: 'white', axes: false, bar: false, rake: false, caption: null } as const;
    const address = await page.evaluate((each) => window.wakesurf!.picture(each), setting);
    const { pixels } = await pixelsOf(page, Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
    const [left, top] = [Math.floor(size.width / 2) - (side - 1) / 2, Math.floor(size.height / 2) - (side - 1) / 2];
    return Array.from(
        { length: side * side },
        (_, i) => pixels[4 * ((top + Math.floor(i / side)) * size.width + left + (i % side)) + 1]!,
    );
}

describe('outlines of a creased surface', () => {
    it.each([
        ['from afar', [-3.4, -10.2, 9.2], [2.3, 0, 2.6]],
        ['near a crease', [-1.2, -4.2, 5.2], [2.4, 0, 2.4]],
        ['along the wake', [-4, -6, 4.5], [4, 0, 3]],
    ] as [string, Vec3, Vec3][])('are no specks where it is even: %s', async (_, position, target) => {
        await page.evaluate(([from, to]) => window.wakesurf!.setCamera(from, to), [position, target] as const);
        const [drawn, bare] = [await brightness(true), await brightness(false)];
        const [distances, { side }] = [await distancesSeen(), await picture()];
        const isDark = drawn.map((light, i) => light < 0.7 * bare[i]!);
        let [even, specks, lines] = [0, 0, 0];
        for (let row = reach; row < side - reach; ++row) {
            for (let column = reach; column < side - reach; ++column) {
                const at = row * side + column;
                if (isDark[at]) ++lines;
                let [least, most] = [Infinity, 0];
                for (let dy = -reach; dy <= reach; ++dy) {
                    for (let dx = -reach; dx <= reach; ++dx) {
                        const beside = at + dy * side + dx;
                        least = Math.min(least, distances[beside]!);
                        most = Math.max(most, distances[beside]!);
                    }
                }
                // What faces the eye changes by less than a hundredth; where a part is before another it has an outline.
                const isEven = least > 0 && most - least < 0.025 * least;
                if (!isEven) continue;
                ++even;
                if (isDark[at]) ++specks;
            }
        }
        expect(even).toBeGreaterThan(12_000);
        expect(lines).toBeGreaterThan(100);
        expect(specks).toBe(0);
    });
});
