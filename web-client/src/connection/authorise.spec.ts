import { afterEach, describe, expect, it, vi } from 'vitest';
import { authorise } from './authorise.ts';
import { HopelessError } from './liveSocket.ts';

const base = 'http://localhost/flow/';

function answerWith(status: number, body: object = {}): URL[] {
    const asked: URL[] = [];
    vi.stubGlobal('location', { origin: 'http://lab:9000' });
    vi.stubGlobal('fetch', async (url: URL) => {
        asked.push(url);
        return Response.json(body, { status });
    });
    return asked;
}

afterEach(() => vi.unstubAllGlobals());

describe('letting a page in', () => {
    it('exchanges what it has for a login', async () => {
        const bodies: unknown[] = [];
        vi.stubGlobal('fetch', async (_url: URL, { body }: { body: string }) => {
            bodies.push(JSON.parse(body));
            return Response.json({ login: 'a.1.2.g1.b', session: 'session-3' });
        });
        const made = { login: 'a.1.2.g1.b', session: 'session-3' };
        expect(await authorise(base, { token: 'good', login: null })).toEqual(made);
        expect(await authorise(base, { token: null, login: made.login })).toEqual(made);
        expect(bodies).toEqual([{ token: 'good' }, { login: made.login }]);
    });

    it('asks an open server for nothing', async () => {
        const asked = answerWith(200);
        expect(await authorise(base, { token: null, login: null })).toBeNull();
        expect(asked.map(({ href }) => href)).toEqual(['http://localhost/flow/openrpc.json']);
    });

    it('is given up where the token is no good, with words for who came by a link as well', async () => {
        answerWith(401);
        await expect(authorise(base, { token: 'wrong', login: null })).rejects.toThrow(
            /If someone gave you the link, it has expired or its session was deleted/,
        );
        await expect(authorise(base, { token: null, login: null })).rejects.toBeInstanceOf(HopelessError);
    });

    it('says why it is not let in: never was here, or has ended', async () => {
        const nothing = { token: null, login: null };
        answerWith(401, { error: { code: -32001, message: 'a token is needed', data: { hint: 'send it' } } });
        await expect(authorise(base, nothing)).rejects.toThrow(
            /is not logged in at http:\/\/lab:9000.*tunnel with another port.*paste it/,
        );
        await expect(authorise(base, { token: null, login: 'a.b' })).rejects.toThrow(/login has ended.*started with a new token/);
    });

    it('is told apart from an address that the server does not go by', async () => {
        answerWith(403, { error: { code: -32003, message: 'another origin', data: { hint: 'start it with --origin' } } });
        const refused = authorise(base, { token: 'good', login: null });
        await expect(refused).rejects.toBeInstanceOf(HopelessError);
        await expect(refused).rejects.toThrow(
            /this page’s address, http:\/\/lab:9000; this has nothing to do with the token.*another origin: start it with --origin/,
        );
    });

    it('is tried again where a limit is met, with the server’s words and hint', async () => {
        const error = { code: -32014, message: 'too many people are here', data: { hint: 'come back in a minute' } };
        answerWith(503, { error });
        const refused = authorise(base, { token: 'good', login: null });
        await expect(refused).rejects.toThrow('too many people are here: come back in a minute');
        await expect(refused).rejects.not.toBeInstanceOf(HopelessError);
    });
});
