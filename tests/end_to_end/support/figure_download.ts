// A picture as the page saves it, of any size, and the same as a small file for documents.
import { readFileSync } from 'node:fs';
import type { Page } from 'playwright-core';

export interface FigureChoice {
    width: number;
    height: number;
    rake: boolean;
    axes: boolean;
    bar: boolean;
    /** On the page's own ground, rather than on white. */
    dark?: boolean;
}

/** Chooses what the pictures to come are like. */
export async function chooseFigure(page: Page, choice: FigureChoice): Promise<void> {
    await page.getByRole('tab', { name: 'Export' }).click();
    await page.locator('#picture-size').selectOption('typed');
    for (const side of ['width', 'height'] as const) {
        await page.locator(`#picture-${side}`).fill(String(choice[side]));
        await page.locator(`#picture-${side}`).press('Tab');
    }
    await page.locator('#background').selectOption(choice.dark === true ? 'shown' : 'white');
    for (const [label, on] of [
        ['Scalar bar', choice.bar],
        ['Box and axes', choice.axes],
        ['Rake', choice.rake],
    ] as const) {
        await page.getByRole('checkbox', { name: label, exact: true }).setChecked(on);
    }
}

/** A PNG, by the page's own button. */
export async function savedFigure(page: Page): Promise<Buffer> {
    const download = page.waitForEvent('download');
    await page.locator('#save-picture').click();
    return readFileSync(await (await download).path());
}

/** RGBA, decoded by the browser. */
export async function pixelsOf(page: Page, file: Buffer): Promise<{ width: number; height: number; pixels: Buffer }> {
    const { width, height, data } = await page.evaluate(async (text) => {
        const bytes = Uint8Array.from(atob(text), (each) => each.charCodeAt(0));
        const image = await createImageBitmap(new Blob([bytes]));
        const canvas = new OffscreenCanvas(image.width, image.height);
        const drawing = canvas.getContext('2d')!;
        drawing.drawImage(image, 0, 0);
        const { data: pixels } = drawing.getImageData(0, 0, image.width, image.height);
        let out = '';
        for (let at = 0; at < pixels.length; at += 32768) out += String.fromCharCode(...pixels.subarray(at, at + 32768));
        return { width: image.width, height: image.height, data: btoa(out) };
    }, file.toString('base64'));
    return { width, height, pixels: Buffer.from(data, 'base64') };
}

/** The best WebP of at most so many bytes. Error: in words, where there is none. */
export async function asWebp(page: Page, png: Buffer, bytesAtMost: number): Promise<Buffer> {
    const data = await page.evaluate(
        async ({ text, most }) => {
            const bytes = Uint8Array.from(atob(text), (each) => each.charCodeAt(0));
            const image = await createImageBitmap(new Blob([bytes]));
            const canvas = new OffscreenCanvas(image.width, image.height);
            canvas.getContext('2d')!.drawImage(image, 0, 0);
            for (let quality = 0.92; quality > 0.3; quality -= 0.06) {
                const file = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/webp', quality })).arrayBuffer());
                if (file.length <= most) return btoa(Array.from(file, (each) => String.fromCharCode(each)).join(''));
            }
            return '';
        },
        { text: png.toString('base64'), most: bytesAtMost },
    );
    if (data === '') throw new Error(`no WebP of this picture has at most ${bytesAtMost} bytes: make it smaller`);
    return Buffer.from(data, 'base64');
}
