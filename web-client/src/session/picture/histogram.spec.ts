import { expect, it } from 'vitest';
import { histogramOf, spanOfValues } from './histogram.ts';

const even = { values: Array.from({ length: 1000 }, (_, i) => (i + 0.5) / 1000), weights: new Array<number>(1000).fill(2) };

it('even values fill even bins alike, and those of a root as the square has it', () => {
    for (const part of histogramOf(even, [0, 1], 'even', 4).parts) {
        expect(part).toBeCloseTo(0.25);
    }
    // Below (k / 4)^2 there is as much of them.
    const parts = histogramOf(even, [0, 1], 'root', 4).parts;
    [1 / 16, 3 / 16, 5 / 16, 7 / 16].forEach((part, k) => expect(Math.abs(parts[k]! - part)).toBeLessThan(0.0011));
});

it('values count by their area, and those without a logarithm or beyond the span do not', () => {
    const values = { values: [-1, 0, 1, 10, 100, 1000], weights: [1, 1, 1, 3, 1, 1] };
    expect(spanOfValues(values, 'log')).toEqual([1, 1000]);
    expect(spanOfValues(values, 'even')).toEqual([-1, 1000]);
    expect(histogramOf(values, [1, 100], 'log', 2).parts).toEqual([1 / 8, 4 / 8]);
    expect(spanOfValues({ values: [-1, 0], weights: [1, 1] }, 'log')).toBeNull();
});
