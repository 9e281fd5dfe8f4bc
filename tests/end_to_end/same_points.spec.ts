// The comparison that other tests rely on says no where there is nothing to compare.
import { expect, it } from 'vitest';
import { expectSamePoints } from './support/same_points.ts';

it('points are the same where they differ by less than the decimals, and not where there are none, too few, or others', () => {
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
    expectSamePoints([[1, 2, 3.0004]], [[1, 2, 3]], 3);
});
