// Several people in one session: links that let look on, and the ends of a connection
// after which a page must not come back by itself.
import type { BrowserContext, Page } from 'playwright-core';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import WebSocket from 'ws';
import { subprotocol, type Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { dragHandle, takeHandle } from './support/rake_drag.ts';
import { expectSamePoints } from './support/same_points.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const contexts: BrowserContext[] = [];
let page: Page;
let session: string;

beforeEach(async () => {
    page = await visit(await rig.server.streamSession());
    session = (await ask(page, (hook) => hook.session))!;
});

afterEach(async () => {
    for (const context of contexts.splice(0)) await context.close();
});

/** A browser of its own: cookies are not shared. */
async function visit(link: string): Promise<Page> {
    const context = await newContext(rig.browser, { width: 780, height: 420 });
    contexts.push(context);
    await context.addInitScript(keepWorker);
    const visited = await openPage(context, link);
    await finalSurface(visited);
    return visited;
}

declare global {
    interface Window {
        resumeToken?: string;
        sessionWorker?: Worker;
    }
}

/** The page's worker, and what it answers the page of session.join, for a second client in the same place. */
function keepWorker(): void {
    const RealWorker = window.Worker;
    window.Worker = class extends RealWorker {
        constructor(url: string | URL, options?: WorkerOptions) {
            super(url, options);
            window.sessionWorker = this;
            this.addEventListener('message', ({ data }: MessageEvent<{ result?: { resumeToken?: unknown } }>) => {
                const token = data.result?.resumeToken;
                if (typeof token === 'string') window.resumeToken = token;
            });
        }
    };
}

async function viewersLink(): Promise<string> {
    const { link } = await rig.server.call('session.share', { session, role: 'viewer' });
    return new URL(String(link), rig.server.link).href;
}

async function recordedRake(): Promise<{ rake: string; kind: string; points: Vec3[]; seeds: number }> {
    const { rakes } = await rig.server.call('rake.list', { session });
    return (rakes as Awaited<ReturnType<typeof recordedRake>>[])[0]!;
}

async function participants(): Promise<string[]> {
    const state = await rig.server.call('session.state', { session });
    return (state['participants'] as { participant: string }[]).map(({ participant }) => participant);
}

/** Until the worker has done what it was told before, and the page has heard of it: both go through their messages in order. */
async function workerIsThrough(of: Page): Promise<void> {
    await of.evaluate(
        () =>
            new Promise<void>((resolve) => {
                const worker = window.sessionWorker!;
                worker.addEventListener('message', ({ data }: MessageEvent<{ type?: string }>) => {
                    if (data.type === 'here') resolve();
                });
                worker.postMessage({ type: 'areYouThere' });
            }),
    );
}

/** The page says why it has ended, keeps its picture, and does not even come back when the browser says that it is online again. */
async function expectEnded(ended: Page, why: RegExp): Promise<void> {
    await ended.getByText('Connection ended.').waitFor();
    await ended.getByText(why).waitFor();
    expect(await ask(ended, (hook) => hook.connection)).toBe('ended');
    expect((await ask(ended, (hook) => hook.displayed?.cells)) ?? 0).toBeGreaterThan(100);
    const others = await participants();
    await ended.evaluate(() => dispatchEvent(new Event('online')));
    await workerIsThrough(ended);
    expect(await ask(ended, (hook) => hook.connection)).toBe('ended');
    expect(await participants()).toEqual(others);
}

describe('a link for looking on', () => {
    it('sees what an editor drags, and has handles and numbers that do not move, and words that say why', async () => {
        const viewer = await visit(await viewersLink());
        await viewer.getByText(/Your link is for looking/).waitFor();
        expect(viewer.url()).not.toContain('token');
        const before = await recordedRake();

        const handle = await takeHandle(viewer, 1);
        await viewer.mouse.move(handle.x + 30, handle.y + 20, { steps: 6 });
        await viewer.mouse.up();
        for (const name of ['Start x', 'Seeds']) {
            expect(await viewer.getByRole('textbox', { name }).isDisabled()).toBe(true);
        }
        expect(await viewer.getByRole('slider', { name: 'Integration time' }).isDisabled()).toBe(true);
        expectSamePoints(await ask(viewer, (hook) => hook.rakePoints), before.points, 6);
        expect(await recordedRake()).toEqual(before);

        const epoch = await ask(viewer, (hook) => hook.displayed!.epoch);
        await dragHandle(page, 1, 30, 20, 6);
        await viewer.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, epoch);
        await expectServersMesh(rig.server, page);
        await expectServersMesh(rig.server, viewer);
        expectSamePoints(await ask(viewer, (hook) => hook.rakePoints), (await recordedRake()).points, 6);
    });
});

describe('a page whose place is gone', () => {
    it('leaves it to the newer connection with the same resume token', async () => {
        const resumeToken = await page.evaluate(() => window.resumeToken);
        const address = new URL('/ws', rig.server.link);
        address.protocol = 'ws:';
        const headers = { Authorization: `Bearer ${rig.server.token}` };
        const newer = new WebSocket(address, subprotocol, { headers });
        let closed = false;
        newer.on('close', () => (closed = true));
        await new Promise((resolve, reject) => newer.once('open', resolve).once('error', reject));
        const params = { session, resumeToken };
        newer.send(JSON.stringify({ jsonrpc: '2.0', id: 1, method: 'session.join', params }));
        await expectEnded(page, /opened in a newer window/);
        expect(closed).toBe(false);

        // By the button it is someone new; the other stays.
        await page.getByRole('button', { name: 'Reload' }).click();
        await page.waitForFunction(() => window.wakesurf?.connection === 'open');
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.session)).toBe(session);
        expect(await participants()).toHaveLength(2);
        expect(closed).toBe(false);
        newer.terminate();
    });
});
