// What surrounds the surface in a picture: the lines of the box, numbers and names of the axes, and the bar, in pixels of figures.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask } from './support/browser_page.ts';
import { pixelsOf } from './support/figure_download.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 900, height: 520 });
});

interface Wanted {
    scale?: number;
    axes: boolean;
    bar?: boolean;
    background?: 'shown' | 'white' | 'clear';
}

/** With so many pixels for one of the page; and how a place on the page is found in it. */
async function figure(page: Page, { scale = 1, axes, bar = false, background = 'white' }: Wanted) {
    const box = (await page.locator('canvas').first().boundingBox())!;
    const wanted = { width: Math.round(box.width * scale), height: Math.round(box.height * scale) };
    const setting = { ...wanted, background, axes, bar, rake: false, caption: null };
    const address = await page.evaluate((each) => window.wakesurf!.picture(each), setting);
    const { pixels, width, height } = await pixelsOf(page, Buffer.from(address.slice(address.indexOf(',') + 1), 'base64'));
    const rgba = (x: number, y: number): number[] => {
        const at =
            4 * (Math.min(height - 1, Math.max(0, Math.floor(y))) * width + Math.min(width - 1, Math.max(0, Math.floor(x))));
        return [...pixels.subarray(at, at + 4)];
    };
    return { width, height, rgba, inFigure: (x: number, y: number) => ({ x: (x - box.x) * scale, y: (y - box.y) * scale }) };
}

interface OnEdge {
    at: { x: number; y: number };
    /** What is seen there and round it beside the box: a part of all. */
    hit: number;
    edge: number;
}

/** Places along the twelve edges of the domain that are in the picture. */
function placesOnEdges(page: Page): Promise<OnEdge[]> {
    return page.evaluate(() => {
        const hook = window.wakesurf!;
        const b = hook.bounds!;
        const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const found: OnEdge[] = [];
        for (let edge = 0; edge < 12; ++edge) {
            const [axis, side] = [edge % 3, Math.floor(edge / 3)];
            for (let part = 0.02; part < 1; part += 0.06) {
                const point = [0, 0, 0] as [number, number, number];
                const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
                point[axis] = b[2 * axis]! + part * (b[2 * axis + 1]! - b[2 * axis]!);
                point[u] = b[2 * u + (side & 1)]!;
                point[v] = b[2 * v + (side >> 1)]!;
                const at = hook.project(point);
                if (at === null || at.x < canvas.left + 4 || at.x > canvas.right - 4) continue;
                if (at.y < canvas.top + 4 || at.y > canvas.bottom - 4) continue;
                found.push({ at, hit: hook.pickGrid(at, 3).hits.filter((each) => each !== null).length / 49, edge });
            }
        }
        return found;
    });
}

const apart = (a: readonly number[], b: readonly number[]): number => Math.max(...a.map((c, i) => Math.abs(c - b[i]!)));
const eye: Vec3 = [-14, -26, 12];

describe('the box of the domain', () => {
    it.each([
        ['with', false],
        ['without', true],
    ] as const)('is behind what is in it, %s perspective, and its nearest edges are pale', async (_, parallel) => {
        await page.evaluate(([from, orthographic]) => window.wakesurf!.setCamera(from, [4, 0, 3], orthographic), [
            eye,
            parallel,
        ] as const);
        const places = await placesOnEdges(page);
        const [boxed, bare] = [await figure(page, { axes: true }), await figure(page, { axes: false })];
        const differences = places.map(({ at, hit, edge }) => {
            const { x, y } = boxed.inFigure(at.x, at.y);
            const around = [-1, 0, 1].flatMap((dx) =>
                [-1, 0, 1].map((dy) => apart(boxed.rgba(x + dx, y + dy), bare.rgba(x + dx, y + dy))),
            );
            return { hit, edge, by: Math.max(...around) };
        });
        const covered = differences.filter(({ hit }) => hit === 1);
        expect(covered.length).toBeGreaterThan(3);
        // Numbers of axes may stand there.
        expect(covered.filter(({ by }) => by > 2).length / covered.length).toBeLessThan(0.1);
        const meanOf = (edge: number): number => {
            const own = differences.filter((each) => each.edge === edge && each.hit === 0).map(({ by }) => by);
            return own.reduce((sum, by) => sum + by, 0) / Math.max(1, own.length);
        };
        // Edge 0 is along x at the least y and z, and so on: from this eye three meet at the corner (-3, -4, 6).
        const near = new Set([6, 1 + 6, 2].filter((edge) => differences.some((each) => each.edge === edge && each.hit === 0)));
        const strengths = Array.from({ length: 12 }, (_, edge) => meanOf(edge)).filter((_, edge) => !near.has(edge));
        expect(strengths.filter((by) => by > 60).length).toBeGreaterThanOrEqual(7);
        const weak = Array.from({ length: 12 }, (_, edge) => meanOf(edge)).filter((by) => by > 8 && by < 60);
        expect(weak.length).toBeGreaterThanOrEqual(2);
        expect(weak.length).toBeLessThanOrEqual(3);
    });
});

describe('the line of a measure', () => {
    it('is as wide in a picture of many pixels as on the page', async () => {
        await page.evaluate(() => window.wakesurf!.setCamera([5, -26, 8], [5, 0, 3]));
        const scale = 2;
        const bare = await figure(page, { scale, axes: false });
        await page.getByRole('tab', { name: 'View' }).click();
        await page.getByRole('button', { name: 'Measure', exact: true }).click();
        const ends = [
            { x: 300, y: 260 },
            { x: 430, y: 240 },
        ] as const;
        for (const { x, y } of ends) await page.mouse.click(x, y);
        await page.locator('#measured dd').first().waitFor();
        const { rgba, inFigure } = await figure(page, { scale, axes: false });
        // Away from both ends and from the words in the middle.
        const widths = [0.12, 0.16, 0.2, 0.24, 0.78, 0.82, 0.86].map((part) => {
            const at = inFigure(ends[0].x + part * (ends[1].x - ends[0].x), ends[0].y + part * (ends[1].y - ends[0].y));
            const reach = Math.ceil(6 * scale);
            const by = Array.from({ length: 2 * reach + 1 }, (_, k) => {
                const [column, row] = [at.x, at.y + k - reach];
                return apart(rgba(column, row), bare.rgba(column, row));
            });
            return by.reduce((sum, each) => sum + each, 0) / Math.max(...by) / scale;
        });
        widths.sort((a, b) => a - b);
        expect(Math.abs(widths[3]! - 1.5)).toBeLessThan(0.4);
        await page.keyboard.press('Escape');
    });
});

describe('lines and words in a figure', () => {
    it('are the same share of a picture of few pixels and of many', async () => {
        await page.evaluate((from) => window.wakesurf!.setCamera(from, [4, 0, 3]), eye);
        const places = (await placesOnEdges(page)).filter(({ hit }) => hit === 0);
        const name = (await page.locator('.labels .axis-x').boundingBox())!;
        const heights: number[] = [];
        // A figure that is smaller still is laid out smaller, for the sake of its letters: see layoutOf in capture.ts.
        for (const scale of [1, 2]) {
            const { rgba, inFigure } = await figure(page, { scale, axes: true, bar: true, background: 'clear' });
            // Across an upright line, the parts of pixels that it covers add up to its width.
            const widths = places
                .filter(({ edge }) => edge % 3 === 2)
                .map(({ at }) => {
                    const { x, y } = inFigure(at.x, at.y);
                    const reach = Math.ceil(4 * scale);
                    let sum = 0;
                    for (let dx = -reach; dx <= reach; ++dx) sum += rgba(x + dx, y)[3]! / 255;
                    return sum / scale;
                })
                .sort((a, b) => a - b);
            expect(Math.abs(widths[Math.floor(0.75 * widths.length)]! - 1.1)).toBeLessThan(0.2);
            const [from, to] = [inFigure(name.x - 1, name.y - 2), inFigure(name.x + name.width + 1, name.y + name.height + 2)];
            const rows: number[] = [];
            for (let y = Math.floor(from.y); y <= to.y; ++y) {
                let most = 0;
                for (let x = Math.floor(from.x); x <= to.x; ++x) most = Math.max(most, rgba(x, y)[3]!);
                if (most > 128) rows.push(y);
            }
            heights.push(rows.length === 0 ? 0 : Math.max(...rows) - Math.min(...rows) + 1);
        }
        expect(heights[0]).toBeGreaterThan(5);
        expect(Math.abs(heights[1]! - 2 * heights[0]!)).toBeLessThanOrEqual(3);
    });

    it('are not under the scalar bar, on the page and in figures', async () => {
        const barBox = (await page.locator('wakesurf-scalar-bar').boundingBox())!;
        const overlaps = async (): Promise<number> => {
            let found = 0;
            for (let turn = 0; turn < 10; ++turn) {
                found += await page.evaluate(
                    async ({ angle, bar }) => {
                        const hook = window.wakesurf!;
                        const before = hook.framesDrawn;
                        hook.setCamera([4 + 22 * Math.cos(angle), 22 * Math.sin(angle), 8], [1, 0, 3]);
                        while (hook.framesDrawn === before) await new Promise(requestAnimationFrame);
                        const labels = document
                            .querySelector('wakesurf-app')!
                            .shadowRoot!.querySelectorAll('.labels .tick, .labels .axis-name');
                        return [...labels].filter((each) => {
                            const box = each.getBoundingClientRect();
                            if (box.width === 0) return false;
                            return (
                                box.right > bar.x &&
                                box.left < bar.x + bar.width &&
                                box.bottom > bar.y &&
                                box.top < bar.y + bar.height
                            );
                        }).length;
                    },
                    { angle: 0.63 * turn + 0.2, bar: barBox },
                );
            }
            return found;
        };
        expect(await overlaps()).toBe(0);
        // Where there is no bar, there are some.
        await page.locator('wakesurf-scalar-bar').evaluate((each: HTMLElement) => (each.style.display = 'none'));
        expect(await overlaps()).toBeGreaterThan(2);
        await page.locator('wakesurf-scalar-bar').evaluate((each: HTMLElement) => (each.style.display = ''));
        expect(await ask(page, (hook) => hook.stage)).toBe('running');
    });
});
