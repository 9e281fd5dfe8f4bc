// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import type { Plot } from './plot.ts';
import { axesOf, ticksUp } from './plotAxes.ts';
import { plotCsv } from './plotCsv.ts';
import { plotSvg } from './plotSvg.ts';

const plot: Plot = {
    title: 'Along <Rake & 1>',
    x: { name: 'distance', unit: 'm', values: [0, 1, 2, 3] },
    places: [{ name: 'time', unit: '', values: [2.5, 2.5, 2.5, 2.5] }],
    series: [
        { name: 'speed', unit: 'm/s', group: 'm/s', values: [0, Number.NaN, 1, 2] },
        { name: 'velocity_x', unit: 'm/s', group: 'm/s', values: [-2, -1, 0, 1] },
        { name: 'p, static', unit: 'Pa', group: 'Pa', values: [1e5, 1e5, 1e5, 1e5] },
    ],
    notes: [],
};

it('the file of numbers has names with units, a row for each place, and nothing where there is no value', () => {
    expect(plotCsv(plot)).toBe(
        'distance [m],time,speed [m/s],velocity_x [m/s],"p, static [Pa]"\n' +
            '0,2.5,0,-2,100000\n1,2.5,,-1,100000\n2,2.5,1,0,100000\n3,2.5,2,1,100000\n',
    );
});

it('lines of one unit share an axis that holds them all, and one value alone has room', () => {
    const [speeds, pressure] = axesOf(plot);
    expect(speeds).toMatchObject({ title: 'speed, velocity_x [m/s]', series: [0, 1] });
    expect(speeds!.range[0]).toBeCloseTo(-2.24);
    expect(speeds!.range[1]).toBeCloseTo(2.24);
    expect(pressure).toMatchObject({ title: 'p, static [Pa]', series: [2], range: [9e4, 1.1e5] });
    expect(ticksUp(...speeds!.range, 130).ticks.map(({ value }) => value)).toEqual([-2, -1, 0, 1, 2]);
});

it('the picture has the lines where their values are, broken where there are none', () => {
    const svg = new DOMParser().parseFromString(plotSvg(plot), 'image/svg+xml');
    expect(svg.querySelector('parsererror')).toBeNull();
    const [speed, velocity, pressure] = [...svg.querySelectorAll('path[fill=none]')].map((each) => each.getAttribute('d')!);
    // The frame is from 78 to 722 across, and from 362 up to 58.
    expect(speed).toBe('M78 210h0M507.33 142.14L722 74.29');
    expect(velocity!.match(/L/g)).toHaveLength(3);
    expect(pressure!.startsWith('M78 210L')).toBe(true);
    const words = [...svg.querySelectorAll('text')].map((each) => each.textContent);
    for (const each of ['Along <Rake & 1>', 'distance [m]', 'speed, velocity_x [m/s]', 'p, static']) {
        expect(words).toContain(each);
    }
});
