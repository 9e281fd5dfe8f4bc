// The pixels: the picture must be that of the mesh and the body, not merely some picture.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { ask } from './support/browser_page.ts';
import { hueOf } from './support/look_facts.ts';
import { useTestRig } from './support/test_rig.ts';

type Rgb = [number, number, number];

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit();
});

function isBackground([r, g, b]: Rgb): boolean {
    return Math.max(Math.abs(r - 11), Math.abs(g - 16), Math.abs(b - 24)) <= 2;
}

interface SeenVertex {
    pixel: Rgb;
    /** On the surface's own edge the pixel may belong to what is behind, but then its neighbours do not. */
    around: Rgb[];
}

function isCovered({ pixel, around }: SeenVertex): boolean {
    return !isBackground(pixel) || around.some((each) => !isBackground(each));
}

/** Of every seventh vertex that is well inside the canvas. */
async function expectCovered(): Promise<void> {
    const seen = await page.evaluate((): SeenVertex[] => {
        const hook = window.wakesurf!;
        const canvas = { left: 4, top: 50, right: 520, bottom: 460 };
        const seen = hook.vertices(7).flatMap(({ point }) => {
            const at = hook.project(point);
            const inside = at !== null && at.x > canvas.left && at.x < canvas.right && at.y > canvas.top && at.y < canvas.bottom;
            return inside ? [at] : [];
        });
        const offsets = [-1, 0, 1].flatMap((dx) => [-1, 0, 1].map((dy) => ({ dx, dy })));
        const places = seen.flatMap((at) => offsets.map(({ dx, dy }) => ({ x: at.x + dx, y: at.y + dy })));
        const pixels = hook.pixelsAt(places);
        return seen.map((_, i) => {
            const around = pixels.slice(9 * i, 9 * i + 9);
            return { pixel: around[4]!, around };
        });
    });
    expect(seen.length).toBeGreaterThan(100);
    expect(seen.filter(isCovered).length / seen.length).toBeGreaterThan(0.98);
}

describe('the picture', () => {
    it('covers the projected vertices of the surface, wherever it is seen from, and leaves the rest dark', async () => {
        await expectCovered();
        const around = await page.evaluate(() => {
            const [x0 = 0, x1 = 0, y0 = 0, y1 = 0, z0 = 0, z1 = 0] = window.wakesurf!.bounds ?? [];
            const outside: { x: number; y: number }[] = [];
            // Beyond the outline of the domain as seen there can be nothing.
            const corners = [x0, x1].flatMap((x) =>
                [y0, y1].flatMap((y) => [z0, z1].map((z) => window.wakesurf!.project([x, y, z])!)),
            );
            const top = Math.min(...corners.map((corner) => corner.y)) - 20;
            for (let x = 20; x < 500; x += 40) outside.push({ x, y: Math.max(4, top) });
            return window.wakesurf!.pixelsAt(outside);
        });
        expect(around.filter(isBackground)).toHaveLength(around.length);

        const before = await ask(page, (hook) => hook.camera);
        await page.evaluate(() => window.wakesurf!.setCamera([20, -28, 14], [5, 0, 3]));
        await expectCovered();
        await page.evaluate(({ position, target }) => window.wakesurf!.setCamera(position, target), before);
    });

    it('shows the body in the flow, grey', async () => {
        // From the side opposite to the surface, onto the face of the square cylinder at y = -0.5.
        const pixels = await page.evaluate(() => {
            const hook = window.wakesurf!;
            hook.setCamera([0, -30, 3], [0, 0, 3]);
            const face = [-0.3, 0, 0.3].flatMap((x) => [1, 2, 3, 4, 5].map((z) => ({ x, z })));
            return hook.pixelsAt(face.map(({ x, z }) => hook.project([x, -0.5, z])!));
        });
        const grey = pixels.filter((pixel) => hueOf(pixel).chroma < 30 && Math.max(...pixel) > 60);
        expect(grey.length).toBe(pixels.length);
    });

    it('shows the body in the colours of a field, as bright as the field is large', async () => {
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#body-group summary').click();
        await page.getByLabel('Colour the body by').selectOption('speed');
        await page.locator('#body-map').selectOption('grey');
        await page.getByText('Values are those a quarter of a cell off').waitFor();
        await page.locator('#body-invert').setChecked(false);
        const pixelsOfFace = (): Promise<Rgb[]> =>
            page.evaluate(async () => {
                const hook = window.wakesurf!;
                hook.setCamera([0, -30, 3], [0, 0, 3]);
                for (let i = 0; i < 3; ++i) await new Promise(requestAnimationFrame);
                const face = [-0.45, -0.3, 0, 0.3].flatMap((x) => [2, 3, 4].map((z) => ({ x, z })));
                return hook.pixelsAt(face.map(({ x, z }) => hook.project([x, -0.5, z])!));
            });
        const light = (pixels: Rgb[]): number[] => pixels.map(([r, g, b]) => r + g + b);
        const rising = light(await pixelsOfFace());
        await page.locator('#body-invert').setChecked(true);
        const falling = light(await pixelsOfFace());
        // What is brighter than the middle of the colours is darker when they are turned round.
        expect(Math.max(...rising) - Math.min(...rising)).toBeGreaterThan(60);
        const brightest = rising.indexOf(Math.max(...rising));
        const darkest = rising.indexOf(Math.min(...rising));
        expect(falling[brightest]! - falling[darkest]!).toBeLessThan(0);
        await page.getByLabel('Colour the body by').selectOption('constant');
        await page.getByRole('button', { name: 'Fit the whole domain' }).click();
    });

    it('tells what is under the pointer, with perspective and without', async () => {
        for (const orthographic of [false, true]) {
            await page.evaluate((parallel) => window.wakesurf!.setCamera([4, -26, 9], [4, 0, 3], parallel), orthographic);
            const found = await page.evaluate(() => {
                const hook = window.wakesurf!;
                const bounds = hook.bounds!;
                const size = Math.hypot(...[0, 2, 4].map((i) => bounds[i + 1]! - bounds[i]!));
                return hook.vertices(61).flatMap(({ point, s, t, scalar }) => {
                    const at = hook.project(point)!;
                    const hit = hook.pick(at);
                    if (hit === null || hit.surface === null) return [];
                    const apart = Math.hypot(...hit.point.map((x, i) => x - point[i]!)) / size;
                    const back = hook.project(hit.point)!;
                    const px = Math.hypot(back.x - at.x, back.y - at.y);
                    const numbers = Math.max(Math.abs(hit.s - s), Math.abs(hit.t - t) / 13, Math.abs(hit.scalar - scalar));
                    return [{ apart, px, numbers }];
                });
            });
            expect(Math.max(...found.map(({ px }) => px))).toBeLessThan(0.1);
            // Of the others a fold in front is seen.
            const same = found.filter(({ apart }) => apart < 1e-3);
            expect(same.length).toBeGreaterThan(40);
            const close = same.filter(({ apart, numbers }) => apart < 1e-4 && numbers < 5e-3);
            expect(close.length / same.length).toBeGreaterThan(0.9);
        }
    });
});
