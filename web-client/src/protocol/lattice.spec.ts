import { expect, test } from 'vitest';
import { dequantise, isLattice, lastNode, type Lattice } from './lattice.ts';

const lattice: Lattice = { origin: [-1, 2, 0.5], step: 0.25, bits: 16 };

test('puts nodes a step apart from the origin on', () => {
    const positions = new Float32Array(6);
    dequantise(lattice, Int32Array.of(0, 0, 0, 4, 8, lastNode(16)), positions);
    expect([...positions]).toEqual([-1, 2, 0.5, 0, 4, 0.5 + 0.25 * 65535]);
});

test('refuses lattices without a step, with too many bits or with numbers that are not finite', () => {
    expect(isLattice(lattice)).toBe(true);
    expect(isLattice({ ...lattice, step: 0 })).toBe(false);
    expect(isLattice({ ...lattice, step: Number.NaN })).toBe(false);
    expect(isLattice({ ...lattice, bits: 21 })).toBe(false);
    expect(isLattice({ ...lattice, bits: 7.5 })).toBe(false);
    expect(isLattice({ ...lattice, origin: [0, Number.POSITIVE_INFINITY, 0] })).toBe(false);
});
