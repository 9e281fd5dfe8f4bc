// A scene of the gallery as a picture: the page shows it, and saves it.
import type { Browser, Page } from 'playwright-core';
import { newContext, openPage } from './browser_page.ts';
import { chooseFigure, savedFigure } from './figure_download.ts';
import { linkTo, type Scene, settled } from './gallery_scene.ts';
import type { ServerProcess } from './server_process.ts';

/** Of the page, in pixels of CSS. */
export const pictureSize = { width: 1100, height: 620 };
/** Of a picture in the documents. */
export const pictureBytes = 60_000;

/** A PNG, and the page that still shows it. */
export async function sceneFigure(server: ServerProcess, browser: Browser, scene: Scene): Promise<{ png: Buffer; page: Page }> {
    const context = await newContext(browser, { ...pictureSize, colorScheme: scene.dark === true ? 'dark' : 'light' });
    const page = await openPage(context, await linkTo(server, scene));
    await settled(page);
    const [width, height] = scene.size ?? [960, 600];
    const coloured = scene.slices ?? scene.lines ?? scene.body?.colourBy;
    const bar = scene.look.colourBy !== 'constant' || coloured !== undefined;
    await chooseFigure(page, {
        width,
        height,
        rake: scene.rake ?? false,
        axes: scene.axes ?? false,
        bar,
        dark: scene.dark ?? false,
    });
    return { png: await savedFigure(page), page };
}
