import { expect, test } from 'vitest';
import { crc32c } from './crc32c.ts';

const text = new TextEncoder();

function bitwise(bytes: Uint8Array): number {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ ((crc & 1) !== 0 ? 0x82f63b78 : 0);
    }
    return ~crc >>> 0;
}

test('gives the published check values', () => {
    expect(crc32c(text.encode('123456789'))).toBe(0xe3069283);
    expect(crc32c(new Uint8Array(0))).toBe(0);
    expect(crc32c(new Uint8Array(32))).toBe(0x8a9136aa);
    expect(crc32c(new Uint8Array(32).fill(0xff))).toBe(0x62a8ab43);
    expect(crc32c(Uint8Array.from({ length: 32 }, (_, i) => i))).toBe(0x46dd794e);
});

test('equals its definition for every length and alignment', () => {
    const bytes = Uint8Array.from({ length: 67 }, (_, i) => i * i * 31 + 7);
    for (let from = 0; from < 8; ++from) {
        for (let to = from; to <= bytes.length; ++to) {
            expect(crc32c(bytes.subarray(from, to))).toBe(bitwise(bytes.subarray(from, to)));
        }
    }
});

test('of a whole is that of its parts in turn', () => {
    const bytes = text.encode('quads with hanging nodes, column by column');
    for (let cut = 0; cut <= bytes.length; ++cut) {
        expect(crc32c(bytes.subarray(cut), crc32c(bytes.subarray(0, cut)))).toBe(crc32c(bytes));
    }
});
