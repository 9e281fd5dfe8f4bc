// What a first visitor meets beside the tour: several datasets and their bodies, a phone.
import { describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig(['flow:sphere']);
const size = { width: 800, height: 500 };

describe('a server with several datasets', () => {
    it('offers them, and shows the body of a flow by formula where it is', async () => {
        const page = await rig.visit(size);
        const first = await ask(page, (hook) => hook.session);
        const open = page.getByRole('button', { name: 'Open', exact: true });
        await open.waitFor();
        expect(await open.isDisabled()).toBe(true);
        // By keyboard: to choose is not to open yet.
        const select = page.getByLabel('Dataset');
        await select.focus();
        await page.keyboard.press('ArrowDown');
        await expect.poll(() => open.isEnabled()).toBe(true);
        expect(await select.inputValue()).toBe('sphere');
        expect(await ask(page, (hook) => hook.session)).toBe(first);
        await page.keyboard.press('Tab');
        await page.keyboard.press('Enter');
        await page.waitForFunction(() => window.wakesurf?.bounds?.[1] === 10);
        await page.getByText('an analytic flow, 1 time-step').waitFor();
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.session)).not.toBe(first);

        // Seen along x: the sphere of radius 0.5 is round and grey. Its left half is behind the rake and the sheet.
        await page.evaluate(() => window.wakesurf!.setCamera([-8, 0, 0], [0, 0, 0]));
        const middle = (await page.evaluate(() => window.wakesurf!.project([0, 0, 0])))!;
        // The outline that an eye at distance 8 sees: the tangent from there.
        const edge = (await page.evaluate(() => window.wakesurf!.project([0, (8 * 0.5) / Math.sqrt(8 ** 2 - 0.5 ** 2), 0])))!;
        const radius = Math.abs(edge.x - middle.x);
        expect(radius).toBeGreaterThan(12);
        const ring = (factor: number): Promise<boolean[]> => {
            const angles = Array.from({ length: 12 }, (_, k) => ((k - 5.5) * Math.PI) / 12);
            const places = angles.map((angle) => ({
                x: middle.x + factor * radius * Math.cos(angle),
                y: middle.y + factor * radius * Math.sin(angle),
            }));
            return page.evaluate(
                (all) =>
                    window
                        .wakesurf!.pixelsAt(all)
                        .map((rgb) => Math.min(...rgb) > 40 && Math.max(...rgb) - Math.min(...rgb) < 40),
                places,
            );
        };
        await expect.poll(async () => (await ring(0.9)).every((grey) => grey)).toBe(true);
        expect((await ring(1.1)).some((grey) => grey)).toBe(false);
        // From near by no facets are seen: from pixel to pixel light changes little, and over the ball by much.
        await page.evaluate(() => window.wakesurf!.setCamera([-1.8, 0, 0], [0, 0, 0]));
        const light = await page.evaluate(() => {
            const [top, foot] = [0.35, -0.35].map((z) => window.wakesurf!.project([0, -0.2, z])!);
            const places = Array.from({ length: Math.floor(foot!.y - top!.y) }, (_, i) => ({ x: top!.x, y: top!.y + i }));
            return window.wakesurf!.pixelsAt(places).map(([, green]) => green);
        });
        expect(light.length).toBeGreaterThan(60);
        expect(Math.max(...light) - Math.min(...light)).toBeGreaterThan(20);
        expect(Math.max(...light.slice(1).map((green, i) => Math.abs(green - light[i]!)))).toBeLessThan(4);
        await page.goBack();
        await page.waitForFunction((session) => window.wakesurf?.session === session, first);
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.bounds![1])).not.toBe(10);
        await page.context().close();
    });

    it('adds one to the picture, where its body is beside that of the other, whichever is worked on', async () => {
        const page = await rig.visit(size);
        await finalSurface(page);
        const own = await ask(page, (hook) => hook.bounds);
        await page.getByLabel('Dataset').selectOption('sphere');
        await page.getByRole('button', { name: 'Add to this picture' }).click();
        await page.waitForFunction(() => window.wakesurf?.bounds?.[1] === 10);
        await page.locator('[data-thing]', { hasText: 'Rake 1' }).click();
        await expect.poll(() => ask(page, (hook) => hook.bounds)).toEqual(own);
        // From below, where the sphere reaches out of the other domain, without the sheet on it.
        await page.getByRole('button', { name: 'Show only Bodies' }).click();
        await page.evaluate(() => window.wakesurf!.setCamera([-3, 0.5, -8], [0, 0, 0]));
        const lowest = (): Promise<number[]> =>
            page.evaluate(() => window.wakesurf!.pixelsAt([window.wakesurf!.project([0, 0.3, -0.39])!])[0]!);
        await expect.poll(async () => Math.max(...(await lowest()))).toBeGreaterThan(40);
        const [red, , blue] = await lowest();
        expect(Math.abs(red! - blue!)).toBeLessThan(40);
    });
});

describe('on a phone', () => {
    it('the settings have room under their tabs, and no button lies over another', async () => {
        const page = await rig.visit({ width: 390, height: 844 });
        const buttons = page.locator('main button');
        const boxes = await Promise.all((await buttons.all()).map((button) => button.boundingBox()));
        const shown = boxes.filter((box) => box !== null);
        expect(shown.length).toBeGreaterThan(4);
        shown.forEach((a, i) =>
            shown.slice(i + 1).forEach((b) => {
                const apart = a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
                expect(apart, `${JSON.stringify(a)} ${JSON.stringify(b)}`).toBe(true);
            }),
        );
        // What the colours mean stands below the picture, not on its axes.
        const bar = (await page.locator('wakesurf-scalar-bar').boundingBox())!;
        const picture = (await page.locator('canvas').first().boundingBox())!;
        expect(bar.y).toBeGreaterThanOrEqual(picture.y + picture.height);
        expect(bar.x).toBeGreaterThanOrEqual(0);
        expect(bar.x + bar.width).toBeLessThanOrEqual(390);
        const panel = page.getByRole('complementary', { name: 'Settings' });
        const room = (await panel.boundingBox())!;
        expect(room.height).toBeGreaterThan(844 * 0.35);
        expect(room.y + room.height).toBeLessThanOrEqual(844);
        // The last control of the longest tab can be reached, under tabs that stay.
        const last = page.getByLabel('Snap to a grid');
        await last.scrollIntoViewIfNeeded();
        const tabs = (await page.getByRole('tablist').boundingBox())!;
        const box = (await last.boundingBox())!;
        expect(Math.abs(tabs.y - room.y)).toBeLessThan(2);
        expect(box.y).toBeGreaterThan(tabs.y + tabs.height);
        expect(box.y + box.height).toBeLessThan(844);
        await last.check();
        await page.context().close();
    });
});
