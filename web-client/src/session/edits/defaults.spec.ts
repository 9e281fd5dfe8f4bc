import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { besideRake, defaultSweep, freeRake } from './defaults.ts';

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

describe('a further rake', () => {
    const bounds: [number, number, number, number, number, number] = [-3, 13, -4, 4, 0, 6];

    const first: Vec3[] = [
        [-1.4, 0.2, 0.3],
        [-1.4, 0.2, 5.7],
    ];

    it('is clear of all the others, and in the domain', () => {
        const rakes: Vec3[][] = [first];
        for (let i = 0; i < 6; ++i) {
            const next = freeRake(bounds, first, rakes);
            for (const other of rakes) {
                expect(Math.hypot(...next[0].map((v, k) => v - other[0]![k]!))).toBeGreaterThan(0.9);
            }
            next.flat().forEach((v, i) => {
                expect(v).toBeGreaterThan(bounds[2 * (i % 3)]!);
                expect(v).toBeLessThan(bounds[2 * (i % 3) + 1]!);
            });
            rakes.push(next);
        }
        expect(freeRake(bounds, first, [])).toEqual(first);
    });

    it('that is a copy stands beside the first, where there is room', () => {
        const [x, y, z] = besideRake(bounds, first);
        expect([x, z]).toEqual([0, 0]);
        expect(Math.abs(y)).toBeGreaterThan(0.5);
        expect(Math.abs(y)).toBeLessThan(2);
    });
});
