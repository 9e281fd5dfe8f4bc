import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { besideRake, defaultLength, defaultRake, defaultSweep, freeRake } from './defaults.ts';

describe('defaultRake', () => {
    it('stands along z near the inflow of a domain that is longest in x', () => {
        const [a, b] = defaultRake([-3, 13, -4, 4, 0, 6]);
        expect(a[0]).toBeCloseTo(-1.4);
        expect([a[2], b[2]]).toEqual([expect.closeTo(0.3), expect.closeTo(5.7)]);
        expect([a[0], a[1]]).toEqual([b[0], b[1]]);
    });

    it('keeps off the line of symmetry', () => {
        const [a] = defaultRake([-5, 10, -5, 5, -5, 5]);
        expect(a[1]).not.toBeCloseTo(0, 2);
        expect(Math.abs(a[1])).toBeLessThan(0.5);
    });

    it('is perpendicular to the longest axis of any domain, and inside', () => {
        for (const bounds of [
            [0, 1, 0, 5, 0, 2],
            [0, 2, 0, 1, -5, 5],
            [0, 1, 0, 1, 0, 1],
        ] as [number, number, number, number, number, number][]) {
            const [a, b] = defaultRake(bounds);
            const sides = [0, 1, 2].map((k) => bounds[2 * k + 1]! - bounds[2 * k]!);
            const longest = sides.indexOf(Math.max(...sides));
            expect(b[longest]! - a[longest]!).toBe(0);
            for (const point of [a, b]) {
                point.forEach((v, k) => {
                    expect(v).toBeGreaterThan(bounds[2 * k]!);
                    expect(v).toBeLessThan(bounds[2 * k + 1]!);
                });
            }
            expect(Math.hypot(...b.map((v, k) => v - a[k]!))).toBeGreaterThan(0.5);
        }
    });
});

describe('defaultSweep', () => {
    const bounds: [number, number, number, number, number, number] = [-8, 8, -4, 4, 0, 6];

    it('goes across the flow from a rake across it, by a quarter of the longest side', () => {
        const rake: Vec3[] = [
            [-7, -2, 1],
            [-7, -2, 5],
        ];
        expect(defaultSweep(bounds, rake)).toEqual([0, 4, 0]);
    });

    it('takes the axis most perpendicular to the rake, whatever its length', () => {
        const rake: Vec3[] = [
            [-7, -3, 1],
            [-6.9, 3, 2],
        ];
        expect(defaultSweep(bounds, rake)).toEqual([4, 0, 0]);
    });

    it('goes to where there is room, and never out of the domain', () => {
        const rake: Vec3[] = [
            [-7, 1, 1],
            [-7, 1, 5],
        ];
        expect(defaultSweep([-8, 8, -2, 2, 0, 6], rake)).toEqual([0, -2.85, 0]);
        expect(defaultSweep(bounds, rake)).toEqual([0, -4, 0]);
    });
});

describe('defaultLength', () => {
    it('lets the fastest flow cross the domain, whatever its units', () => {
        for (const speed of [1e-6, 1, 340]) {
            const travelled = defaultLength([-3, 13, -4, 4, 0, 6], speed) * speed;
            expect(travelled).toBeGreaterThan(16);
            expect(travelled).toBeLessThan(32);
        }
    });

    it('is usable without any flow', () => {
        expect(defaultLength([0, 1, 0, 1, 0, 1], 0)).toBe(1);
    });
});

describe('a further rake', () => {
    const bounds: [number, number, number, number, number, number] = [-3, 13, -4, 4, 0, 6];

    it('is clear of all the others, and in the domain', () => {
        const rakes: Vec3[][] = [defaultRake(bounds)];
        for (let i = 0; i < 6; ++i) {
            const next = freeRake(bounds, rakes);
            for (const other of rakes) {
                expect(Math.hypot(...next[0].map((v, k) => v - other[0]![k]!))).toBeGreaterThan(0.9);
            }
            next.flat().forEach((v, i) => {
                expect(v).toBeGreaterThan(bounds[2 * (i % 3)]!);
                expect(v).toBeLessThan(bounds[2 * (i % 3) + 1]!);
            });
            rakes.push(next);
        }
        expect(freeRake(bounds, [])).toEqual(defaultRake(bounds));
    });

    it('that is a copy stands beside the first, where there is room', () => {
        const [x, y, z] = besideRake(bounds, defaultRake(bounds));
        expect([x, z]).toEqual([0, 0]);
        expect(Math.abs(y)).toBeGreaterThan(0.5);
        expect(Math.abs(y)).toBeLessThan(2);
    });
});
