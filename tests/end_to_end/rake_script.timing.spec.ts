// What a rake costs the page's script while it is dragged.
import { expect, it } from 'vitest';
import type { RakeRecord, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { dragHandle } from './support/rake_drag.ts';
import { takeScriptTimes, timeScripts } from './support/script_time.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();

it('a rake that is dragged costs little script, also one of very many points', async () => {
    const context = await newContext(rig.browser, { width: 900, height: 560 });
    await timeScripts(context);
    const page = await openPage(context, await rig.server.streamSession());
    await finalSurface(page);
    const session = await ask(page, (hook) => hook.session);
    const rakes = async (): Promise<RakeRecord[]> => (await rig.server.call('rake.list', { session }))['rakes'] as RakeRecord[];
    const dragged = async (): Promise<number[]> => {
        await takeScriptTimes(page);
        await dragHandle(page, 'middle', 30, 10, 12);
        return (await takeScriptTimes(page)).moves;
    };
    const few = await dragged();
    await expect.poll(async () => !(await rakes())[0]!.dragging).toBe(true);
    const points = Array.from({ length: 900 }, (_, i) => [-2, Math.sin(i / 20), 1 + (4 * i) / 900] as Vec3);
    const { rake } = (await rakes())[0]!;
    await rig.server.call('rake.set', { session, rake, kind: 'points', points, seeds: 100 });
    await page.waitForFunction(() => window.wakesurf!.rakePoints.length === 900);
    await finalSurface(page);
    for (const moves of [few, await dragged()]) {
        expect(moves.length).toBeGreaterThan(8);
        expect(moves[Math.floor(moves.length / 2)]).toBeLessThan(4);
    }
    await context.close();
});
