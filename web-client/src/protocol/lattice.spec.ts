import { expect, test } from 'vitest';
import { dequantise, type Lattice } from './lattice.ts';

const lattice: Lattice = { origin: [-1, 2, 0.5], step: 0.25, bits: 16 };

test('puts nodes a step apart from the origin on', () => {
    const positions = new Float32Array(6);
    dequantise(lattice, Int32Array.of(0, 0, 0, 4, 8, 65535), positions);
    expect([...positions]).toEqual([-1, 2, 0.5, 0, 4, 0.5 + 0.25 * 65535]);
});
