// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { expect, it } from 'vitest';
import type { SliceRecord } from '../../protocol/messages.ts';
import type { SurfaceSpan } from '../../scene/surface/surfaceLayer.ts';
import { plainStyle } from '../../scene/surface/surfaceStyle.ts';
import { PageBench } from '../../testing/pageBench.ts';
import type { BodySpan } from '../../session/picture/bodyFields.ts';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { ShownPanel } from '../../testing/shownPanel.ts';
import './scalarBar.ts';

async function barOf(
    drawn: Partial<SurfaceSpan>,
    body: BodySpan | null = null,
    slices: unknown = null,
    bench = new PageBench(),
): Promise<ShownPanel> {
    const span = { colours: [0, 2], t: [0, 1], s: [0, 1], age: [0, 1], style: plainStyle, lacks: '', ...drawn };
    return ShownPanel.of('wakesurf-scalar-bar', {
        ...bench,
        scene: { surfaces: { spanOf: () => span } },
        bodyFields: { span: signal(body) },
        slices: signal(slices),
        lines: signal(null),
    });
}

it('the scalar bar says what a surface has no values of, and has no colours for it', async () => {
    const style = { ...plainStyle, source: 'constant' as const, scalar: '' };
    const bar = await barOf({ style, lacks: 'q_criterion' });
    expect(bar.all('figure')).toHaveLength(0);
    expect(bar.text).toContain('Q, above 0: vortex: no values, so one colour');
    expect(bar.get<HTMLElement>('wakesurf-scalar-bar').hidden).toBe(false);
});

it('the scalar bar is not there where one colour was chosen, and has colours where there are values', async () => {
    const style = { ...plainStyle, source: 'constant' as const };
    expect((await barOf({ style })).get<HTMLElement>('wakesurf-scalar-bar').hidden).toBe(true);
    const bar = await barOf({});
    expect(bar.all('figure')).toHaveLength(1);
    expect(bar.text).not.toContain('no values');
});

it('the scalar bar has colours of the body below those of surfaces', async () => {
    const bar = await barOf({}, { field: 'p', map: 'viridis', colours: [-3, 1], beyond: [null, 7] });
    expect(bar.all('figure')).toHaveLength(2);
    const [, ofBody] = bar.all('figure');
    expect(ofBody?.getAttribute('aria-label')).toBe('Colours: p from −3 to 1, of the body, the last 1 %: to 7');
});

it('the scalar bar says what the colours of a slice mean', async () => {
    const meanings = signal(new Map([['c1', { field: 'vorticity_z', map: 'coolToWarm', range: [-3, 3], contours: 0 }]]));
    const bar = await barOf({ style: { ...plainStyle, source: 'constant' } }, null, { slices: { meanings } });
    expect(bar.all('figure')).toHaveLength(1);
    expect(bar.get('figure').getAttribute('aria-label')).toContain('Vorticity z from −3 to 3');
});

it('the scalar bar has the units of the data that each thing is of, and a bar for each', async () => {
    const bench = new PageBench();
    const { state } = bench;
    const [id, record] = [...state.surfaces.value][0]!;
    state.surfaces.value = new Map([[id, { ...record, dataset: 'other' }]]);
    const described = (dataset: string, unit: string) => datasetOf({ dataset, fields: [fieldOf('p', { unit })] });
    state.dataset.value = described('flow', 'Pa');
    state.otherDatasets.value = new Map([['other', described('other', 'bar')]]);
    const meaning = { field: 'p', less: '', map: 'viridis', range: [0, 2] };
    const sliceOf = (slice: string, dataset: string): [string, SliceRecord] => [
        slice,
        { slice, rev: 1, dataset, origin: [0, 0, 0], normal: [0, 0, 1], field: 'p' },
    ];
    state.slices.value = new Map([sliceOf('c1', 'flow'), sliceOf('c2', 'other')]);
    const meanings = signal(new Map(['c1', 'c2'].map((each) => [each, meaning])));
    const style = { ...plainStyle, source: 'scalar' as const, scalar: 'p' };
    const bar = await barOf({ style }, null, { slices: { meanings } }, bench);
    const titles = bar.all('figcaption span:first-child').map((each) => each.textContent);
    expect(titles.map((each) => /Pa|bar/.exec(each ?? '')?.[0])).toEqual(['bar', 'Pa', 'bar']);
});
