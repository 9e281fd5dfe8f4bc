// @vitest-environment happy-dom
import { afterEach, expect, it, vi } from 'vitest';
import { OwnServer } from '../../connection/ownServer.ts';
import { plainStyle } from '../../scene/surface/surfaceStyle.ts';
import { MeshDownload } from '../../session/out/meshDownload.ts';
import { savedFiles } from '../../testing/fakes.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './animationExport.ts';

afterEach(() => {
    vi.unstubAllGlobals();
    vi.restoreAllMocks();
});

async function shown(): Promise<{ panel: ShownPanel; bench: PageBench }> {
    const bench = new PageBench();
    const model = {
        state: bench.state,
        animation: new MeshDownload(new OwnServer('http://localhost/')),
        styleOf: () => ({ ...plainStyle, map: 'grey' as const }),
    };
    return { panel: await ShownPanel.of('wakesurf-animation-export', model), bench };
}

it('asks for the times and steps that are chosen, and for the colours that are shown, and saves the page', async () => {
    const asked: URL[] = [];
    vi.stubGlobal('fetch', async (url: URL) => {
        asked.push(url);
        return new Response('<!doctype html>');
    });
    const saved = savedFiles();
    const { panel, bench } = await shown();
    const { from } = bench.state.surface.value!;
    await panel.enter('#animation-to', 'To', String(from + 2));
    await panel.enter('#animation-steps', 'Steps', '5');
    await panel.press('Download animation');
    await rested();
    expect(asked[0]!.pathname).toBe('/api/v1/sessions/session/surfaces/surface-1/animation.html');
    expect(asked[0]!.searchParams.get('times')).toBe(`${from}:${from + 2}:0.5`);
    expect(JSON.parse(asked[0]!.searchParams.get('look')!)).toEqual({ source: 'scalar', scalar: 'speed', map: 'grey' });
    expect(saved.map(({ name }) => name)).toEqual(['flow-stream-animation.html']);
});

it('says what the server refuses', async () => {
    vi.stubGlobal(
        'fetch',
        async () =>
            new Response(JSON.stringify({ error: { code: -32602, message: 'the times run the other way' } }), { status: 400 }),
    );
    const { panel } = await shown();
    await panel.press('Download animation');
    await rested();
    expect(panel.text).toContain('the times run the other way');
});
