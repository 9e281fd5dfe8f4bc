import { afterEach, describe, expect, it, vi } from 'vitest';
import { authorise } from './authorise.ts';
import { HopelessError } from './liveSocket.ts';
import { logOut } from './logOut.ts';

const base = 'http://localhost/flow/';

function answerWith(status: number, body: object = {}): URL[] {
    const asked: URL[] = [];
    vi.stubGlobal('fetch', async (url: URL) => {
        asked.push(url);
        return Response.json(body, { status });
    });
    return asked;
}

afterEach(() => vi.unstubAllGlobals());

describe('letting a page in', () => {
    it('is given up where the token is no good, with words for who came by a link as well', async () => {
        answerWith(401);
        await expect(authorise(base, 'wrong')).rejects.toThrow(
            /If someone gave you the link, it has expired or its session was deleted/,
        );
        await expect(authorise(base, null)).rejects.toBeInstanceOf(HopelessError);
    });

    it('is told apart from an address that the server does not go by', async () => {
        vi.stubGlobal('location', { origin: 'http://lab:9000' });
        answerWith(403, { error: { code: -32003, message: 'another origin', data: { hint: 'start it with --origin' } } });
        const refused = authorise(base, 'good');
        await expect(refused).rejects.toBeInstanceOf(HopelessError);
        await expect(refused).rejects.toThrow(
            /this page’s address, http:\/\/lab:9000; this has nothing to do with the token.*another origin: start it with --origin/,
        );
    });

    it('asks for a cookie of this page’s path alone', async () => {
        const bodies: unknown[] = [];
        vi.stubGlobal('fetch', async (_url: URL, { body }: { body: string }) => {
            bodies.push(JSON.parse(body));
            return new Response(null, { status: 204 });
        });
        await authorise(base, 'good');
        await logOut(base);
        expect(bodies).toEqual([{ token: 'good', path: '/flow/' }, { path: '/flow/' }]);
    });

    it('is tried again where a limit is met, with the server’s words and hint', async () => {
        const error = { code: -32014, message: 'too many people are here', data: { hint: 'come back in a minute' } };
        answerWith(503, { error });
        const refused = authorise(base, 'good');
        await expect(refused).rejects.toThrow('too many people are here: come back in a minute');
        await expect(refused).rejects.not.toBeInstanceOf(HopelessError);
    });
});

describe('logging out', () => {
    it('asks the server behind this address', async () => {
        const asked = answerWith(200);
        await logOut(base);
        expect(asked.map(({ href }) => href)).toEqual(['http://localhost/flow/api/v1/logout']);
    });

    it('says where it has not worked that one is still logged in', async () => {
        answerWith(503);
        await expect(logOut(base)).rejects.toThrow('You are still logged in. The server answered with status 503.');
        vi.stubGlobal('fetch', () => Promise.reject(new TypeError('failed')));
        await expect(logOut(base)).rejects.toThrow(/still logged in\. Try again/);
    });
});
