// A streak surface behind a body, which is creased and torn there: what of it is trimmed in the picture, what of it is shown instead of the
// whole, the same as in a file, and its outlines, which are no specks where it is even.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import { readFragment } from '../../web-client/src/session/view/urlState.ts';
import { ask, newContext, openPage } from './support/browser_page.ts';
import { pixelsOf } from './support/figure_download.ts';
import { linkTo, readGallery, settled } from './support/gallery_scene.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    const scene = readGallery().scenes.find(({ name }) => name === 'wake-streak')!;
    const context = await newContext(rig.browser, { width: 800, height: 520 });
    page = await openPage(context, await linkTo(rig.server, scene));
    await settled(page);
    await page.getByRole('tab', { name: 'Look' }).click();
});

function lookFrom(position: Vec3, target: Vec3): Promise<void> {
    return page.evaluate(([from, to]) => window.wakesurf!.setCamera(from, to), [position, target] as const);
}

/** Which of the pixels in the middle of the picture show the surface: 1 for each that does. */
function shown(): Promise<number[]> {
    return page.evaluate(() => {
        const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const middle = { x: canvas.left + canvas.width * 0.5, y: canvas.top + canvas.height * 0.5 };
        return window.wakesurf!.pickGrid(middle, 200).hits.map((hit) => (typeof hit?.surface === 'string' ? 1 : 0));
    });
}

describe('a torn border', () => {
    it('is trimmed on the page and not in the mesh; the page says of how many quads, and shows all when asked', async () => {
        // Near the body, behind which the sheet is torn.
        await lookFrom([-1.2, -4.2, 5.2], [1.2, 0, 3]);
        await settled(page);
        const trimmed = await shown();
        const counts = await page.locator('wakesurf-status .counts').innerText();
        const number = Number(/quads \((\d+) trimmed\)/.exec(counts)?.[1]);
        const { cells } = (await ask(page, (hook) => hook.displayed))!;
        expect(number).toBeGreaterThan(50);
        expect(number).toBeLessThan(0.05 * cells);
        await expectServersMesh(rig.server, page);
        await page.locator('#windows-group summary').click();
        await page.getByRole('checkbox', { name: 'Trim torn borders' }).uncheck();
        await page.waitForFunction(() => !document.querySelector('wakesurf-app')!.shadowRoot!.textContent.includes('trimmed)'));
        await page.locator('text=Nothing is trimmed.').waitFor();
        await settled(page);
        const whole = await shown();
        const sum = (each: readonly number[]): number => each.reduce((a, b) => a + b, 0);
        // Nothing is where nothing was; a hundredth of what there is at most is trimmed.
        expect(trimmed.filter((is, i) => is === 1 && whole[i] === 0)).toHaveLength(0);
        expect(sum(whole) - sum(trimmed)).toBeGreaterThan(50);
        expect(sum(whole) - sum(trimmed)).toBeLessThan(0.02 * sum(whole));
        expect(await page.locator('wakesurf-status .counts').innerText()).not.toContain('trimmed');
        // A link says so too: the address follows within half a second.
        const { surface } = (await ask(page, (hook) => hook.displayed))!;
        const looks = () => readFragment(new URL(page.url()).hash).state?.view.looks?.[surface];
        await expect.poll(looks).toMatchObject({ trimmed: false });
        await page.getByRole('checkbox', { name: 'Trim torn borders' }).check();
        await expect.poll(looks).not.toHaveProperty('trimmed');
        await settled(page);
        expect(await shown()).toEqual(trimmed);
    });
});

/** Half the side of the square in the middle of the picture that is looked at. */
const half = 180;

/** Points of the surface that are seen in the middle of the picture. */
function seen(): Promise<Vec3[]> {
    return page.evaluate((radius) => {
        const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const middle = { x: canvas.left + canvas.width * 0.5, y: canvas.top + canvas.height * 0.5 };
        return window
            .wakesurf!.pickGrid(middle, radius)
            .hits.flatMap((hit) => (typeof hit?.surface === 'string' ? [hit.point] : []));
    }, half);
}

/** Whether the surface is seen at points of space, or beside them by a pixel; undefined for those outside the middle of the picture. */
function seenAt(points: readonly Vec3[]): Promise<(boolean | undefined)[]> {
    return page.evaluate(
        ([wanted, radius]) => {
            const hook = window.wakesurf!;
            const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
            const middle = { x: Math.round(canvas.left + canvas.width * 0.5), y: Math.round(canvas.top + canvas.height * 0.5) };
            const grid = hook.pickGrid(middle, radius);
            return wanted.map((point) => {
                const at = hook.project(point);
                if (at === null) return undefined;
                const [x, y] = [Math.round(at.x) - grid.corner.x, Math.round(at.y) - grid.corner.y];
                if (Math.min(x, y) < 1 || Math.max(x, y) >= grid.size - 1) return undefined;
                return [-1, 0, 1].some((dy) =>
                    [-1, 0, 1].some((dx) => typeof grid.hits[(y + dy) * grid.size + x + dx]?.surface === 'string'),
                );
            });
        },
        [points as Vec3[], half] as const,
    );
}

/** The polygons of a file, or its lines, as their corners. */
async function polygons(lines: string, head = 'f'): Promise<Vec3[][]> {
    const session = (await ask(page, (hook) => hook.session))!;
    const { surface } = await ask(page, (hook) => hook.displayed!);
    const path = `/api/v1/sessions/${encodeURIComponent(session)}/surfaces/${surface}/mesh.obj?lines=${encodeURIComponent(lines)}`;
    const reply = await fetch(new URL(path, rig.server.link), { headers: { Authorization: `Bearer ${rig.server.token}` } });
    expect(reply.status).toBe(200);
    const rows = (await reply.text()).split('\n').map((row) => row.split(' '));
    const points = rows.filter(([first]) => first === 'v').map(([, x, y, z]) => [Number(x), Number(y), Number(z)] as Vec3);
    return rows.filter(([first]) => first === head).map(([, ...corners]) => corners.map((corner) => points[Number(corner) - 1]!));
}

const apart = (a: Vec3, b: Vec3): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const middleOf = (corners: readonly Vec3[]): Vec3 =>
    [0, 1, 2].map((axis) => corners.reduce((sum, p) => sum + p[axis]!, 0) / corners.length) as Vec3;

async function choose(pieces: string, every: number, width: number | null): Promise<void> {
    await page.getByLabel('Shown of it').selectOption(pieces);
    if (pieces !== 'whole') {
        await page.getByLabel('One every').fill(String(every));
        await page.getByLabel('One every').press('Enter');
    }
    if (width !== null) {
        await page.locator('#piece-width').fill(String(width));
        await page.locator('#piece-width').press('Enter');
    }
    await settled(page);
}

describe('what is shown of a surface', () => {
    beforeAll(async () => {
        await lookFrom([3, -9, 9], [3, 0, 3]);
        for (const group of ['pieces', 'opacity']) await page.locator(`#${group}-group summary`).click();
    });

    it('can be timeribbons, the same as in a file', async () => {
        await choose('timeribbons', 0.5, 0.15);
        const cut = await polygons('timeribbons:every=0.5,width=0.15');
        expect(cut.length).toBeGreaterThan(500);
        const middles = cut.map(middleOf);
        const there = (await seenAt(middles)).map((at, i) => ({ at, middle: middles[i]! })).filter(({ at }) => at !== undefined);
        const missed = there.filter(({ at }) => !at);
        expect(there.length).toBeGreaterThan(200);
        expect(missed.length / there.length).toBeLessThan(0.05);
        // And nothing else.
        const shown = await seen();
        expect(shown.length).toBeGreaterThan(1000);
        const corners = cut.flat();
        const far = shown.filter((_, i) => i % 97 === 0).filter((at) => !corners.some((corner) => apart(corner, at) < 0.2));
        expect(far.length).toBe(0);
    });

    it('can be lines as thin as a pixel', async () => {
        await choose('seedlines', 0.5, null);
        const corners = (await polygons('streaklines:every=0.5', 'l')).flat();
        const shown = await seen();
        expect(shown.length).toBeGreaterThan(500);
        // The file leaves out pieces that are shorter than their distance.
        const far = shown.filter((_, i) => i % 23 === 0).filter((at) => !corners.some((corner) => apart(corner, at) < 0.15));
        expect(far.length).toBeLessThan(0.05 * (shown.length / 23));
    });

    it('can be arrows, as many as there is room for', async () => {
        await choose('whole', 0, null);
        const whole = (await seen()).length;
        await choose('arrows', 0.5, 0.1);
        await page.waitForFunction(() => window.wakesurf!.vertices(50).some(({ flow }) => flow !== null));
        await settled(page);
        const arrows = (await seen()).length;
        // A head and a shaft are 7/6 of the squared width; from one to the next it is 0.7 to 1.4 of 0.5.
        const share = ((7 / 6) * 0.1 ** 2) / 0.5 ** 2;
        expect(arrows / whole).toBeGreaterThan(share / 2);
        expect(arrows / whole).toBeLessThan(share * 2);
        await choose('whole', 0, null);
    });

    it('can be points without holes, also where cells are split and the surface is torn', async () => {
        await lookFrom([-3.4, -10.2, 9.2], [2.3, 0, 2.6]);
        await settled(page);
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
        await page.getByLabel('Points instead of cells').check();
        const points = await colours();
        expect(places.length).toBeGreaterThan(4_000);
        const apart = points.map((colour, i) => Math.max(...colour.map((c, k) => Math.abs(c - cells[i]![k]!))));
        // The background is darker than any colour of the surface. A border that is trimmed may end between vertices.
        const holes = points.filter((colour, i) => Math.max(...colour) < 30 && Math.max(...cells[i]!) >= 30);
        expect(holes.length / places.length).toBeLessThan(0.001);
        // At folds and borders discs reach over what is behind.
        expect(apart.filter((by) => by > 40).length / apart.length).toBeLessThan(0.06);
        await page.getByLabel('Points instead of cells').uncheck();
    });
});

/** How far away an edge has nothing to do with a pixel. */
const reach = 5;

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
async function brightness(box: '#silhouettes' | '#hatched', on: boolean): Promise<number[]> {
    await settled(page);
    // The box follows the record of the surface, which the server may have to change first.
    if ((await page.locator(box).isChecked()) !== on) await page.locator(box).press('Space');
    await expect.poll(() => page.locator(box).isChecked()).toBe(on);
    await settled(page);
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
    beforeAll(async () => {
        await page.setViewportSize({ width: 800, height: 500 });
        await page.emulateMedia({ colorScheme: 'light' });
        await page.getByRole('tab', { name: 'View' }).click();
        await page.getByRole('checkbox', { name: 'Shade where things touch' }).uncheck();
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.getByLabel('Colour by').selectOption('constant');
        await page.getByLabel('A different colour from the rake').check();
        await page.locator('#surface-colour').fill('#d8dde6');
        // A tab that was left has its groups folded again.
        await page.locator('#opacity-group summary').click();
        await settled(page);
    });

    it('are no specks where it is even, near a crease and along the wake', async () => {
        for (const [position, target] of [
            [
                [-1.2, -4.2, 5.2],
                [2.4, 0, 2.4],
            ],
            [
                [-4, -6, 4.5],
                [4, 0, 3],
            ],
        ] as [Vec3, Vec3][]) {
            await lookFrom(position, target);
            const [drawn, bare] = [await brightness('#silhouettes', true), await brightness('#silhouettes', false)];
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
        }
    });
});

describe('the error between stored times', () => {
    it('is stated, and what it puts off by more than the separation is hatched, until that is switched off', async () => {
        await page.locator('#lines-group summary').click();
        const hatched = await brightness('#hatched', true);
        await page.locator('#between-times', { hasText: /Between stored times: 99 % within .* not resolved/ }).waitFor();
        const bare = await brightness('#hatched', false);
        const [dark, surface] = [bare.filter((light, i) => hatched[i]! < 0.7 * light), bare.filter((light) => light < 245)];
        expect(dark.length).toBeGreaterThan(50);
        expect(dark.length).toBeLessThan(0.3 * surface.length);
        expect(await brightness('#hatched', true)).toEqual(hatched);
    });
});
