// Typed arrays with room to grow: states change at every update, their memory need not.

type Numbers = Int32Array | Uint32Array;

/**
 * `array` itself if it has `length` numbers, else one with the same beginning and room for half as many more:
 * pages that are not used cost nothing, growing soon again costs a copy.
 */
export function roomFor<Kind extends Numbers>(array: Kind, length: number): Kind {
    if (array.length >= length) return array;
    const make = array.constructor as new (length: number) => Kind;
    const longer = new make(length + (length >> 1));
    longer.set(array);
    return longer;
}
