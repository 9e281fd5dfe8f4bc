import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { emptyStorage } from '../testing/fakes.ts';
import { LoginStore, OwnServer } from './ownServer.ts';

const base = 'http://localhost/flow/';
const host = { login: 'aa.1.1..mac', session: null };
const viewer = { login: 'bb.1.1.g1.mac', session: 'session-3' };

beforeEach(() => emptyStorage('localStorage', 'sessionStorage'));

afterEach(() => vi.unstubAllGlobals());

/** Acts as another window of the browser: with what is shared, without what is a window's own. */
function anotherWindow(): void {
    emptyStorage('sessionStorage');
}

describe('the login of a page', () => {
    it('is that of its window, and in another window the one that lets in most', () => {
        new OwnServer(base).loggedIn(host);
        new OwnServer(base).loggedIn(viewer);
        expect(new OwnServer(base, 'session-3').login).toBe(viewer.login);
        anotherWindow();
        // A link that a user made us open does not make us a viewer.
        expect(new OwnServer(base, 'session-3').login).toBe(host.login);
        expect(new OwnServer(base).login).toBe(host.login);
    });

    it('is for the session that is shown where there are several links', () => {
        const other = { login: 'cc.1.1.g2.mac', session: 'session-4' };
        new OwnServer(base).loggedIn(viewer);
        new OwnServer(base).loggedIn(other);
        anotherWindow();
        expect(new OwnServer(base, 'session-3').login).toBe(viewer.login);
        expect(new OwnServer(base, 'session-4').login).toBe(other.login);
        expect(new OwnServer(base, 'session-5').login).toBeNull();
        expect(new OwnServer(base).login).toBe(other.login);
    });

    it('is another one below another path', () => {
        new OwnServer(base).loggedIn(host);
        anotherWindow();
        expect(new OwnServer('http://localhost/other/').login).toBeNull();
    });

    it('is a window’s own where the browser keeps nothing', () => {
        vi.stubGlobal('localStorage', undefined);
        vi.stubGlobal('sessionStorage', undefined);
        const server = new OwnServer(base);
        server.loggedIn(host);
        expect(server.login).toBe(host.login);
    });

    it('is none where what is kept is not one', () => {
        localStorage.setItem('wakesurf.logins /flow/', '[{"login":7},"x",null,{"login":"a","session":4}]');
        expect(new OwnServer(base).login).toBeNull();
        localStorage.setItem('wakesurf.logins /flow/', '{');
        expect(new OwnServer(base).login).toBeNull();
    });

    it('is shown with what is asked for, at this address', async () => {
        const asked: [string, unknown][] = [];
        vi.stubGlobal('fetch', async ({ href }: URL, init: unknown) => {
            asked.push([href, init]);
            return Response.json({});
        });
        const server = new OwnServer(base);
        server.loggedIn(host);
        await server.fetch('api/v1/sessions', { method: 'POST', headers: { 'Content-Type': 'application/json' } });
        const headers = { 'Content-Type': 'application/json', Authorization: `Bearer ${host.login}` };
        expect(asked).toEqual([['http://localhost/flow/api/v1/sessions', { method: 'POST', headers }]]);
    });
});

describe('logging out', () => {
    it('forgets the login, in all its texts, and no other', async () => {
        vi.stubGlobal('fetch', async () => Response.json({ durable: true }));
        const server = new OwnServer(base);
        server.loggedIn(viewer);
        server.loggedIn({ ...host, login: 'aa.1.1..older' });
        server.loggedIn(host);
        expect(await server.logOut()).toBe('');
        expect(server.login).toBeNull();
        anotherWindow();
        expect(new OwnServer(base).login).toBe(viewer.login);
    });

    it('says where the server could not keep it', async () => {
        vi.stubGlobal('fetch', async () => Response.json({ durable: false, hint: 'disk full' }));
        const server = new OwnServer(base);
        server.loggedIn(host);
        expect(await server.logOut()).toMatch(/could not write that down/);
        expect(server.login).toBeNull();
    });

    it('says where it has not worked that one is still logged in', async () => {
        const server = new OwnServer(base);
        server.loggedIn(host);
        vi.stubGlobal('fetch', async () => Response.json({}, { status: 503 }));
        await expect(server.logOut()).rejects.toThrow('You are still logged in. The server answered with status 503.');
        vi.stubGlobal('fetch', () => Promise.reject(new TypeError('failed')));
        await expect(server.logOut()).rejects.toThrow(/still logged in\. Try again/);
        expect(server.login).toBe(host.login);
    });
});

describe('the logins of a browser', () => {
    beforeEach(() => emptyStorage('localStorage', 'sessionStorage'));
    afterEach(() => void vi.unstubAllGlobals());

    it('lead from a session into a copy of it and back, in one window', () => {
        const kept = new LoginStore('http://localhost/');
        const [link, copy] = [
            { login: 'a.1', session: 'main' },
            { login: 'b.1', session: 'session-2' },
        ];
        kept.add(link);
        kept.add(copy);
        expect(kept.recall('session-2')).toEqual(copy);
        expect(kept.recall('main')).toEqual(link);
        expect(kept.recall(null)).toEqual(copy);
        kept.remove('a.1');
        expect(kept.recall('main'), 'the server says what it is not good for').toEqual(copy);
    });

    it('let a window that came by a link be what the link allows, beside one that has the token', () => {
        const kept = new LoginStore('http://localhost/');
        kept.add({ login: 'token.1', session: null });
        emptyStorage('sessionStorage');
        const link = { login: 'a.1', session: 'main' };
        kept.add(link);
        expect(kept.recall('main')).toEqual(link);
        emptyStorage('sessionStorage');
        expect(kept.recall('main')?.session, 'another window').toBeNull();
    });
});
