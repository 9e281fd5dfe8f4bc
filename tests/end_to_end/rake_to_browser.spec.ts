// The whole path: real data, real server, real browser, real mouse. What is on the screen must be
// what the server computed for the rake as it was left.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { framesPass } from './support/frames.ts';
import { handleIsAt, takeHandle } from './support/rake_drag.ts';
import { expectSamePoints } from './support/same_points.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit();
});

describe('the page', () => {
    it('shows the final surface of the default rake and hides the token', async () => {
        await expectServersMesh(rig.server, page);
        expect(page.url()).not.toContain('token');
        expect(page.url()).toContain('session=');
    });

    it('follows a dragged handle, and then shows exactly the surface of the new rake', async () => {
        const before = await ask(page, (hook) => hook.displayed);
        const camera = await ask(page, (hook) => hook.camera);
        const from = await takeHandle(page, 1);
        for (let i = 1; i <= 4; ++i) {
            // The surface comes along while the hand still holds.
            const shown = await ask(page, (hook) => hook.displayed!.epoch);
            const to = { x: from.x + 11 * i, y: from.y + 8 * i };
            await page.mouse.move(to.x, to.y, { steps: 3 });
            await handleIsAt(page, 1, to);
            await page.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, shown);
        }
        await page.mouse.up();
        expect(await ask(page, (hook) => hook.camera)).toEqual(camera);
        await expectServersMesh(rig.server, page);
        const after = await ask(page, (hook) => hook.displayed);
        expect(after?.stateSum).not.toBe(before?.stateSum);
        const session = await ask(page, (hook) => hook.session);
        const { rakes } = (await rig.server.call('rake.list', { session })) as { rakes: { points: Vec3[] }[] };
        expectSamePoints(rakes[0]?.points, await ask(page, (hook) => hook.rakePoints));
        expect(await ask(page, (hook) => hook.latencySamples.length)).toBeGreaterThan(0);
    });

    it('turns the camera, not the rake, when the press is beside the handles, and then draws nothing more', async () => {
        const [camera, rake] = [await ask(page, (h) => h.camera), await ask(page, (h) => h.rakePoints)];
        await page.mouse.move(500, 80);
        await page.mouse.down();
        await page.mouse.move(560, 110, { steps: 4 });
        await page.mouse.up();
        expect(await ask(page, (hook) => hook.rakePoints)).toEqual(rake);
        expect(await ask(page, (hook) => hook.camera)).not.toEqual(camera);

        // Nothing is drawn while nothing changes.
        await finalSurface(page);
        await framesPass(page, 10);
        const before = await ask(page, (hook) => hook.framesDrawn);
        await framesPass(page, 60);
        expect(await ask(page, (hook) => hook.framesDrawn)).toBeLessThanOrEqual(before + 1);
    });
});

describe('the keyboard', () => {
    it('moves the time with the slider, and the surface with it', async () => {
        const before = await ask(page, (hook) => hook.displayed);
        await page.getByRole('slider', { name: 'Time of the frozen field' }).focus();
        for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowLeft');
        await page.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, before!.epoch);
        await expectServersMesh(rig.server, page);
        const after = await ask(page, (hook) => hook.displayed);
        expect(after?.stateSum).not.toBe(before?.stateSum);
        const session = await ask(page, (hook) => hook.session);
        const list = await rig.server.call('surface.list', { session });
        expect((list['surfaces'] as { from: number }[])[0]?.from).toBeCloseTo(13.5);
    });
});
