// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import type { SurfaceSpan } from '../../scene/surface/surfaceLayer.ts';
import { plainStyle } from '../../scene/surface/surfaceStyle.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { surfaceOf } from '../../testing/records.ts';
import { ShownPanel } from '../../testing/shownPanel.ts';
import './probePanel.ts';

it('the probe says first what a surface is coloured by there, and the age of the particle', async () => {
    const bench = new PageBench();
    bench.state.surfaces.value = new Map([['s1', surfaceOf('s1', { kind: 'streak', from: 0, to: 4 })]]);
    const style = { ...plainStyle, scalar: 'vorticity', tIsRelease: true };
    const span: SurfaceSpan = { colours: [0, 8], t: [0, 4], s: [0, 1], age: [0, 4], style, lacks: '' };
    bench.view.probe.value = {
        ...{ point: [1, 1, 1], time: 4, inside: true, values: [{ name: 'p', value: 2 }] },
        on: { surface: 's1', s: 0.5, t: 1.5, scalar: 6.25 },
    };
    const panel = await ShownPanel.of('wakesurf-probe', { ...bench, scene: { surfaces: { spanOf: () => span } } });
    expect(panel.get('#probe-colour').textContent).toBe('6.25');
    const [colour, age, field] = panel.all('dt').map((each) => each.textContent?.trim());
    expect([colour, age, field]).toEqual(['|Vorticity|', 'Age', 'p']);
    expect(panel.all('dd')[1]?.textContent).toBe('2.5');
});
