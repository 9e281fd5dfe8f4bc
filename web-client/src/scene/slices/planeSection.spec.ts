import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { cross, dot, lengthOf, minus } from '../rake/rakeShape.ts';
import { centroid, planeSection, spanAcross } from './planeSection.ts';

const cube = [0, 1, 0, 1, 0, 1];

function areaOf(polygon: readonly Vec3[]): number {
    const parts = polygon.slice(2).map((_, i) => {
        return lengthOf(cross(minus(polygon[i + 1]!, polygon[0]!), minus(polygon[i + 2]!, polygon[0]!))) / 2;
    });
    return parts.reduce((sum, part) => sum + part, 0);
}

describe('the section of a box', () => {
    it('across an axis is the rectangle there, with its centroid in the middle', () => {
        const section = planeSection([-1, 3, 0, 2, 0, 5], [1, 0.5, 4], [2, 0, 0]);
        expect(areaOf(section)).toBeCloseTo(10, 12);
        expect(centroid(section)).toEqual([1, 1, 2.5]);
    });

    it('of a cube across its diagonal is a regular hexagon in the middle and a triangle near a corner', () => {
        const hexagon = planeSection(cube, [0.5, 0.5, 0.5], [1, 1, 1]);
        expect(areaOf(hexagon)).toBeCloseTo((3 * Math.sqrt(3)) / 4, 12);
        expect(areaOf(planeSection(cube, [0.1, 0, 0], [1, 1, 1]))).toBeCloseTo(0.01 * (Math.sqrt(3) / 2), 12);
    });

    it('that goes through corners counts them once', () => {
        const section = planeSection(cube, [0, 0, 0], [1, -1, 0]);
        expect(areaOf(section)).toBeCloseTo(Math.SQRT2, 12);
        expect(centroid(section).map((each) => Number(each.toFixed(12)))).toEqual([0.5, 0.5, 0.5]);
    });

    it('is nothing where a plane misses the box, which is where it lies outside of the span', () => {
        const normal: Vec3 = [1, 2, -1];
        const [low, high] = spanAcross(cube, normal);
        for (const at of [low - 0.01, low + 0.01, high - 0.01, high + 0.01]) {
            const origin: Vec3 = [at, 0, 0];
            expect(planeSection(cube, origin, normal).length > 0).toBe(low < at && at < high);
            for (const point of planeSection(cube, origin, normal)) expect(dot(minus(point, origin), normal)).toBeCloseTo(0, 12);
        }
    });
});
