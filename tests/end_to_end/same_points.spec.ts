// The comparison that other tests rely on says no where there is nothing to compare.
import { expect, it } from 'vitest';
import { expectSamePoints } from './support/same_points.ts';

it.each([
    ['no points', [], []],
    ['points of no numbers', [[]], [[]]],
    ['none of those that are wanted', undefined, [[1, 2, 3]]],
    ['nothing that is wanted', [[1, 2, 3]], undefined],
    [
        'one too few',
        [[1, 2, 3]],
        [
            [1, 2, 3],
            [4, 5, 6],
        ],
    ],
    ['one elsewhere', [[1, 2, 3.1]], [[1, 2, 3]]],
])('%s are not the same points', (_, found, wanted) => {
    expect(() => expectSamePoints(found, wanted)).toThrow();
});

it('points that differ by less than the decimals are the same', () => {
    expectSamePoints([[1, 2, 3.0004]], [[1, 2, 3]], 3);
});
