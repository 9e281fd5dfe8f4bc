// What one can do without a mouse in the picture, and for a picture with more room and less in it: hide, lock, fold, turn by keys.
import type { Page } from 'playwright-core';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';
import { readFragment } from '../../web-client/src/session/view/urlState.ts';
import type { SurfaceStatus } from '../../web-client/src/state/appState.ts';
import { ask } from './support/browser_page.ts';
import { takeHandle } from './support/rake_drag.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

const canvasSize = (): Promise<{ width: number; height: number }> =>
    page.locator('main > canvas').evaluate(({ clientWidth, clientHeight }) => ({ width: clientWidth, height: clientHeight }));
const drawnRakes = (): Promise<string[]> => ask(page, (hook) => hook.rakes.map(({ rake }) => rake));
const displayed = (): Promise<number> => ask(page, (hook) => hook.allDisplayed.length);

/** What the server has sent of surfaces so far, in frames. */
const sent = (): Promise<number> => rig.metric('wakesurf_stage_seconds_count{stage="send"}');

const size = { width: 1440, height: 900 };
/** Of all tests after which it is as before. */
let shared: Page;

beforeAll(async () => {
    shared = await rig.visit(size);
});

beforeEach(async () => {
    page = shared;
    await page.setViewportSize(size);
});

describe('a rake that is hidden', () => {
    beforeEach(async () => {
        page = await rig.visit();
        return () => page.context().close();
    });

    it('is not drawn, nor its surface, of which nothing is sent; after a reload it is hidden still', async () => {
        await page
            .getByRole('button', { name: /^Hide / })
            .first()
            .click();
        await expect.poll(drawnRakes).toEqual([]);
        await expect.poll(displayed).toBe(0);
        expect(await ask(page, (hook) => hook.phase)).toBe('hidden');
        const before = await sent();
        const longer = async (): Promise<void> => {
            const epoch = await ask(page, (hook) => hook.requestedEpoch);
            await page.locator('#length').press('ArrowRight');
            await page.waitForFunction((old) => window.wakesurf!.requestedEpoch > old, epoch);
        };
        await longer();
        // The server has made the surface to its end, and has answered on the connection that it would have sent it by.
        const session = await ask(page, (hook) => hook.session);
        const { surfaces } = (await rig.server.call('surface.list', { session })) as { surfaces: { surface: string }[] };
        await rig.server.call('surface.wait', { session, surface: surfaces[0]!.surface, timeoutMs: 20_000 });
        await longer();
        expect(await sent()).toBe(before);
        // The address follows within half a second.
        await expect.poll(() => readFragment(new URL(page.url()).hash).state?.view.shown).toBeDefined();
        await page.reload();
        await page.waitForFunction(() => window.wakesurf?.phase === 'hidden');
        expect(await drawnRakes()).toEqual([]);
        await page
            .getByRole('button', { name: /^Hide / })
            .first()
            .click();
        await page.waitForFunction(() => window.wakesurf?.phase === 'final');
        expect(await displayed()).toBe(1);
    });

    it('is all but the one that is to be shown alone, until that is taken back', async () => {
        await page.getByRole('button', { name: 'New rake' }).click();
        await expect.poll(displayed).toBe(2);
        await page.getByRole('button', { name: 'Show only Rake 2' }).click();
        await expect.poll(drawnRakes).toHaveLength(1);
        await expect.poll(displayed).toBe(1);
        const [alone] = await drawnRakes();
        await page.getByRole('button', { name: 'Show only Rake 1' }).click();
        await expect.poll(async () => (await drawnRakes()).includes(alone!)).toBe(false);
        expect(await drawnRakes()).toHaveLength(1);
        await page.getByRole('button', { name: 'Show only Rake 1' }).click();
        await expect.poll(displayed).toBe(2);
    });
});

describe('a rake that is locked', () => {
    it('does not move, says why, and leaves the camera where it is', async () => {
        await page
            .getByRole('button', { name: /^Lock / })
            .first()
            .click();
        const before = await ask(page, (hook) => [hook.camera, hook.rakePoints]);
        const from = await takeHandle(page, 'middle');
        await page.mouse.move(from.x - 60, from.y + 25, { steps: 4 });
        await page.mouse.up();
        expect(await ask(page, (hook) => [hook.camera, hook.rakePoints])).toEqual(before);
        await page.getByText('You have locked this rake.').waitFor();
        await page.getByRole('button', { name: 'Unlock' }).click();
        await takeHandle(page, 'middle');
        await page.mouse.move(from.x - 20, from.y, { steps: 4 });
        await page.mouse.up();
        const after = await ask(page, (hook) => [hook.camera, hook.rakePoints]);
        expect(after[0]).toEqual(before[0]);
        expect(after[1]).not.toEqual(before[1]);
    });
});

describe('room for the picture', () => {
    it('is made by folding the panel away, with a button and with a key, on a desk and on a phone', async () => {
        for (const [width, height, side, gained] of [
            [1440, 900, 'width', 304],
            [844, 390, 'width', 304],
            [390, 844, 'height', 300],
        ] as const) {
            await page.setViewportSize({ width, height });
            const before = await canvasSize();
            const button = page.getByRole('button', { name: 'Panel' });
            await button.click();
            await expect.poll(async () => (await canvasSize())[side]).toBeGreaterThanOrEqual(before[side] + gained);
            expect(await page.locator('wakesurf-panel').isVisible()).toBe(false);
            const timeBar = await page.locator('wakesurf-time-bar').boundingBox();
            expect(timeBar!.width).toBe(width);
            expect(timeBar!.y + timeBar!.height).toBeLessThanOrEqual(height);
            await page.keyboard.press('p');
            await expect.poll(canvasSize).toEqual(before);
            expect(await button.getAttribute('aria-expanded')).toBe('true');
        }
    });
});

describe('the camera', () => {
    it('is turned by arrows where the picture has the focus, and leaves them to the handle whose button has it', async () => {
        await page.locator('main > canvas').focus();
        const start = await ask(page, (hook) => hook.camera);
        await page.keyboard.press('ArrowRight');
        const turned = await ask(page, (hook) => hook.camera);
        expect(turned.target).toEqual(start.target);
        expect(turned.position).not.toEqual(start.position);
        const before = await ask(page, (hook) => [hook.camera, hook.rakePoints]);
        await page.locator('wakesurf-rake').getByRole('button', { name: 'Start' }).first().focus();
        await page.keyboard.press('ArrowUp');
        await page.waitForFunction((points) => JSON.stringify(window.wakesurf!.rakePoints) !== points, JSON.stringify(before[1]));
        expect(await ask(page, (hook) => hook.camera)).toEqual(before[0]);
    });
});

describe('a list', () => {
    it('shows all of what can be chosen in it, in any tab', async () => {
        const cut = new Set<string>();
        for (const tab of await page.getByRole('tab').all()) {
            await tab.click();
            for (const folded of await page.locator('details').all()) {
                await folded.evaluate((details: HTMLDetailsElement) => (details.open = true));
            }
            for (const list of await page.locator('select:visible').all()) {
                const short = await list.evaluate((select: HTMLSelectElement) => {
                    const pen = document.createElement('canvas').getContext('2d')!;
                    const { font, paddingLeft, paddingRight } = getComputedStyle(select);
                    pen.font = font;
                    // Beside the text is the arrow.
                    const room = select.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight) - 12;
                    return [...select.options].map(({ text }) => text).filter((text) => pen.measureText(text).width > room);
                });
                for (const text of short) cut.add(text);
            }
        }
        expect([...cut]).toEqual([]);
        await page.getByRole('tab').first().click();
    });
});

describe('the status', () => {
    it('is as high while a surface is computed as when it is there', async () => {
        const height = (): Promise<number> => page.locator('wakesurf-status').evaluate((each) => each.clientHeight);
        // With all that is said of one that is there.
        await page
            .locator('wakesurf-status')
            .getByText(/^Final, 99 %/)
            .waitFor();
        const before = await height();
        const tell = (status: SurfaceStatus | null): Promise<void> =>
            page.evaluate((value) => {
                const status = document
                    .querySelector('wakesurf-app')!
                    .shadowRoot!.querySelector('wakesurf-panel')!
                    .shadowRoot!.querySelector('wakesurf-status') as unknown as {
                    model: { state: { progress: { value: unknown } } };
                };
                status.model.state.progress.value = value;
            }, status);
        const untold = { message: '', time: null, quads: null, remaining: null };
        await tell({ ...untold, surface: 's1', fraction: 0.4, lasting: 'briefly' });
        await page.getByRole('button', { name: 'Stop' }).waitFor();
        expect(await height()).toBe(before);
        await tell(null);
    });
});
