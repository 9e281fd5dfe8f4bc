// The checksum of a frame: CRC-32 as in zlib and PNG.

const table = Int32Array.from({ length: 256 }, (_, byte) => {
    let remainder = byte;
    for (let bit = 0; bit < 8; ++bit) remainder = (remainder >>> 1) ^ (remainder & 1 ? 0xedb88320 : 0);
    return remainder;
});

/** Returns the checksum of `bytes`, or of what `before` is the checksum of and `bytes` behind it;
 *  unsigned. */
export function crc32(bytes: Uint8Array, before = 0): number {
    let crc = ~before;
    for (let i = 0; i < bytes.length; ++i) crc = (crc >>> 8) ^ table[(crc ^ bytes[i]!) & 0xff]!;
    return ~crc >>> 0;
}
