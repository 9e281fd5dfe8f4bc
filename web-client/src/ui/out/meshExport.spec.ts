// @vitest-environment happy-dom
import { afterEach, expect, it, vi } from 'vitest';
import { OwnServer } from '../../connection/ownServer.ts';
import { MeshDownload } from '../../session/out/meshDownload.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { savedFiles } from '../../testing/fakes.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './meshExport.ts';

afterEach(() => {
    vi.unstubAllGlobals();
    vi.restoreAllMocks();
});

it('of a surface that is shown as points these go into a .ply, and the mesh into others', async () => {
    const asked: string[] = [];
    vi.stubGlobal('fetch', async (url: URL) => {
        asked.push(url.pathname + url.search);
        return new Response(new Uint8Array(4));
    });
    savedFiles();
    const bench = Object.assign(new PageBench(), { mesh: new MeshDownload(new OwnServer('http://localhost/')) });
    bench.view.changeLook('surface-1', { points: true });
    const panel = await ShownPanel.of('wakesurf-mesh-export', bench);
    for (const format of ['ply', 'vtp']) {
        await panel.enter('#mesh-format', 'Format', format);
        await panel.press('Download mesh');
        await rested();
    }
    const surface = '/api/v1/sessions/session/surfaces/surface-1/';
    expect(asked).toEqual([`${surface}mesh.ply?lines=points`, `${surface}mesh.vtp`]);
    expect(panel.text).toContain('points are for .ply alone');
});

it('a mesh is downloaded byte for byte as the server sends it, in every format', async () => {
    const sent = Uint8Array.from({ length: 256 }, (_, i) => i);
    const asked: string[] = [];
    vi.stubGlobal('fetch', async (url: URL) => {
        asked.push(url.href);
        return new Response(sent);
    });
    const saved = savedFiles();
    const mesh = new MeshDownload(new OwnServer('http://localhost/'));
    const panel = await ShownPanel.of('wakesurf-mesh-export', Object.assign(new PageBench(), { mesh }));
    for (const [choice, file] of [
        ['vtp', 'mesh.vtp'],
        ['glb-plain', 'mesh.glb?draco=false'],
        ['glb', 'mesh.glb'],
        ['ply', 'mesh.ply'],
        ['obj', 'mesh.obj'],
        ['drc', 'mesh.drc'],
    ] as const) {
        await panel.enter('#mesh-format', 'Format', choice);
        await panel.press('Download mesh');
        await rested();
        expect(asked.at(-1)).toBe(`http://localhost/api/v1/sessions/session/surfaces/surface-1/${file}`);
        const { name, content: got } = saved.at(-1)!;
        expect(name).toBe(`flow-stream.${choice.split('-')[0]}`);
        expect(new Uint8Array(await got.arrayBuffer())).toEqual(sent);
    }
    expect(saved).toHaveLength(6);
});
