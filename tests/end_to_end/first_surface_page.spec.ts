// docs/start/page.md, and the README's first surface, as someone walks through them with a mouse and a keyboard.
import type { Page } from 'playwright-core';
import { beforeAll, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { dragHandle } from './support/rake_drag.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1280, height: 800 });
    await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
});

const camera = () => ask(page, (hook) => hook.camera);
const tab = (name: string): Promise<void> => page.getByRole('tab', { name }).click();
const bar = (): Promise<string> => page.locator('wakesurf-scalar-bar figcaption').innerText();

it('begins with a rake ahead of the body and across the flow, and a surface that it releases', async () => {
    const [a, b] = await ask(page, (hook) => hook.rakePoints);
    expect([a![0] < -0.5, b![0] < -0.5, Math.abs(a![0] - b![0]) < 0.1]).toEqual([true, true, true]);
    expect(await ask(page, (hook) => hook.displayed!.cells)).toBeGreaterThan(100);
});

it('turns the view by a drag beside the rake, pans by the right button, zooms by the wheel, and fits the domain by F', async () => {
    const drag = async (button: 'left' | 'right'): Promise<void> => {
        await page.mouse.move(120, 500);
        await page.mouse.down({ button });
        await page.mouse.move(180, 470, { steps: 3 });
        await page.mouse.up({ button });
    };
    const first = await camera();
    await drag('left');
    await expect.poll(async () => (await camera()).position).not.toEqual(first.position);
    const turned = await camera();
    await drag('right');
    await expect.poll(async () => (await camera()).target).not.toEqual(turned.target);
    const apart = async (): Promise<number> => {
        const { position, target } = await camera();
        return Math.hypot(...position.map((x, i) => x - target[i]!));
    };
    const far = await apart();
    await page.mouse.wheel(0, -300);
    await expect.poll(apart).toBeLessThan(far);
    await page.keyboard.press('f');
    const inside = (): Promise<boolean> =>
        ask(page, (hook) => {
            const [x0, x1, y0, y1, z0, z1] = hook.bounds!;
            const corners = [x0!, x1!].flatMap((x) => [y0!, y1!].flatMap((y) => [z0!, z1!].map((z) => hook.project([x, y, z])!)));
            return corners.every((at) => at.x > 0 && at.y > 0 && at.x < innerWidth && at.y < innerHeight);
        });
    await expect.poll(inside).toBe(true);
});

it('follows a handle that is dragged, and keeps to one axis with Shift', async () => {
    const end = () => ask(page, (hook) => hook.rakePoints[1]!);
    const before = { at: await end(), epoch: await ask(page, (hook) => hook.displayed!.epoch) };
    await dragHandle(page, 1, 20, 20, 4);
    await page.waitForFunction((epoch) => window.wakesurf!.displayed!.epoch > epoch, before.epoch);
    await finalSurface(page);
    const dragged = await end();
    expect(dragged).not.toEqual(before.at);
    const from = (await page.evaluate(() => window.wakesurf!.handleOnScreen(1)))!;
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.keyboard.down('Shift');
    await page.mouse.move(from.x, from.y + 30, { steps: 4 });
    await page.mouse.up();
    await page.keyboard.up('Shift');
    await expect.poll(end).not.toEqual(dragged);
    const moved = (await end()).filter((x, axis) => Math.abs(x - dragged[axis]!) > 1e-6);
    expect(moved).toHaveLength(1);
    await finalSurface(page);
});

it('plays a streak surface by the space bar as soon as that is chosen, and stops by it', async () => {
    await tab('Flow');
    await page.getByText('Streak', { exact: true }).click();
    await page.keyboard.press('Space');
    await page.getByRole('button', { name: 'Pause' }).waitFor();
    const time = await ask(page, (hook) => hook.displayed!.time);
    await page.waitForFunction((then) => window.wakesurf!.displayed!.time !== then, time);
    await page.keyboard.press('Space');
    await page.getByRole('button', { name: 'Play' }).waitFor();
    await finalSurface(page);
});

it('plays by the space bar also after a click on a tab and on a switch', async () => {
    const plays = async (): Promise<void> => {
        await page.keyboard.press('Space');
        await page.getByRole('button', { name: 'Pause' }).waitFor();
        await page.keyboard.press('Space');
        await page.getByRole('button', { name: 'Play' }).waitFor();
    };
    await tab('Look');
    await plays();
    await page.getByRole('button', { name: 'Loop' }).click();
    await plays();
    expect(await page.getByRole('button', { name: 'Loop' }).getAttribute('aria-pressed')).toBe('false');
    // Who goes by keyboard presses what is in focus.
    await page.getByRole('button', { name: 'Loop' }).focus();
    await page.keyboard.press('Tab');
    await page.keyboard.press('Shift+Tab');
    await page.keyboard.press('Space');
    expect(await page.getByRole('button', { name: 'Loop' }).getAttribute('aria-pressed')).toBe('true');
    await page.getByRole('button', { name: 'Play' }).waitFor();
    await finalSurface(page);
});

it('is coloured by vortices, lets folds be seen through, and undo takes back the colours with their values', async () => {
    await page.getByRole('button', { name: 'To the end' }).click();
    await tab('Look');
    await page.getByLabel('Colour by').selectOption({ label: 'Vortices (Q)' });
    await expect.poll(bar).toContain('Q, above 0: vortex');
    await finalSurface(page);
    const scalars = () => ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar));
    const values = await scalars();
    expect(Math.min(...values)).toBeLessThan(0);
    expect(Math.max(...values)).toBeGreaterThan(0);
    await page.getByText('Opacity and outlines').click();
    await page.locator('#opacity').focus();
    for (let i = 0; i < 6; ++i) await page.keyboard.press('ArrowLeft');
    await expect.poll(() => ask(page, (hook) => hook.transparency)).not.toBe('none');
    await page.keyboard.press('End');
    await page.mouse.click(120, 500);
    await page.keyboard.press('Control+z');
    await expect.poll(bar).toContain('Speed');
    await finalSurface(page);
    expect(await page.getByLabel('Colour by').inputValue()).toBe('speed');
    await tab('Flow');
    const epoch = await ask(page, (hook) => hook.displayed!.epoch);
    await page.getByText('Path', { exact: true }).click();
    await page.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, epoch);
    await finalSurface(page);
    expect(Math.min(...(await scalars()))).toBeGreaterThanOrEqual(0);
    expect(await bar()).toContain('Speed');
});

it('saves a picture and a mesh, offers a film, and copies a script', async () => {
    await tab('Export');
    for (const [button, name] of [
        ['Save PNG', /\.png$/],
        ['Download mesh', /\.(vtp|glb|ply|obj|drc)$/],
    ] as const) {
        const download = page.waitForEvent('download');
        await page.getByRole('button', { name: button }).click();
        expect((await download).suggestedFilename()).toMatch(name);
    }
    expect(await page.getByRole('button', { name: 'Record', exact: true }).isEnabled()).toBe(true);
    await tab('Flow');
    await page
        .getByRole('complementary')
        .getByRole('button', { name: /Python/ })
        .first()
        .click();
    const script = page.evaluate(() => navigator.clipboard.readText());
    expect(await script).toContain('session.surface(');
});

it('opens the same view again by its address, and has links for other people', async () => {
    await page.waitForFunction(() => location.hash.includes('state='));
    const { position } = await camera();
    const again = await rig.open(page, page.url());
    await expect
        .poll(async () => Math.hypot(...(await ask(again, (hook) => hook.camera.position)).map((x, i) => x - position[i]!)))
        .toBeLessThan(0.1);
    expect(await ask(again, (hook) => hook.displayed!.stateSum)).toBe(await ask(page, (hook) => hook.displayed!.stateSum));
    await again.close();
    await tab('Share');
    await page.getByRole('button', { name: /link/i }).first().waitFor();
});
