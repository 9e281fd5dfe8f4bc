import { expect, test } from 'vitest';
import { Growing } from './growing.ts';

test('keeps what was appended, in order', () => {
    const growing = new Growing(Int32Array);
    for (let i = 0; i < 100; i += 1)
        growing.extend(3).set([i, i, i]);
    expect(growing.view).toHaveLength(300);
    expect(growing.view[299]).toBe(99);
    expect(growing.view[0]).toBe(0);
});

test('copies a bounded number of times', () => {
    const growing = new Growing(Float32Array);
    const buffers = new Set<ArrayBufferLike>();
    for (let i = 0; i < 1000; i += 1) {
        growing.extend(100);
        buffers.add(growing.view.buffer);
    }
    expect(buffers.size).toBeLessThan(16);
});
