// Other programs of the same host: what a browser that is logged in here sends to them, and what they can do with it.
import { createServer, type IncomingMessage, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import WebSocket from 'ws';
import { subprotocol } from '../../web-client/src/protocol/messages.ts';
import { entered, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { expectComplaint } from './support/complaints.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const size = { width: 780, height: 420 };
let neighbour: Server;
/** What the browser has asked the other program for. */
const asked: IncomingMessage[] = [];

beforeAll(async () => {
    neighbour = createServer((request, response) => {
        asked.push(request);
        response.setHeader('Content-Type', 'text/html');
        response.end('<!doctype html><link rel="icon" href="data:,"><title>another program</title>');
    });
    await new Promise<void>((resolve) => neighbour.listen(0, '127.0.0.1', resolve));
});

afterAll(() => {
    neighbour.closeAllConnections();
    neighbour.close();
});

/** On another port of the host by which the page is known. */
function neighbourAt(page: Page): string {
    return `http://${new URL(page.url()).hostname}:${(neighbour.address() as AddressInfo).port}/`;
}

/** From outside of the browser, with any Origin. */
async function statuses(origin: string, headers: Record<string, string>): Promise<number[]> {
    const call = JSON.stringify({ jsonrpc: '2.0', id: 1, method: 'session.create', params: {} });
    const sent = { ...headers, Origin: origin, 'Content-Type': 'application/json' };
    const gets = ['openrpc.json', 'metrics', 'api/v1/sessions/main/session.json', 'api/v1/sessions/main/thumbnail'];
    const answers = [
        await fetch(`${origin}/rpc`, { method: 'POST', headers: sent, body: call }),
        await fetch(`${origin}/api/v1/sessions`, { method: 'POST', headers: sent, body: '{}' }),
    ];
    for (const path of gets) answers.push(await fetch(`${origin}/${path}`, { headers: sent }));
    return answers.map(({ status }) => status);
}

async function opens(origin: string, headers: Record<string, string>): Promise<boolean> {
    const socket = new WebSocket(`${origin.replace('http', 'ws')}/ws`, subprotocol, { headers, origin });
    const open = await new Promise<boolean>((resolve) => {
        socket.once('open', () => resolve(true)).once('error', () => resolve(false));
    });
    socket.terminate();
    return open;
}

describe('another program on another port of the same host', () => {
    it('is sent nothing by a browser that is logged in here, with which it could come in, and its page can neither ask nor join', async () => {
        const page = await openPage(await newContext(rig.browser, size), await rig.server.streamSession());
        await entered(page);
        const { origin } = new URL(page.url());
        const count = ((await rig.server.call('session.list', {}))['sessions'] as unknown[]).length;
        const other = await page.context().newPage();
        asked.length = 0;
        await other.goto(neighbourAt(page));
        expect(asked.length).toBeGreaterThan(0);
        const received = Object.fromEntries(
            Object.entries(asked[0]!.headers).filter(([name]) => !['host', 'connection', 'accept-encoding'].includes(name)),
        ) as Record<string, string>;
        expect(received).not.toHaveProperty('authorization');
        expect(received).not.toHaveProperty('cookie');
        expect(await statuses(origin, received)).toEqual([401, 401, 401, 401, 401, 401]);
        expect(await opens(origin, received)).toBe(false);
        expect((await rig.server.call('session.list', {}))['sessions']).toHaveLength(count);
        // The page's own login does open all that: else this shows nothing.
        const stored = await page.evaluate(() => sessionStorage.getItem('wakesurf.logins /'));
        const [{ login }] = JSON.parse(stored!) as [{ login: string }];
        expect(await opens(origin, { Authorization: `Bearer ${login}` })).toBe(true);
        // Its page reads nothing of what ours keeps.
        expect(
            await other.evaluate(() => JSON.stringify([{ ...localStorage }, { ...sessionStorage }, document.cookie])),
        ).not.toMatch(/login|session/);
        // Nor can it ask or join.
        expectComplaint(/.*/);
        const tried = await other.evaluate(async (to) => {
            const get = await fetch(`${to}/openrpc.json`, { credentials: 'include' }).then(
                () => 'read',
                () => 'refused',
            );
            const socket = await new Promise<string>((resolve) => {
                const made = new window.WebSocket(`${to.replace('http', 'ws')}/ws`, 'wakesurf.v1');
                made.onopen = () => resolve('open');
                made.onerror = () => resolve('refused');
            });
            return [get, socket];
        }, origin);
        expect(tried).toEqual(['refused', 'refused']);
        await page.context().close();
    });
});

describe('a browser that is told to keep nothing', () => {
    it('is let in by its link all the same', async () => {
        const context = await newContext(rig.browser, size);
        await context.addInitScript(() => {
            for (const name of ['localStorage', 'sessionStorage']) {
                Object.defineProperty(window, name, {
                    get: () => {
                        throw new DOMException('denied', 'SecurityError');
                    },
                });
            }
        });
        const page = await openPage(context, rig.server.link);
        await finalSurface(page);
        await context.close();
    });
});
