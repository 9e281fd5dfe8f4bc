import { afterEach, expect, it, vi } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';

import { PageBench } from '../../testing/pageBench.ts';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { rested } from '../../testing/shownPanel.ts';
import { lateMs } from '../base/lateWaits.ts';
import { readNumbers } from '../surface/numberTable.ts';
import { Plots } from './plots.ts';
import { plotOfNumbers } from './surfaceNumbers.ts';

/** Where x < 0 is a body; the speed is 5 times x, p is the time where it is stored: not at 10. */
function sampled({ points, time, fields }: Record<string, unknown>): unknown {
    const inside = (points as Vec3[]).map(([x]) => x >= 0);
    const values = (fields as string[]).map((name) => [
        name,
        (points as Vec3[]).map(([x], i) => {
            if (!inside[i]) return null;
            if (name === 'U') return [3 * x, 4 * x, 0];
            return time === 10 ? null : time;
        }),
    ]);
    return { inside, values: Object.fromEntries(values) as unknown };
}

const numbers = 'time [s],area [m^2],area_error [m^2],cut,flux,notes\n9,1,0.1,,,torn\n10,2,0.1,3,,\n';

function opened(): { bench: PageBench; plots: Plots } {
    const bench = new PageBench();
    const fields = [fieldOf('U', { components: 3, unit: 'm/s' }), fieldOf('p', { unit: 'Pa' }), fieldOf('mask')];
    bench.state.dataset.value = datasetOf({ ...bench.state.dataset.value, times: [8.5, 10, 12], fields, surfaceFields: ['p'] });
    bench.answers['probe.sample'] = sampled;
    const plots = new Plots({
        ...bench,
        mesh: { numbers: () => Promise.resolve({ text: numbers, fault: '' }) },
        time: () => bench.playback.time.value,
    });
    return { bench, plots };
}

afterEach(() => {
    vi.useRealTimers();
});

it('words say that the server is late with values, which can be asked for again', async () => {
    vi.useFakeTimers();
    const { bench, plots } = opened();
    bench.answers['probe.sample'] = () => new Promise(() => undefined);
    bench.view.plot.value = 'rake';
    await vi.advanceTimersByTimeAsync(lateMs - 1);
    expect(plots.late.value).toBe(false);
    await vi.advanceTimersByTimeAsync(1);
    expect([plots.late.value, plots.plot.value]).toEqual([true, null]);
    bench.answers['probe.sample'] = sampled;
    plots.retry();
    await vi.advanceTimersByTimeAsync(0);
    expect([plots.late.value, plots.plot.value?.series.length]).toEqual([false, 1]);
});

it('along a line there are gaps where there is no fluid, and the axis is the distance', async () => {
    const { bench, plots } = opened();
    bench.view.measured.value = [
        [-1, 0, 0],
        [1, 0, 0],
    ];
    bench.view.plot.value = 'line';
    await rested();
    const { x, series, places } = plots.plot.value!;
    expect([x.values[0], x.values[200], x.values[400]]).toEqual([0, 1, 2]);
    expect(series[0]).toMatchObject({ name: 'speed', unit: 'm/s' });
    expect([series[0]!.values[0], series[0]!.values[400]]).toEqual([Number.NaN, 5]);
    // At the time of the picture, moved to the nearest that the data have.
    expect(places.map(({ name, values }) => [name, values[400]])).toEqual([
        ['x', 1],
        ['y', 0],
        ['z', 0],
        ['time', 12],
    ]);
});

it('begins with what the surface is coloured by', async () => {
    const { bench, plots } = opened();
    bench.view.changeLook(bench.state.activeSurface.value!, { colourBy: 'field:p' });
    bench.view.plot.value = 'rake';
    await rested();
    expect(plots.drawn.value.map(({ name }) => name)).toEqual(['p']);
});

it('along the rake follows the rake, with the newest of what changes asked for next', async () => {
    const { bench, plots } = opened();
    bench.view.plot.value = 'rake';
    await rested();
    expect(plots.plot.value!.title).toContain('Along Rake 1');
    const before = bench.asked('probe.sample').length;
    for (const x of [1, 2, 3]) {
        bench.state.rakeShape.value = {
            kind: 'line',
            points: [
                [x, 0, 0],
                [x, 0, 4],
            ],
        };
    }
    await rested();
    const asked = bench.asked('probe.sample').slice(before);
    expect(asked.length).toBe(2);
    expect(plots.plot.value!.series[0]!.values[0]).toBe(15);
});

it('over time asks for each time once, and says at how many there is no value', async () => {
    const { bench, plots } = opened();
    bench.view.probeHeld.value = [2, 0, 0];
    bench.view.plot.value = 'point';
    await rested();
    expect(plots.plot.value!.series[0]!.values).toEqual([10, 10, 10]);
    plots.choose('p', true);
    await rested();
    expect(plots.plot.value!.series.map(({ name, values }) => [name, values])).toEqual([
        ['speed', [10, 10, 10]],
        ['p', [8.5, Number.NaN, 12]],
    ]);
    expect(plots.plot.value!.notes).toEqual(['p has no values at 1 of 3 times.']);
    bench.view.probeHeld.value = [-2, 0, 0];
    await rested();
    expect(plots.plot.value!.notes).toEqual(['This point is not in the fluid.']);
});

it('that is closed asks for nothing more', async () => {
    const { bench, plots } = opened();
    const waiting: ((result: unknown) => void)[] = [];
    bench.answers['probe.sample'] = () => new Promise((resolve) => waiting.push(resolve));
    bench.view.probeHeld.value = [2, 0, 0];
    bench.view.plot.value = 'point';
    await rested();
    expect(waiting.length).toBe(2);
    plots.close();
    for (const resolve of waiting) resolve(sampled({ points: [[2, 0, 0]], time: 8.5, fields: ['U'] }));
    await rested();
    expect(waiting.length).toBe(2);
    expect(plots.plot.value).toBeNull();
});

it('data of one time say why there is nothing over time, and what a server refuses is said', async () => {
    const { bench, plots } = opened();
    bench.state.dataset.value = { ...bench.state.dataset.value!, times: [0] };
    bench.view.plot.value = 'point';
    await rested();
    expect(plots.fault.value).toContain('one time');
    bench.answers['probe.sample'] = () => {
        throw new Error('the file cannot be read');
    };
    bench.view.plot.value = 'rake';
    await rested();
    expect(plots.plot.value).toBeNull();
    expect(plots.fault.value).toContain('the file cannot be read');
});

it('numbers of the surface are those that the server knows, over its time', async () => {
    const { bench, plots } = opened();
    bench.view.plot.value = 'surface';
    await rested();
    expect(plots.quantities.value.map(({ name }) => name)).toEqual(['area', 'cut']);
    expect(plots.plot.value).toMatchObject({ x: { name: 'time', unit: 's', values: [9, 10] }, notes: [] });
    expect(plots.plot.value!.series).toMatchObject([{ name: 'area', unit: 'm^2', values: [1, 2] }]);
    plots.choose('cut', true);
    expect(plots.plot.value!.notes).toEqual(['torn']);
});

it('numbers of a backward surface are drawn from the earliest time on', () => {
    const table = readNumbers('time [s],area [m^2],notes\n10,1,\n9,2,\n8,3,\n');
    const { x, series } = plotOfNumbers(table, [{ name: 'area', unit: 'm^2', group: 'm^2' }], '');
    expect([x.values, series[0]!.values]).toEqual([
        [8, 9, 10],
        [3, 2, 1],
    ]);
});

it('over time, a time that could not be sampled is said, and no plot with a hole is drawn over the words', async () => {
    const { bench, plots } = opened();
    bench.answers['probe.sample'] = (params) => {
        if (params['time'] === 8.5) throw new Error('the disk is gone');
        return sampled(params);
    };
    bench.view.probeHeld.value = [1, 0, 0];
    bench.view.plot.value = 'point';
    for (let i = 0; i < 12; ++i) await rested();
    expect(plots.fault.value).toContain('the disk is gone');
    expect(plots.plot.value).toBeNull();
});
