// What the server says of the surface that a page shows, and whether that is what it shows.
import type { Page } from 'playwright-core';
import { expect } from 'vitest';
import type { SurfaceStats } from '../../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './browser_page.ts';
import type { ServerProcess } from './server_process.ts';

/** Waits until the server has finished the surface that is on the page's screen. */
export async function serverStats(server: ServerProcess, page: Page): Promise<SurfaceStats> {
    const session = await ask(page, (hook) => hook.session);
    const { surface, epoch } = await ask(page, (hook) => hook.displayed!);
    const asked = { session, surface, epoch, timeoutMs: 20_000 };
    return (await server.call('surface.wait', asked)) as unknown as SurfaceStats;
}

/** The mesh on the screen is the server's, whole: counts, and a checksum over every vertex and quad. One that is final may still be
 *  followed by the same with its error between stored times. */
export async function expectServersMesh(server: ServerProcess, page: Page): Promise<void> {
    await finalSurface(page);
    const stats = await serverStats(server, page);
    expect(stats.complete).toBe(true);
    expect(stats.quads).toBeGreaterThan(100);
    await expect
        .poll(() => ask(page, (hook) => hook.displayed), { timeout: 5_000 })
        .toMatchObject({
            epoch: stats.epoch,
            vertices: stats.vertices,
            cells: stats.quads,
            stateSum: stats.stateSum,
            phase: 'final',
        });
}
