import { expect, test } from 'vitest';
import { crc32 } from './crc32.ts';

const text = new TextEncoder();

function bitwise(bytes: Uint8Array): number {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ ((crc & 1) !== 0 ? 0xedb88320 : 0);
    }
    return ~crc >>> 0;
}

test('gives the published check values', () => {
    expect(crc32(text.encode('123456789'))).toBe(0xcbf43926);
    expect(crc32(new Uint8Array(0))).toBe(0);
    expect(crc32(new Uint8Array(32))).toBe(0x190a55ad);
    expect(crc32(new Uint8Array(32).fill(0xff))).toBe(0xff6cab0b);
    expect(crc32(Uint8Array.from({ length: 32 }, (_, i) => i))).toBe(0x91267e8a);
});

test('equals its definition for every length and alignment', () => {
    const bytes = Uint8Array.from({ length: 67 }, (_, i) => i * i * 31 + 7);
    for (let from = 0; from < 8; ++from) {
        for (let to = from; to <= bytes.length; ++to) {
            expect(crc32(bytes.subarray(from, to))).toBe(bitwise(bytes.subarray(from, to)));
        }
    }
});

test('of a whole is that of its parts in turn', () => {
    const bytes = text.encode('quads with hanging nodes, column by column');
    for (let cut = 0; cut <= bytes.length; ++cut) {
        expect(crc32(bytes.subarray(cut), crc32(bytes.subarray(0, cut)))).toBe(crc32(bytes));
    }
});
