// The comparison that other tests rely on says no where there is nothing to compare.
import { expect, it } from 'vitest';
import { expectSamePoints } from './support/same_points.ts';

it('points are not the same where there are none, too few, or others', () => {
    for (const [found, wanted] of [
        [[], []],
        [[[]], [[]]],
        [undefined, [[1, 2, 3]]],
        [[[1, 2, 3]], undefined],
        [
            [[1, 2, 3]],
            [
                [1, 2, 3],
                [4, 5, 6],
            ],
        ],
        [[[1, 2, 3.1]], [[1, 2, 3]]],
    ]) {
        expect(() => expectSamePoints(found, wanted)).toThrow();
    }
});

it('points that differ by less than the decimals are the same', () => {
    expectSamePoints([[1, 2, 3.0004]], [[1, 2, 3]], 3);
});
