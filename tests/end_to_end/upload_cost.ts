// What new states of a surface cost the page's main thread: the scene takes them and submits a frame, in real Chromium. Prints one
// line of JSON: 100 000 vertices that all move, 10 000 that come to a surface of 100 000, and the same on 500 000 quads.
import { launchBrowser } from './support/browser_page.ts';
import { openBundledPage } from './support/bundled_page.ts';
import type { UploadCosts } from './support/upload_page.ts';

const browser = await launchBrowser();
try {
    const { page, close } = await openBundledPage(browser, 'upload_page.ts', { width: 640, height: 400 });
    await page.waitForFunction(() => window.uploadCosts !== undefined);
    const costs: UploadCosts = await page.evaluate(() => window.uploadCosts!());
    await close();
    console.log(JSON.stringify({ name: 'browser-uploads', ...costs }));
} finally {
    await browser.close();
}
