// Torn borders in the picture: what is trimmed there, that the page says so, and that everything can be seen.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { ask, openPage } from './support/browser_page.ts';
import { linkTo, readGallery, settled } from './support/gallery_scene.ts';
import { newContext } from './support/browser_page.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const scene = readGallery().scenes.find(({ name }) => name === 'wake-streak')!;
/** Near the body, behind which the sheet is torn. */
const camera = { position: [-1.2, -4.2, 5.2] as [number, number, number], target: [1.2, 0, 3] as [number, number, number] };

async function open(surface: Record<string, unknown> = {}): Promise<Page> {
    const context = await newContext(stand.browser, { width: 800, height: 520 });
    const link = await linkTo(stand.server, { ...scene, camera, surface: { ...scene.surface, ...surface } });
    const page = await openPage(context, link);
    await settled(page);
    return page;
}

/** Which of the pixels in the middle of the picture show the surface: 1 for each that does. */
function shown(page: Page): Promise<number[]> {
    return page.evaluate(() => {
        const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const middle = { x: canvas.left + canvas.width * 0.5, y: canvas.top + canvas.height * 0.5 };
        return window.wakesurf!.pickGrid(middle, 200).hits.map((hit) => (typeof hit?.surface === 'string' ? 1 : 0));
    });
}

describe('a torn border', () => {
    it('is trimmed on the page and not in the mesh; the page says of how many quads, and shows all when asked', async () => {
        const page = await open();
        const trimmed = await shown(page);
        const counts = await page.locator('wakesurf-status .counts').innerText();
        const number = Number(/quads \((\d+) trimmed\)/.exec(counts)?.[1]);
        const { cells } = (await ask(page, (hook) => hook.displayed))!;
        expect(number).toBeGreaterThan(50);
        expect(number).toBeLessThan(0.05 * cells);
        await expectServersMesh(stand.server, page);
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#windows-group summary').click();
        await page.getByRole('checkbox', { name: 'Trim torn borders' }).uncheck();
        await page.waitForFunction(() => !document.querySelector('wakesurf-app')!.shadowRoot!.textContent.includes('trimmed)'));
        await page.locator('text=Nothing is trimmed.').waitFor();
        await settled(page);
        const whole = await shown(page);
        const sum = (each: readonly number[]): number => each.reduce((a, b) => a + b, 0);
        // Nothing is where nothing was; a hundredth of what there is at most is trimmed.
        expect(trimmed.filter((is, i) => is === 1 && whole[i] === 0)).toHaveLength(0);
        expect(sum(whole) - sum(trimmed)).toBeGreaterThan(50);
        expect(sum(whole) - sum(trimmed)).toBeLessThan(0.02 * sum(whole));
        expect(await page.locator('wakesurf-status .counts').innerText()).not.toContain('trimmed');
        // A link says so too.
        await page.waitForFunction(() => decodeURIComponent(location.hash).includes('state='));
        await page.waitForTimeout(700);
        const again = await openPage(page.context(), page.url().replace('#', `#token=${stand.server.token}&`));
        await settled(again);
        expect(await again.locator('wakesurf-status .counts').innerText()).not.toContain('trimmed');
        await page.context().close();
    });

    it('is not there on a surface of two columns of quads, which stays as it is', async () => {
        const page = await open({
            rake: [
                [-1.5, -1.2, 1],
                [-1.5, -1.15, 1],
            ],
            seeds: 2,
        });
        expect(await page.locator('wakesurf-status .counts').innerText()).not.toContain('trimmed');
        await page.context().close();
    });
});
