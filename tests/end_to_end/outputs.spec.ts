// What one takes away: pictures whose pixels are looked at, a film that is played, meshes compared byte for byte, and scripts
// that are run against the server and make the same records.
import { execFile } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { promisify } from 'node:util';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { ClockRecord, RakeRecord, SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext } from './support/browser_page.ts';
import { pixelsOfPng } from './support/png_pixels.ts';
import { projectRoot } from './support/project_root.ts';
import { bundledStore, temporaryFolder } from './support/server_process.ts';
import { useTestRig } from './support/test_rig.ts';

const run = promisify(execFile);
const rig = useTestRig();
const work = temporaryFolder();
const binary = process.env['WAKESURF_BINARY'] ?? join(projectRoot, 'build/release/bin/wakesurf');
let page: Page;

afterAll(() => work.remove());

beforeAll(async () => {
    page = await rig.visit({ width: 900, height: 520 });
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
});

const toExport = (): Promise<void> => page.getByRole('tab', { name: 'Export' }).click();

/** Presses a button that ends in a download, and waits for that. */
async function saved(button: string): Promise<{ name: string; path: string; bytes: Buffer }> {
    const download = page.waitForEvent('download');
    await page.locator(button).click();
    const file = await download;
    const path = join(work.path, file.suggestedFilename());
    await file.saveAs(path);
    return { name: file.suggestedFilename(), path, bytes: readFileSync(path) };
}

async function chooseSize(id: string, width: number, height: number): Promise<void> {
    await page.locator(`#${id}-size`).selectOption('typed');
    for (const [side, value] of [
        ['width', width],
        ['height', height],
    ] as const) {
        await page.locator(`#${id}-${side}`).fill(String(value));
        await page.locator(`#${id}-${side}`).press('Tab');
    }
}

/** Does what changes the surface, and waits for the new one. */
async function changed(change: () => Promise<unknown>): Promise<void> {
    const before = await ask(page, (hook) => hook.displayed!.epoch);
    await change();
    await page.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, before);
    await finalSurface(page);
}

async function records(): Promise<{ clock: ClockRecord; rakes: RakeRecord[]; surfaces: SurfaceRecord[] }> {
    const session = await ask(page, (hook) => hook.session);
    return (await rig.server.call('session.state', { session })) as never;
}

describe('a picture', () => {
    it('of twice the size has no ground but the surface, at the same places in the same colours', async () => {
        // Pixels of the page are asked for without it.
        await page.getByRole('tab', { name: 'View' }).click();
        await page.getByRole('checkbox', { name: 'Shade where things touch' }).uncheck();
        await toExport();
        const box = (await page.locator('canvas').first().boundingBox())!;
        await chooseSize('picture', 2 * box.width, 2 * box.height);
        await page.locator('#background').selectOption('clear');
        const { name, bytes } = await saved('#save-picture');
        const time = await ask(page, (hook) => hook.displayed!.time);
        expect(await page.locator('#picture-time').textContent()).toContain(`at t = ${time}`);
        expect(await page.locator('#mesh-time').textContent()).toContain(`at t = ${time}`);
        expect(name).toBe(`sqcyl-t${time}-${2 * box.width}x${2 * box.height}.png`);
        const shown = await page.evaluate(() => {
            const hook = window.wakesurf!;
            const coloured = ([r, g, b]: readonly number[]): boolean => Math.max(r!, g!, b!) - Math.min(r!, g!, b!) > 50;
            // Some vertices are behind the body, under the rake or at the rim: what counts is where the page shows colour all round.
            const places = hook.vertices(37).map(({ point }) => hook.project(point)!);
            const around = places.flatMap(({ x, y }) =>
                [0, -2, 2].flatMap((dx) => [0, -2, 2].map((dy) => ({ x: x + dx, y: y + dy }))),
            );
            const colours = hook.pixelsAt(around);
            return places.flatMap((at, i) =>
                colours.slice(9 * i, 9 * i + 9).every(coloured) ? [{ at, colour: colours[9 * i]! }] : [],
            );
        });
        expect(shown.length).toBeGreaterThan(50);
        const inPicture = shown.map(({ at }) => ({ x: 2 * (at.x - box.x), y: 2 * (at.y - box.y) }));
        const corners = [
            { x: 4, y: 4 },
            { x: box.width, y: 10 },
            { x: 4, y: 2 * box.height - 4 },
        ];
        const { width, height, at } = await pixelsOfPng(page, bytes, [...corners, ...inPicture]);
        expect([width, height]).toEqual([2 * box.width, 2 * box.height]);
        for (const corner of at.slice(0, corners.length)) expect(corner).toEqual([0, 0, 0, 0]);
        const same = at.slice(corners.length).filter(([r, g, b, alpha], i) => {
            const [red, green, blue] = shown[i]!.colour;
            return alpha === 255 && Math.hypot(r! - red, g! - green, b! - blue) < 24;
        });
        expect(same.length / shown.length).toBeGreaterThan(0.93);
        // The page is as it was.
        expect(
            await page
                .locator('canvas')
                .first()
                .evaluate((each: HTMLCanvasElement) => [each.width, each.height]),
        ).toEqual([box.width, box.height]);
        await page.getByRole('tab', { name: 'View' }).click();
        await page.getByRole('checkbox', { name: 'Shade where things touch' }).check();
    });

    it('holds bar and numbers or leaves them out, and is not drawn larger than the graphics can', async () => {
        await toExport();
        const box = (await page.locator('canvas').first().boundingBox())!;
        await chooseSize('picture', box.width, box.height);
        const axis = (await page.locator('.axis-x').boundingBox())!;
        const bar = (await page.locator('wakesurf-scalar-bar canvas').boundingBox())!;
        const inside = (from: typeof box, fx: number, fy: number) => ({
            x: from.x - box.x + fx * from.width,
            y: from.y - box.y + fy * from.height,
        });
        const letter = Array.from({ length: 12 }, (_, i) => inside(axis, (i + 0.5) / 12, 0.5));
        const ends = [inside(bar, 0.01, 0.5), inside(bar, 0.99, 0.5)];
        const opaque = (all: number[][]): number => all.filter(([, , , alpha]) => alpha! > 128).length;
        const complete = await pixelsOfPng(page, (await saved('#save-picture')).bytes, [...ends, ...letter]);
        const [low, high] = complete.at;
        expect(Math.hypot(low![0]! - 68, low![1]! - 1, low![2]! - 84)).toBeLessThan(40); // dark violet
        expect(Math.hypot(high![0]! - 253, high![1]! - 231, high![2]! - 37)).toBeLessThan(40); // yellow
        expect(opaque(complete.at.slice(2))).toBeGreaterThan(0);
        await page.getByRole('checkbox', { name: 'Scalar bar' }).uncheck();
        await page.getByRole('checkbox', { name: 'Box and axes' }).uncheck();
        const bare = await pixelsOfPng(page, (await saved('#save-picture')).bytes, [...ends, ...letter]);
        expect(opaque(bare.at)).toBe(0);
        await page.getByRole('checkbox', { name: 'Scalar bar' }).check();
        await page.getByRole('checkbox', { name: 'Box and axes' }).check();
        await chooseSize('picture', 100_000, 500);
        await page.locator('#save-picture').click();
        expect(await page.getByRole('alert').filter({ hasText: 'at most' }).textContent()).toMatch(/at most \d+ pixels per side/);
    });

    it('may be larger than the graphics draw at once: tiles make the same picture as one drawing', async () => {
        // Of fewer cells: each tile draws all of them several times, one behind the other.
        const session = await ask(page, (hook) => hook.session);
        const { surface, rake, dataset, kind, from, to, separation } = (await records()).surfaces[0]!;
        const coarse = { surface, rake, dataset, kind, from, to, separation: 3 * separation };
        await changed(() => rig.server.call('surface.set', { session, ...coarse }));
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#opacity').evaluate((slider: HTMLInputElement) => {
            slider.value = '0.5';
            slider.dispatchEvent(new Event('input', { bubbles: true }));
        });
        await page.waitForFunction(() => window.wakesurf!.transparency === 'blended');
        await toExport();
        await page.getByRole('checkbox', { name: 'Rake' }).check();
        const { differing, coloured } = await page.evaluate(() => {
            const hook = window.wakesurf!;
            const size = { width: 200, height: 131 };
            const [tiled, whole] = [hook.figure(size, 107), hook.figure(size, 2000)];
            let [differ, colours] = [0, 0];
            for (let i = 0; i < whole.length; i += 4) {
                const pixel = [0, 1, 2, 3].map((k) => i + k);
                if (Math.max(...pixel.map((at) => Math.abs(whole[at]! - tiled[at]!))) > 3) ++differ;
                const [r, g, b] = [whole[i]!, whole[i + 1]!, whole[i + 2]!];
                if (Math.max(r, g, b) - Math.min(r, g, b) > 40) ++colours;
            }
            return { differing: differ, coloured: colours };
        });
        expect(coloured).toBeGreaterThan(1_000);
        // Of 26 200; at an edge rounding may put a pixel on the other side. A seam of a tile is 131 long.
        expect(differing).toBeLessThan(30);
        // Wider than a texture may be here; opaque, since each tile of what lets light through takes a second.
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#opacity').evaluate((slider: HTMLInputElement) => {
            slider.value = '1';
            slider.dispatchEvent(new Event('input', { bubbles: true }));
        });
        await page.waitForFunction(() => window.wakesurf!.transparency !== 'blended');
        await toExport();
        await chooseSize('picture', 9000, 24);
        const { width, height, at } = await pixelsOfPng(page, (await saved('#save-picture')).bytes, [{ x: 8990, y: 12 }]);
        expect([width, height, at[0]]).toEqual([9000, 24, [0, 0, 0, 0]]);
    });
});

/** What a player makes of a film of 12 frames in a second. In a page without the content security policy of ours, which plays nothing. */
async function playedFilm(bytes: Buffer, type: string) {
    const player = await page.context().newPage();
    const played = await player.evaluate(
        async ({ data, type }) => {
            const content = Uint8Array.from(atob(data), (each) => each.charCodeAt(0));
            const video = document.createElement('video');
            video.muted = true;
            document.body.append(video);
            video.src = URL.createObjectURL(new Blob([content], { type }));
            await new Promise((resolve, reject) => {
                video.onloadeddata = resolve;
                video.onerror = () => reject(new Error(video.error?.message));
            });
            const drawing = new OffscreenCanvas(video.videoWidth, video.videoHeight).getContext('2d', {
                willReadFrequently: true,
            })!;
            const frames: Uint8ClampedArray[] = [];
            for (let i = 0; i < 12; ++i) {
                const sought = new Promise((resolve) => video.requestVideoFrameCallback(resolve));
                video.currentTime = (i + 0.5) / 12;
                await sought;
                drawing.drawImage(video, 0, 0);
                frames.push(drawing.getImageData(0, 0, video.videoWidth, video.videoHeight).data);
            }
            const differ = (a: Uint8ClampedArray, b: Uint8ClampedArray): number =>
                a.reduce((sum, value, k) => sum + (Math.abs(value - b[k]!) > 24 ? 1 : 0), 0);
            const changes = frames.slice(1).map((frame, i) => differ(frame, frames[i]!));
            return { duration: video.duration, size: [video.videoWidth, video.videoHeight], changes };
        },
        { data: bytes.toString('base64'), type },
    );
    await player.close();
    return played;
}

describe('a film', () => {
    it('has every frame of the playback; it and one that is cancelled leave the clock as it was', async () => {
        await page.getByRole('tab', { name: 'Flow' }).click();
        await changed(() => page.getByRole('radio', { name: 'Streak' }).check());
        const session = await ask(page, (hook) => hook.session);
        await rig.server.call('time.set', { session, time: 10 });
        await page.waitForFunction(() => window.wakesurf!.displayed!.time === 10);
        await toExport();
        await chooseSize('film', 320, 240);
        await page.locator('#film-fps').selectOption('12');
        await page.locator('#film-seconds').fill('1');
        await page.locator('#film-seconds').press('Tab');
        const { bytes, name } = await saved('#record-film');
        expect(name).toBe('sqcyl-film.webm');
        await expect.poll(async () => (await records()).clock).toMatchObject({ time: 10, playing: false });
        const played = await playedFilm(bytes, 'video/webm');
        expect(played.size).toEqual([320, 240]);
        expect(played.duration).toBeCloseTo(1, 1);
        // The sheet grows from frame to frame.
        expect(played.changes).toHaveLength(11);
        expect(Math.min(...played.changes)).toBeGreaterThan(20);
        // As MP4, and from one saved view to another, where there are two.
        const eye = await ask(page, (hook) => hook.camera);
        for (const [name, x] of [
            ['front', -8],
            ['behind', 8],
        ] as const) {
            const view = { camera: { position: [x, -20, 12], target: eye.target, orthographic: false } };
            await rig.server.call('bookmark.set', { session, name, view });
        }
        await page.getByLabel('front').check();
        await page.getByLabel('behind').check();
        await page.locator('#film-format').selectOption('mp4');
        const second = await saved('#record-film');
        expect(second.name).toBe('sqcyl-film.mp4');
        const replayed = await playedFilm(second.bytes, 'video/mp4');
        expect(replayed.size).toEqual([320, 240]);
        expect(replayed.duration).toBeCloseTo(1, 1);
        // All of the picture moves, not the sheet alone.
        expect(Math.min(...replayed.changes)).toBeGreaterThan(2 * Math.min(...played.changes));
        const { position } = await ask<typeof eye>(page, (hook) => hook.camera);
        expect(Math.hypot(...position.map((each, k) => each - eye.position[k]!))).toBeLessThan(1e-6);
        await page.getByLabel('front').uncheck();
        // Another one, and not to its end.
        await chooseSize('film', 160, 120);
        await page.locator('#film-seconds').fill('60');
        await page.locator('#film-seconds').press('Tab');
        await page.locator('#record-film').click();
        await page.waitForFunction(() => window.wakesurf!.displayed!.time < 9.5);
        // Before the first frame it looks what colours range over, at 13 times.
        await expect.poll(() => page.getByRole('progressbar').getAttribute('max'), { timeout: 30_000 }).toBe('720');
        await page.getByRole('button', { name: 'Cancel' }).click();
        await page.locator('#record-film').waitFor();
        await expect.poll(async () => (await records()).clock.time).toBe(10);
    });
});

describe('a script', () => {
    const environment = (): NodeJS.ProcessEnv => ({ ...process.env, WAKESURF_TOKEN: rig.server.token });
    /** After what its first lines say is to be done. */
    const runPython = async (text: string) => {
        await runShell(/^# +(curl .*)$/m.exec(text)![1]!);
        return run('/usr/bin/python3', ['-c', text], { env: environment(), cwd: work.path });
    };
    const runShell = (text: string) => run('bash', ['-c', text], { env: environment(), cwd: work.path });
    const copied = async (language: string): Promise<string> => {
        const buttons = page.locator('wakesurf-copy-as');
        await buttons.getByRole('button', { name: language }).click();
        await buttons.getByText(`Copied as ${language}`).waitFor();
        const text = await page.evaluate(() => navigator.clipboard.readText());
        expect(text).not.toContain(rig.server.token);
        return text;
    };
    /** Without what the server adds to each record. */
    const asked = ({ surface: _surface, rake: _rake, rev: _rev, epoch: _epoch, ...rest }: SurfaceRecord) => rest;
    const placed = ({ rake: _rake, rev: _rev, author: _author, ...rest }: RakeRecord) => rest;

    it('fetches the surface that is there; where it is gone, it makes the same rake and surface', async () => {
        await page.getByRole('tab', { name: 'Flow' }).click();
        const before = await records();
        const [python, curl] = [await copied('Python'), await copied('curl')];
        expect(String((await runPython(python)).stdout)).toMatch(/^\d+ quads$/m);
        await runShell(curl);
        expect(readFileSync(join(work.path, 'surface.vtp')).length).toBeGreaterThan(1000);
        expect(await records()).toEqual(before);
        const shown = before.surfaces[0]!.surface;
        for (const [script, runs] of [
            [python.replaceAll(JSON.stringify(shown), '"gone"'), runPython],
            [curl.replaceAll(`'${shown}'`, "'gone'"), runShell],
        ] as const) {
            await runs(script);
            const after = await records();
            const made = after.surfaces.at(-1)!;
            expect(after.surfaces.map(({ surface }) => surface)).toContain(made.surface);
            expect(before.surfaces.map(({ surface }) => surface)).not.toContain(made.surface);
            expect(asked(made)).toEqual(asked(before.surfaces[0]!));
            const rake = after.rakes.find((each) => each.rake === made.rake)!;
            expect(placed(rake)).toEqual(placed(before.rakes[0]!));
            await rig.server.call('rake.delete', {
                session: await ask(page, (hook) => hook.session),
                rake: made.rake,
            });
        }
    });

    it('fetches the mesh', async () => {
        await toExport();
        await page.locator('#mesh-format').selectOption('ply');
        const { bytes } = await saved('#download-mesh');
        for (const [language, runs] of [
            ['Python', runPython],
            ['curl', runShell],
        ] as const) {
            await runs(await copied(language));
            expect(readFileSync(join(work.path, 'surface.ply')).equals(bytes)).toBe(true);
        }
    });
});

describe('an animation', () => {
    interface Hook {
        count: number;
        step: () => number;
        goTo: (step: number) => void;
        bodyVertices: () => number;
    }
    const hook = <T>(shown: Page, read: (animation: Hook) => T): Promise<T> =>
        shown.evaluate(`(${String(read)})(window.wakesurfAnimation)`);

    it('is the surface in the colours of the page, with the body, from a disk; and is made again from its recipe', async () => {
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('input[name=map][value=plasma]').check();
        await toExport();
        await page.locator('#animation-steps').fill('5');
        await page.locator('#animation-steps').press('Tab');
        const { name, path, bytes } = await saved('#download-animation');
        expect(name).toMatch(/^sqcyl-\w+-animation\.html$/);
        expect(bytes.toString('utf8')).toContain('"map":"plasma"');
        const context = await newContext(rig.browser);
        await context.setOffline(true);
        const shown = await context.newPage();
        await shown.goto(`file://${path}`);
        await shown.waitForFunction(() => 'wakesurfAnimation' in window);
        expect(await hook(shown, (animation) => animation.count)).toBe(5);
        expect(await hook(shown, (animation) => animation.bodyVertices())).toBeGreaterThan(100);
        await run(binary, ['verify', path, join(projectRoot, 'data/sqcyl/sqcyl.pvd'), '--store', bundledStore()]);
        await context.close();
    }, 120_000);
});
