// Typed arrays with room to grow: states change at every update, their memory need not.

type Numbers = Int32Array | Uint32Array;

/// `array` itself if it has `length` numbers, else a longer one with the same beginning.
export function roomFor<Kind extends Numbers>(array: Kind, length: number): Kind {
    if (array.length >= length)
        return array;
    const make = array.constructor as new (length: number) => Kind;
    const longer = new make(Math.max(length, array.length + (array.length >> 1)));
    longer.set(array);
    return longer;
}
