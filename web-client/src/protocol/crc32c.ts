// CRC-32C (Castagnoli), the checksum of frames and of mesh states. Twin: protocol/crc32c.hpp.

const reflectedPolynomial = 0x82f63b78;

/** Eight tables of 256: slicing-by-8 (Kounavis, Berry, IEEE Trans. Comput. 57(11), 2008). */
function makeTables(): Int32Array {
    const tables = new Int32Array(8 * 256);
    for (let byte = 0; byte < 256; ++byte) {
        let crc = byte;
        for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ ((crc & 1) !== 0 ? reflectedPolynomial : 0);
        tables[byte] = crc;
    }
    for (let i = 256; i < tables.length; ++i) {
        const before = tables[i - 256]!;
        tables[i] = (before >>> 8) ^ tables[before & 0xff]!;
    }
    return tables;
}

const tables = makeTables();

function sumBytes(bytes: Uint8Array, from: number, to: number, start: number): number {
    let crc = start;
    for (let at = from; at < to; ++at) crc = (crc >>> 8) ^ tables[(crc ^ bytes[at]!) & 0xff]!;
    return crc;
}

function sumWords(words: Uint32Array, start: number): number {
    const t = tables;
    let crc = start;
    for (let at = 0; at + 1 < words.length; at += 2) {
        const low = words[at]! ^ crc;
        const high = words[at + 1]!;
        crc =
            t[1792 + (low & 0xff)]! ^
            t[1536 + ((low >>> 8) & 0xff)]! ^
            t[1280 + ((low >>> 16) & 0xff)]! ^
            t[1024 + (low >>> 24)]! ^
            t[768 + (high & 0xff)]! ^
            t[512 + ((high >>> 8) & 0xff)]! ^
            t[256 + ((high >>> 16) & 0xff)]! ^
            t[high >>> 24]!;
    }
    return crc;
}

/**
 * The checksum of everything summed so far followed by `data`, as an unsigned number:
 * crc32c(b, crc32c(a)) === crc32c(a + b). Numbers are summed as they lie in memory, which is
 * little-endian on everything that runs WebGL 2.
 */
export function crc32c(data: ArrayBufferView, soFar = 0): number {
    const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    const head = Math.min(bytes.length, (4 - (bytes.byteOffset & 3)) & 3);
    const pairs = (bytes.length - head) >> 3;
    const words = pairs > 0 ? new Uint32Array(bytes.buffer, bytes.byteOffset + head, 2 * pairs) : new Uint32Array(0);
    let crc = sumBytes(bytes, 0, head, ~soFar);
    crc = sumWords(words, crc);
    crc = sumBytes(bytes, head + 8 * pairs, bytes.length, crc);
    return ~crc >>> 0;
}
