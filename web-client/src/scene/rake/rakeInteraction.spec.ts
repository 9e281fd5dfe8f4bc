import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { withCoordinate } from './rakeInteraction.ts';
import { circleOf, type RakeShape } from './rakeShape.ts';

const bounds = [-3, 13, -4, 4, 0, 6] as const;
const line: RakeShape = {
    kind: 'line',
    points: [
        [-1.41, 0.2, 0.29],
        [-1.41, 0.2, 5.58],
    ],
};

describe('a typed coordinate', () => {
    it('is taken to its last digit inside the domain', () => {
        const { shape, stoppedAt } = withCoordinate(line, 0, 1, 0.123456789012, bounds);
        expect(shape.points[0]).toEqual([-1.41, 0.123456789012, 0.29]);
        expect(stoppedAt).toBeNull();
    });

    it('stops at the edge of the domain alone: all other coordinates stay', () => {
        for (const [typed, edge] of [
            [-50, -3],
            [14, 13],
        ] as const) {
            const { shape, stoppedAt } = withCoordinate(line, 0, 0, typed, bounds);
            expect(shape.points).toEqual([[edge, 0.2, 0.29], line.points[1]]);
            expect(stoppedAt).toBe(edge);
        }
    });

    it('that rounding has put beyond the edge is the edge, without a word', () => {
        const inlet = Math.fround(0.1); // 0.100000001
        const { shape, stoppedAt } = withCoordinate(line, 0, 0, 0.1, [inlet, 13, -4, 4, 0, 6]);
        expect(shape.points[0]).toEqual([inlet, 0.2, 0.29]);
        expect(stoppedAt).toBeNull();
    });

    it('of the grip moves the whole rake until its first point is at the edge, and keeps its shape', () => {
        const { shape, stoppedAt } = withCoordinate(line, 'middle', 2, 100, bounds);
        expect(shape.points[1]).toEqual([-1.41, 0.2, expect.closeTo(6, 12)]);
        expect(shape.points[0]).toEqual([-1.41, 0.2, expect.closeTo(0.71, 12)]);
        expect(stoppedAt).toBeCloseTo(3.355, 9);
    });

    it('of the middle of a circle keeps it whole, as large, and at its other coordinates', () => {
        const points: Vec3[] = [
            [0, 0, 3],
            [0, 2, 3],
            [0, 0, 5],
        ];
        const { shape, stoppedAt } = withCoordinate({ kind: 'circle', points }, 'middle', 1, -50, bounds);
        const { centre, radius } = circleOf(shape);
        expect(radius).toBeCloseTo(2, 6);
        expect(centre).toEqual([0, expect.closeTo(-2, 6), 3]);
        expect(stoppedAt).toBeCloseTo(-2, 6);
    });
});
