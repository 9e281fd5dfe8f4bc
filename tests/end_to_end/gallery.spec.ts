// The pictures of the documents are what the page draws today: one is made again and compared with the file.
import { readFileSync } from 'node:fs';
import { inflateSync } from 'node:zlib';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { animatedPng, type Frame } from './support/animated_png.ts';
import { asWebp, pixelsOf } from './support/figure_download.ts';
import { pictureBytes, sceneFigure } from './support/gallery_picture.ts';
import { readGallery, sourceOf } from './support/gallery_scene.ts';
import { projectRoot } from './support/project_root.ts';
import { bundledStore, ServerProcess } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const { scenes } = readGallery();
const scene = scenes.find(({ name }) => name === 'tearing')!;
const kept = (name: string): Buffer => readFileSync(join(projectRoot, 'docs/pictures', `${name}.webp`));
let server: ServerProcess;

beforeAll(async () => {
    server = await ServerProcess.start({ store: bundledStore(), data: sourceOf(scene) });
});

afterAll(async () => {
    await closePages();
    await server.stop();
});

/** Mean over all pixels and channels, 0 to 255. */
function difference(a: Uint8Array, b: Uint8Array): number {
    expect(a.length).toBe(b.length);
    return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]!), 0) / a.length;
}

describe('a picture of the gallery', () => {
    it('is what the page draws of its scene', async () => {
        const { png, page } = await sceneFigure(server, await testBrowser(), scene);
        const made = await pixelsOf(page, await asWebp(page, png, pictureBytes));
        const shown = await pixelsOf(page, kept(scene.name));
        const other = await pixelsOf(page, kept('cylinder'));
        expect([made.width, made.height]).toEqual([960, 600]);
        expect(difference(made.pixels, shown.pixels)).toBeLessThan(2);
        expect(difference(made.pixels, other.pixels)).toBeGreaterThan(4);
    });
});

describe('an animated PNG', () => {
    const frame = (paint: (x: number, y: number) => [number, number, number]): Frame => {
        const [width, height] = [8, 6];
        const pixels = new Uint8Array(4 * width * height);
        for (let i = 0; i < width * height; ++i) pixels.set([...paint(i % width, Math.floor(i / width)), 255], 4 * i);
        return { width, height, pixels };
    };

    /** Type and data of each chunk. */
    const chunksOf = (file: Buffer): { type: string; data: Buffer }[] => {
        const out = [];
        for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at)) {
            out.push({
                type: file.toString('latin1', at + 4, at + 8),
                data: file.subarray(at + 8, at + 8 + file.readUInt32BE(at)),
            });
        }
        return out;
    };

    it('has of each frame what differs from the one before, and is shown by a browser as the first one', async () => {
        const red = frame(() => [200, 16, 16]);
        const dotted = frame((x, y) => (x === 3 && y === 2 ? [16, 16, 200] : [200, 16, 16]));
        const chunks = chunksOf(animatedPng([red, dotted, dotted], 10));
        expect(chunks.map(({ type }) => type)).toEqual([
            'IHDR',
            'acTL',
            'PLTE',
            'fcTL',
            'IDAT',
            'fcTL',
            'fdAT',
            'fcTL',
            'fdAT',
            'IEND',
        ]);
        const palette = chunks.find(({ type }) => type === 'PLTE')!.data;
        const [whole, part] = chunks.filter(({ type }) => type === 'fcTL').map(({ data }) => data);
        const numbers = (data: Buffer): number[] => [4, 8, 12, 16].map((at) => data.readUInt32BE(at));
        expect(numbers(whole!)).toEqual([8, 6, 0, 0]);
        expect(numbers(part!)).toEqual([1, 1, 3, 2]);
        const dot = inflateSync(chunks.find(({ type }) => type === 'fdAT')!.data.subarray(4));
        expect([...palette.subarray(3 * dot[1]!, 3 * dot[1]! + 3)]).toEqual([16, 16, 200]);

        const context = await (await testBrowser()).newContext();
        const page = await context.newPage();
        const { width, height, pixels } = await pixelsOf(
            page,
            animatedPng([frame((x) => [x * 30, 0, 0]), frame(() => [0, 0, 0])], 10),
        );
        expect([width, height]).toEqual([8, 6]);
        expect([0, 3, 7].map((x) => pixels[4 * x])).toEqual([0, 90, 210]);
        await context.close();
    });
});
