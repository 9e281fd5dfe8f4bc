// Makes the pictures of the documents again, as the page saves them: `npm --prefix web-client run pictures -- [NAME...]`, all without
// names. Needs the built program and page.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { launchBrowser, newContext, openPage } from './support/browser_page.ts';
import { animatedPng, type Frame } from './support/animated_png.ts';
import { asWebp, chooseFigure, pixelsOf, savedFigure } from './support/figure_download.ts';
import { type FilmScene, linkTo, readGallery, type Scene, settled, sourceOf } from './support/gallery_scene.ts';
import { pictureBytes, pictureSize, sceneFigure } from './support/gallery_picture.ts';
import { projectRoot } from './support/project_root.ts';
import { ServerProcess, temporaryFolder } from './support/server_process.ts';
import { shell } from './support/test_browser.ts';

const folder = join(projectRoot, 'docs/pictures');
const { scenes, film } = readGallery();
const asked = process.argv.slice(3);
const wanted = (scene: Scene): boolean => asked.length === 0 || asked.includes(scene.name);
const unknown = asked.filter((name) => ![...scenes, film].some((scene) => scene.name === name));
if (unknown.length > 0) throw new Error(`there is no picture ${unknown.join(', ')} in docs/site/gallery.json`);

/** One frame after the other, each when the surface is final at its time. */
async function filmed(server: ServerProcess, page: Page, scene: FilmScene): Promise<Buffer> {
    const session = await page.evaluate(() => window.wakesurf!.session);
    const frames: Frame[] = [];
    for (let i = 0; i < scene.frames; ++i) {
        const time = scene.from + ((scene.until - scene.from) * i) / (scene.frames - 1);
        await server.call('time.set', { session, time });
        await page.waitForFunction(
            (wanted) =>
                window.wakesurf!.phase === 'final' && Math.abs((window.wakesurf!.displayed?.time ?? Infinity) - wanted) < 1e-6,
            time,
        );
        frames.push(await pixelsOf(page, await savedFigure(page)));
    }
    return animatedPng(frames, scene.framesPerSecond);
}

mkdirSync(folder, { recursive: true });
const store = temporaryFolder();
const [data, ...more] = [...new Set([...scenes, film].filter(wanted).map(sourceOf))];
const server = await ServerProcess.start({ store: store.path, data, more });
const browser = await launchBrowser(shell.flags, shell.executable);
try {
    await server.imported();
    for (const scene of scenes.filter(wanted)) {
        const { png, page } = await sceneFigure(server, browser, scene);
        const file = await asWebp(page, png, pictureBytes);
        writeFileSync(join(folder, `${scene.name}.webp`), file);
        console.log(`${scene.name}.webp: ${file.length} bytes`);
        await page.context().close();
    }
    if (wanted(film)) {
        const [width, height] = film.size;
        const context = await newContext(browser, { ...pictureSize, colorScheme: 'light' });
        const page = await openPage(context, await linkTo(server, film));
        await settled(page);
        await chooseFigure(page, { width, height, rake: film.rake ?? false, axes: film.axes ?? false, bar: false });
        const file = await filmed(server, page, film);
        writeFileSync(join(folder, `${film.name}.png`), file);
        console.log(`${film.name}.png: ${file.length} bytes`);
        await context.close();
    }
} finally {
    await browser.close();
    await server.stop();
    store.remove();
}
