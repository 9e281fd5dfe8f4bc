// Lines, ribbons and arrows instead of the whole surface: what the page shows is what the file of them has.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { ask, newContext, openPage } from './support/browser_page.ts';
import { linkTo, readGallery, settled } from './support/gallery_scene.ts';
import { useStand } from './support/stand.ts';

type Point = [number, number, number];

const stand = useStand();
const scene = readGallery().scenes.find(({ name }) => name === 'wake-streak')!;
const camera = { position: [3, -9, 9] as Point, target: [3, 0, 3] as Point };
let page: Page;

beforeAll(async () => {
    const context = await newContext(stand.browser, { width: 800, height: 520 });
    page = await openPage(context, await linkTo(stand.server, { ...scene, camera, surface: { ...scene.surface } }));
    await settled(page);
    await page.getByRole('tab', { name: 'Look' }).click();
    await page.locator('#pieces-group summary').click();
});

/** Half the side of the square in the middle of the picture that is looked at. */
const half = 180;

/** Points of the surface that are seen in the middle of the picture. */
function seen(): Promise<Point[]> {
    return page.evaluate((radius) => {
        const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const middle = { x: canvas.left + canvas.width * 0.5, y: canvas.top + canvas.height * 0.5 };
        return window
            .wakesurf!.pickGrid(middle, radius)
            .hits.flatMap((hit) => (typeof hit?.surface === 'string' ? [hit.point] : []));
    }, half);
}

/** Whether the surface is seen at points of space, or beside them by a pixel; undefined for those outside the middle of the picture. */
function seenAt(points: readonly Point[]): Promise<(boolean | undefined)[]> {
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
        [points as Point[], half] as const,
    );
}

/** The polygons of a file, or its lines, as their corners. */
async function polygons(lines: string, head = 'f'): Promise<Point[][]> {
    const session = (await ask(page, (hook) => hook.session))!;
    const { surface } = await ask(page, (hook) => hook.displayed!);
    const path = `/api/v1/sessions/${encodeURIComponent(session)}/surfaces/${surface}/mesh.obj?lines=${encodeURIComponent(lines)}`;
    const reply = await fetch(new URL(path, stand.server.link), { headers: { Authorization: `Bearer ${stand.server.token}` } });
    expect(reply.status).toBe(200);
    const rows = (await reply.text()).split('\n').map((row) => row.split(' '));
    const points = rows.filter(([first]) => first === 'v').map(([, x, y, z]) => [Number(x), Number(y), Number(z)] as Point);
    return rows.filter(([first]) => first === head).map(([, ...corners]) => corners.map((corner) => points[Number(corner) - 1]!));
}

const apart = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
const middleOf = (corners: readonly Point[]): Point =>
    [0, 1, 2].map((axis) => corners.reduce((sum, p) => sum + p[axis]!, 0) / corners.length) as Point;

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
    for (const [pieces, name] of [
        ['seedribbons', 'streakribbons'],
        ['timeribbons', 'timeribbons'],
    ] as const) {
        it(`can be ${name}, the same as in a file`, async () => {
            await choose(pieces, 0.5, 0.15);
            const cut = await polygons(`${name}:every=0.5,width=0.15`);
            expect(cut.length).toBeGreaterThan(500);
            const middles = cut.map(middleOf);
            const there = (await seenAt(middles))
                .map((at, i) => ({ at, middle: middles[i]! }))
                .filter(({ at }) => at !== undefined);
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
    }

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
    });
});
