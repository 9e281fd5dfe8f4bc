// Which vertices of a mesh are at one place.
/** Gives for each vertex the first at the same place: a vertex is there again for each normal that it has. */
export function placesOf(positions: ArrayLike<number>): Uint32Array {
    const numbers = new Float32Array(positions.length);
    // -0 is where 0 is.
    for (let i = 0; i < numbers.length; ++i) numbers[i] = positions[i]! + 0;
    const bits = new Uint32Array(numbers.buffer);
    const places = new Uint32Array(positions.length / 3);
    let size = 16;
    while (size < 2 * places.length) size *= 2;
    const table = new Int32Array(size).fill(-1);
    for (let i = 0; i < places.length; ++i) {
        const [x, y, z] = [bits[3 * i]!, bits[3 * i + 1]!, bits[3 * i + 2]!];
        let slot = Math.imul(Math.imul(Math.imul(x, 0x9e3779b1) ^ y, 0x85ebca6b) ^ z, 0xc2b2ae35);
        slot = (slot ^ (slot >>> 15)) & (size - 1);
        let at = table[slot]!;
        while (at >= 0 && (bits[3 * at] !== x || bits[3 * at + 1] !== y || bits[3 * at + 2] !== z)) {
            slot = (slot + 1) & (size - 1);
            at = table[slot]!;
        }
        if (at < 0) table[slot] = i;
        places[i] = at < 0 ? i : at;
    }
    return places;
}
