// A PNG file, decoded by the browser.
import type { Page } from 'playwright-core';

export interface PngPixels {
    width: number;
    height: number;
    /** RGBA of the points asked for. */
    at: number[][];
}

/** Size of a PNG, and some of its pixels. */
export function pixelsOfPng(page: Page, png: Buffer, points: { x: number; y: number }[]): Promise<PngPixels> {
    return page.evaluate(
        async ({ data, places }) => {
            const bytes = Uint8Array.from(atob(data), (each) => each.charCodeAt(0));
            const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
            const canvas = new OffscreenCanvas(image.width, image.height);
            const drawing = canvas.getContext('2d')!;
            drawing.drawImage(image, 0, 0);
            const at = places.map(({ x, y }) => [...drawing.getImageData(Math.floor(x), Math.floor(y), 1, 1).data]);
            return { width: image.width, height: image.height, at };
        },
        { data: png.toString('base64'), places: points },
    );
}
