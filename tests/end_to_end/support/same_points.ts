// Whether points are those that were wanted. Fails where there are none: a loop over nothing would pass.
import { expect } from 'vitest';

type Points = readonly (readonly number[])[];

/** As many points as wanted, at least one, each number the same to so many decimals. */
export function expectSamePoints(found: Points | undefined, wanted: Points | undefined, decimals = 9): void {
    expect(wanted?.flat().length, 'numbers to compare with').toBeGreaterThan(0);
    expect(found).toEqual(wanted!.map((point) => point.map((value): unknown => expect.closeTo(value, decimals))));
}
