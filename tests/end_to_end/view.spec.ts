// The view: cameras, what the axes' marker shows, views that are kept, links that bring them back, dark and light.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import { readFragment } from '../../web-client/src/session/view/urlState.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { framesPass } from './support/frames.ts';
import { hitsOver } from './support/look_facts.ts';
import { expectSamePoints } from './support/same_points.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 900, height: 560 });
});

interface Seen {
    x: number;
    y: number;
}

function project(points: Vec3[]): Promise<Seen[]> {
    return page.evaluate((all) => all.map((point) => window.wakesurf!.project(point)!), points);
}

/** Where an end of the axes' marker is drawn, from the marker's middle. */
async function endOf(words: string): Promise<Seen> {
    const marker = (await page.getByRole('group', { name: 'Axes' }).boundingBox())!;
    const circle = page.getByRole('button', { name: words }).locator('circle').last();
    const box = (await circle.boundingBox())!;
    return {
        x: box.x + box.width / 2 - marker.x - marker.width / 2,
        y: box.y + box.height / 2 - marker.y - marker.height / 2,
    };
}

describe('the camera', () => {
    it('looks along an axis from the end that was clicked, and the marker turns with it', async () => {
        await page.getByRole('button', { name: 'Fit the whole domain' }).click();
        for (const [words, axis, side] of [
            ['+x: look against x', 0, 1],
            ['-y: look along y', 1, -1],
        ] as const) {
            await page.getByRole('button', { name: words }).click();
            const { position, target } = await ask(page, (hook) => hook.camera);
            const towards = position.map((value, i) => value - target[i]!);
            expect(Math.sign(towards[axis]!)).toBe(side);
            towards.forEach((value, i) => i === axis || expect(Math.abs(value)).toBeLessThan(1e-6));
        }
        // Against y from -y: x to the right, z up, on the marker as in the picture.
        await expect.poll(async () => (await endOf('+x: look against x')).x).toBeGreaterThan(20);
        const [centre, along, up] = await project([
            [5, 0, 3],
            [6, 0, 3],
            [5, 0, 4],
        ]);
        const [x, z] = [await endOf('+x: look against x'), await endOf('+z: look against z')];
        expect(along!.x).toBeGreaterThan(centre!.x);
        expect(Math.abs(x.y)).toBeLessThan(1);
        expect(up!.y).toBeLessThan(centre!.y);
        expect(z.y).toBeLessThan(-20);
    });

    it('without perspective shows equal lengths equal, near and far, with the target where it was', async () => {
        await page.getByRole('button', { name: 'Fit the whole domain' }).click();
        const stick: Vec3[] = [
            [-2, -3, 1],
            [-2, -3, 3],
            [10, 3, 1],
            [10, 3, 3],
        ];
        const lengths = async (): Promise<[number, number]> => {
            const [a, b, c, d] = await project(stick);
            return [Math.hypot(b!.x - a!.x, b!.y - a!.y), Math.hypot(d!.x - c!.x, d!.y - c!.y)];
        };
        const [near, far] = await lengths();
        expect(near / far).toBeGreaterThan(1.05);
        const target = (await ask(page, (hook) => hook.camera)).target;
        const [before] = await project([target]);
        await page.getByRole('button', { name: 'Parallel' }).click();
        const [alike, like] = await lengths();
        expect(alike / like).toBeCloseTo(1, 6);
        const [after] = await project([target]);
        expect(after!.x).toBeCloseTo(before!.x, 3);
        expect(after!.y).toBeCloseTo(before!.y, 3);
        // A handle is where it is drawn in this projection too.
        const handle = (await ask(page, (hook) => hook.handleOnScreen(0)))!;
        await page.mouse.move(handle.x, handle.y);
        await page.mouse.down();
        await page.mouse.move(handle.x + 12, handle.y + 8, { steps: 3 });
        const moved = (await ask(page, (hook) => hook.handleOnScreen(0)))!;
        await page.mouse.up();
        expect(moved.x).toBeCloseTo(handle.x + 12, 1);
        expect(moved.y).toBeCloseTo(handle.y + 8, 1);
        await finalSurface(page);
        await page.getByRole('button', { name: 'Parallel' }).click();
    });

    it('fits the domain by a key', async () => {
        await page.evaluate(() => window.wakesurf!.setCamera([200, 300, 100], [0, 0, 0]));
        await page
            .locator('canvas')
            .first()
            .click({ position: { x: 20, y: 300 } });
        await page.keyboard.press('f');
        const corners = await page.evaluate(() => {
            const b = window.wakesurf!.bounds!;
            return [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
                window.wakesurf!.project([b[i & 1]!, b[2 + ((i >> 1) & 1)]!, b[4 + (i >> 2)]!])!,
            );
        });
        const canvas = (await page.locator('canvas').first().boundingBox())!;
        for (const { x, y } of corners) {
            expect(x).toBeGreaterThan(canvas.x);
            expect(x).toBeLessThan(canvas.x + canvas.width);
            expect(y).toBeGreaterThan(canvas.y);
            expect(y).toBeLessThan(canvas.y + canvas.height);
        }
    });
});

function cameraInAddress(of: Page) {
    return readFragment(new URL(of.url()).hash).state?.view.camera;
}

describe('views that are kept', () => {
    const place = { position: [14, -30, 9] as Vec3, target: [4, 0.5, 2] as Vec3 };

    it('come back with a click, for everyone in the session, and go when they are deleted', async () => {
        await page.getByRole('tab', { name: 'View' }).click();
        await page.evaluate((to) => window.wakesurf!.setCamera(to.position, to.target), place);
        await page.getByLabel('Name of the view').fill('From the wake');
        await page.getByRole('button', { name: 'Keep' }).click();
        const kept = page.getByRole('button', { name: 'From the wake', exact: true });
        await kept.waitFor();
        const session = await ask(page, (hook) => hook.session);
        const { bookmarks } = (await rig.server.call('bookmark.list', { session })) as {
            bookmarks: { name: string; view: object }[];
        };
        expect(bookmarks).toMatchObject([{ name: 'From the wake', view: { camera: { target: place.target } } }]);

        await page.getByRole('button', { name: 'Fit the whole domain' }).click();
        await kept.click();
        const camera = await ask(page, (hook) => hook.camera);
        expectSamePoints([camera.position, camera.target], [place.position, place.target]);
        await page.getByRole('button', { name: 'Delete the view From the wake' }).click();
        await kept.waitFor({ state: 'detached' });
    });

    it('are in the address: a link opens the same picture', async () => {
        await page.evaluate((to) => window.wakesurf!.setCamera(to.position, to.target), place);
        await expect.poll(() => cameraInAddress(page)?.position[0]).toBe(place.position[0]);
        const again = await rig.open(page, page.url());
        const camera = await ask(again, (hook) => hook.camera);
        expectSamePoints([camera.position, camera.target], [place.position, place.target], 3);
        await expectServersMesh(rig.server, again);
        await again.close();
    });
});

describe('what a brush has revealed', () => {
    const shown = async (of: Page): Promise<Set<string>> => {
        const hits = await hitsOver(of, 6);
        return new Set(hits.filter(({ surface }) => surface !== null).map(({ at }) => `${at.x} ${at.y}`));
    };
    const apart = (a: Set<string>, b: Set<string>): number =>
        [...a].filter((at) => !b.has(at)).length + [...b].filter((at) => !a.has(at)).length;
    const masksOf = (page: Page) => readFragment(new URL(page.url()).hash).state?.view.masks ?? {};

    it('is in the link that someone else opens', async () => {
        const page = await rig.visit({ width: 780, height: 510 });
        await page.evaluate(() => window.wakesurf!.setCamera([4, -16, 7], [3.5, 0, 2.8]));
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#paint-group summary').click();
        // A place with the surface all round it.
        const places = await shown(page);
        const around = [-60, -30, 0, 30, 60].flatMap((dx) => [-24, 0, 24].map((dy) => ({ dx, dy })));
        const [x, y] = [...places]
            .map((at) => at.split(' ').map(Number) as [number, number])
            .find((at) => around.every(({ dx, dy }) => places.has(`${at[0] + dx} ${at[1] + dy}`)))!;
        await page.locator('#painting').check();
        await expect.poll(async () => (await shown(page)).size).toBe(0);
        await page.mouse.move(x - 60, y);
        await page.mouse.down();
        await page.mouse.move(x + 60, y, { steps: 4 });
        await page.mouse.up();
        await expect.poll(async () => (await shown(page)).size).toBeGreaterThan(100);
        // The picture has the whole stroke when what was moved has been drawn; the address follows within half a second.
        await framesPass(page, 2);
        await expect
            .poll(async () => {
                const inAddress = masksOf(page);
                const drawn = await page.evaluate((ids) => ids.map((id) => window.wakesurf!.maskOf(id)), Object.keys(inAddress));
                return drawn.length === 1 && JSON.stringify(drawn) === JSON.stringify(Object.values(inAddress));
            })
            .toBe(true);
        const painted = await shown(page);
        expect(Object.keys(masksOf(page))).toHaveLength(1);
        expect(JSON.stringify(masksOf(page)).length).toBeLessThan(850);

        const link = new URL(page.url());
        link.hash += `&token=${rig.server.token}`;
        const other = await rig.visit({ width: 780, height: 510, link: link.href });
        // Texels of the code are some pixels wide: what differs is the border.
        await expect.poll(async () => apart(painted, await shown(other))).toBeLessThan(0.1 * painted.size);
        await other.context().close();
        await page.context().close();
    });
});

describe('dark and light', () => {
    it('change page and picture, and are kept for the next visit', async () => {
        const corner = (of: Page): Promise<number[]> => ask(of, (hook) => hook.pixelsAt([{ x: 6, y: 300 }])[0]!);
        const dark = await corner(page);
        expect(Math.max(...dark)).toBeLessThan(60);
        await page.getByLabel('Colours of the page').selectOption('light');
        expect(Math.min(...(await corner(page)))).toBeGreaterThan(220);
        const again = await rig.open(page, page.url());
        expect(Math.min(...(await corner(again)))).toBeGreaterThan(220);
        await again.close();
        await page.getByLabel('Colours of the page').selectOption('follow the system');
        expect(await corner(page)).toEqual(dark);
    });
});
