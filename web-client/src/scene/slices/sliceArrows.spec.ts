import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { noSliceValue, sliceCodes, type SliceRaster } from '../../protocol/sliceFile.ts';
import { dot, lengthOf, minus } from '../rake/rakeShape.ts';
import { planeArrows } from './sliceArrows.ts';

const [columns, rows] = [8, 4];

/** Components of a flow on the plane z = 1, 8 by 4 wide. @param lacks  the sample without a value */
function componentsOf(flow: (x: number, y: number) => Vec3, lacks = -1): [SliceRaster, SliceRaster, SliceRaster] {
    return [0, 1, 2].map((axis): SliceRaster => {
        const codes = Uint16Array.from({ length: columns * rows }, (_, i) => {
            const value = flow((i % columns) + 0.5, Math.floor(i / columns) + 0.5)[axis]!;
            return i === lacks ? noSliceValue : Math.round(((value + 10) / 20) * sliceCodes);
        });
        return {
            ...{ columns, rows, inFlow: columns * rows, corner: [0, 0, 1], across: [columns, 0, 0], up: [0, rows, 0] },
            ...{ time: 0, range: [-10, 10], codes },
        };
    }) as [SliceRaster, SliceRaster, SliceRaster];
}

function shaftsOf({ ends }: { ends: number[] }): { from: Vec3; to: Vec3 }[] {
    return Array.from({ length: ends.length / 18 }, (_, i) => ({
        from: ends.slice(18 * i, 18 * i + 3) as unknown as Vec3,
        to: ends.slice(18 * i + 3, 18 * i + 6) as unknown as Vec3,
    }));
}

describe('arrows in a plane', () => {
    it('show the velocity without its part across the plane, evenly long in an even flow', () => {
        const arrows = planeArrows(componentsOf(() => [3, 4, -9]));
        expect(arrows.longest).toBeCloseTo(5, 2);
        const shafts = shaftsOf(arrows);
        expect(shafts).toHaveLength(columns * rows);
        for (const { from, to } of shafts) {
            const along = minus(to, from);
            expect(along[2]).toBeCloseTo(0, 9);
            expect(along[0] / along[1]).toBeCloseTo(3 / 4, 2);
            expect(lengthOf(along)).toBeCloseTo(0.9, 2);
        }
    });

    it('go round a vortex, the longer the faster', () => {
        const shafts = shaftsOf(planeArrows(componentsOf((x, y) => [-(y - 2), x - 4, 0])));
        const lengths = shafts.map(({ from, to }) => {
            const middle: Vec3 = [(from[0] + to[0]) / 2 - 4, (from[1] + to[1]) / 2 - 2, 0];
            expect(Math.abs(dot(minus(to, from), middle))).toBeLessThan(1e-2);
            return lengthOf(minus(to, from)) / lengthOf(middle);
        });
        expect(Math.max(...lengths) / Math.min(...lengths)).toBeCloseTo(1, 1);
    });

    it('are not where there is no flow, or none along the plane', () => {
        expect(shaftsOf(planeArrows(componentsOf(() => [1, 0, 0], 5)))).toHaveLength(columns * rows - 1);
        expect(planeArrows(componentsOf(() => [0, 0, 0]))).toEqual({ ends: [], longest: 0 });
    });
});
