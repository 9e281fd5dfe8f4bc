// Against a server of its own: what is asked for is the address that matters.
import { createServer, type RequestListener, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { afterEach, describe, expect, it } from 'vitest';
import { OwnServer } from '../../connection/ownServer.ts';
import { MeshDownload } from './meshDownload.ts';

let server: Server | null = null;

async function serving(answer: RequestListener): Promise<string> {
    server = createServer(answer);
    await new Promise<void>((resolve) => server!.listen(0, '127.0.0.1', resolve));
    return `http://127.0.0.1:${(server.address() as AddressInfo).port}/behind/a/proxy/`;
}

afterEach(() => {
    server?.closeAllConnections();
    server?.close();
});

describe('MeshDownload', () => {
    it('asks below the address of the page, and says that it waits', async () => {
        const asked: (string | undefined)[] = [];
        const base = await serving((request, response) => {
            asked.push(request.url);
            response.end('mesh');
        });
        const download = new MeshDownload(new OwnServer(base));
        const mesh = download.fetch('a session', 's1', { format: 'vtp' });
        expect(download.progress.value).toMatchObject({ state: 'waiting' });
        expect(await (await mesh)?.file.text()).toBe('mesh');
        expect(asked).toEqual(['/behind/a/proxy/api/v1/sessions/a%20session/surfaces/s1/mesh.vtp']);
        expect(download.progress.value).toEqual({ state: 'idle', words: '' });
    });

    it('asks for a .glb that programs without Draco open', async () => {
        let asked: string | undefined;
        const base = await serving((request, response) => {
            asked = request.url;
            response.end('mesh');
        });
        await new MeshDownload(new OwnServer(base)).fetch('main', 's1', { format: 'glb', draco: false });
        expect(asked).toMatch(/\/surfaces\/s1\/mesh\.glb\?draco=false$/);
    });

    it('asks for what is shown now, and learns from the name of the file that it is coarse', async () => {
        const asked: (string | undefined)[] = [];
        const base = await serving((request, response) => {
            asked.push(request.url);
            const name = asked.length === 1 ? 's1-coarse.glb' : 's1.glb';
            response.setHeader('Content-Disposition', `attachment; filename="${name}"`);
            response.end('mesh');
        });
        const download = new MeshDownload(new OwnServer(base));
        const file = { format: 'glb', draco: false, now: true } as const;
        expect((await download.fetch('main', 's1', file))?.coarse).toBe(true);
        expect((await download.fetch('main', 's1', file))?.coarse).toBe(false);
        expect(asked[0]).toMatch(/\/mesh\.glb\?draco=false&now=true$/);
    });

    it('says in the words of the server why there is no mesh', async () => {
        const error = { message: 'the surface is empty', data: { hint: 'move the rake into the flow' } };
        const base = await serving((_request, response) => {
            response.statusCode = 409;
            response.end(JSON.stringify({ error }));
        });
        const download = new MeshDownload(new OwnServer(base));
        expect(await download.fetch('s', 's1', { format: 'glb' })).toBeNull();
        expect(download.progress.value).toEqual({
            state: 'failed',
            words: 'the surface is empty: move the rake into the flow',
        });
    });

    it('is cancelled while it waits', async () => {
        const base = await serving(() => undefined);
        const download = new MeshDownload(new OwnServer(base));
        const mesh = download.fetch('s', 's1', { format: 'obj' });
        download.cancel();
        expect(await mesh).toBeNull();
        expect(download.progress.value).toEqual({ state: 'idle', words: '' });
    });

    it('says that no one answers', async () => {
        const base = await serving((request) => request.destroy());
        const download = new MeshDownload(new OwnServer(base));
        expect(await download.fetch('s', 's1', { format: 'obj' })).toBeNull();
        expect(download.progress.value).toEqual({ state: 'failed', words: 'The server cannot be reached.' });
    });
});
