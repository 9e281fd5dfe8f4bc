// How long after opening it a page of any server shows its first surface whole: first_surface.ts URL. Prints one line of JSON.
import { finalSurface, launchBrowser, newContext, openPage } from './support/browser_page.ts';

const address = process.argv[3]; // after this file, which tools/run_typescript.mjs was given
if (address === undefined) {
    throw new Error('give the address that the server printed');
}
const start = performance.now();
const browser = await launchBrowser();
try {
    const page = await openPage(await newContext(browser, { width: 1280, height: 720 }), address);
    await finalSurface(page);
    console.log(JSON.stringify({ name: 'first-surface', withBrowserMs: Math.round(performance.now() - start) }));
} finally {
    await browser.close();
}
