import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import {
    asKind,
    circleOf,
    circleShape,
    curveOf,
    distance,
    dot,
    fitted,
    lengthOf,
    middleOf,
    minus,
    normalOf,
    type RakeShape,
    resized,
    tilted,
    translated,
    turnedBy,
    unit,
    withoutPoint,
    withPointAfter,
} from './rakeShape.ts';

const line: RakeShape = {
    kind: 'line',
    points: [
        [0, 0, 0],
        [2, 4, 6],
    ],
};
const bent: RakeShape = {
    kind: 'polyline',
    points: [
        [0, 0, 0],
        [2, 0, 0],
        [2, 4, 0],
        [2, 4, 1],
    ],
};
const ring = circleShape({ centre: [1, 2, 3], radius: 0.5, u: [0, 1, 0], v: [0, 0, 1] });
const axis = unit([1, -2, 0.5]);

function lengths({ points }: RakeShape): number[] {
    return points.slice(1).map((point, i) => distance(point, points[i]!));
}

function expectClose(a: Vec3, b: Vec3): void {
    a.forEach((each, k) => expect(each).toBeCloseTo(b[k]!, 9));
}

describe('a rake that is moved', () => {
    it('takes its middle along', () => {
        expectClose(middleOf(line), [1, 2, 3]);
        expectClose(middleOf(translated(line, [1, 1, 1])), [2, 3, 4]);
        expectClose(middleOf(translated(ring, [1, 0, 0])), [2, 2, 3]);
    });
});

describe('a rake that is turned', () => {
    it.each([line, bent, ring])('keeps its middle and all its lengths', (shape) => {
        const turned = turnedBy(shape, axis, 1.1);
        expectClose(middleOf(turned), middleOf(shape));
        expect(turned.points).toHaveLength(shape.points.length);
        lengths(turned).forEach((each, i) => expect(each).toBeCloseTo(lengths(shape)[i]!, 9));
        expect(turned.points).not.toEqual(shape.points);
    });

    it('is as before when it is turned back', () => {
        const back = turnedBy(turnedBy(bent, axis, 0.7), axis, -0.7);
        expect(back.points).toHaveLength(bent.points.length);
        back.points.forEach((point, i) => expectClose(point, bent.points[i]!));
    });

    it('goes counterclockwise about the axis', () => {
        const x: RakeShape = {
            kind: 'line',
            points: [
                [-1, 0, 0],
                [1, 0, 0],
            ],
        };
        expectClose(turnedBy(x, [0, 0, 1], Math.PI / 2).points[1]!, [0, 1, 0]);
    });
});

describe('a circle', () => {
    it('is drawn closed, at its radius from its centre, in its plane', () => {
        const curve = curveOf(ring);
        expectClose(curve[0]!, curve.at(-1)!);
        for (const point of curve) {
            expect(distance(point, [1, 2, 3])).toBeCloseTo(0.5, 9);
            expect(point[0]).toBeCloseTo(1, 9);
        }
    });

    it('goes through the point its rim is dragged to, in the same plane', () => {
        for (const rim of [
            [1, 4, 3],
            [1, 2.3, 3.4],
            [1, 2, 2],
        ] as Vec3[]) {
            const after = resized(ring, rim);
            expectClose(after.points[1]!, rim);
            const { radius } = circleOf(after);
            expect(distance(after.points[2]!, [1, 2, 3])).toBeCloseTo(radius, 9);
            expect(Math.abs(dot(normalOf(circleOf(after)), [1, 0, 0]))).toBeCloseTo(1, 9);
        }
    });

    it('keeps centre and radius when it is tilted, and lies in the direction it was tilted to', () => {
        const after = tilted(ring, [3, 2, 3.5]);
        const { centre, radius, u, v } = circleOf(after);
        expectClose(centre, [1, 2, 3]);
        expect(radius).toBeCloseTo(0.5, 9);
        expectClose(v, unit([2, 0, 0.5]));
        expect(dot(u, v)).toBeCloseTo(0, 9);
        expect(lengthOf(u)).toBeCloseTo(1, 9);
    });

    it('is read from rim points that are not at right angles as the server reads them', () => {
        const skewed: RakeShape = {
            kind: 'circle',
            points: [
                [0, 0, 0],
                [2, 0, 0],
                [1, 1, 0],
            ],
        };
        const { radius, u, v } = circleOf(skewed);
        expect(radius).toBe(2);
        expectClose(u, [1, 0, 0]);
        expectClose(v, [0, 1, 0]);
    });

    it('is moved into the domain, and made smaller only where it must be', () => {
        const bounds = [0, 10, 0, 10, 0, 1] as const;
        const beside = circleShape({ centre: [9.9, 5, 0.5], radius: 1, u: [1, 0, 0], v: [0, 1, 0] });
        expect(circleOf(fitted(beside, bounds)).radius).toBeCloseTo(1, 9);
        const upright = circleShape({ centre: [9.9, 5, 0.5], radius: 1, u: [1, 0, 0], v: [0, 0, 1] });
        expect(circleOf(fitted(upright, bounds)).radius).toBeCloseTo(0.5, 6);
        for (const shape of [beside, upright]) {
            for (const point of curveOf(fitted(shape, bounds))) {
                point.forEach((each, k) => {
                    expect(each).toBeGreaterThanOrEqual(bounds[2 * k]! - 1e-12);
                    expect(each).toBeLessThanOrEqual(bounds[2 * k + 1]! + 1e-12);
                });
            }
        }
        expect(fitted(ring, [0, 10, 0, 10, 0, 10])).toBe(ring);
        expect(fitted(line, [5, 6, 5, 6, 5, 6])).toBe(line);
    });
});

describe('points of a polyline', () => {
    it('are added half-way to the next, and taken away again', () => {
        const more = withPointAfter(bent, 1);
        expect(more.points[2]).toEqual([2, 2, 0]);
        expect(withoutPoint(more, 2)).toEqual(bent);
    });

    it('are added beyond the end, as far as the last piece is long', () => {
        expect(withPointAfter(line, 1)).toEqual({ kind: 'polyline', points: [...line.points, [4, 8, 12]] });
    });

    it('are never fewer than two', () => {
        expect(withoutPoint(line, 0)).toBeNull();
    });
});

describe('a rake of another kind', () => {
    it('lies in the same place', () => {
        for (const shape of [line, bent, ring]) {
            for (const kind of ['line', 'polyline', 'circle'] as const) {
                const other = asKind(shape, kind, [1, 0, 0]);
                expect(other.kind).toBe(kind);
                expect(distance(middleOf(other), middleOf(shape))).toBeLessThan(1.5);
            }
        }
        expect(asKind(line, 'line', [1, 0, 0])).toBe(line);
        const circle = circleOf(asKind(line, 'circle', [1, 0, 0]));
        expectClose(circle.centre, [1, 2, 3]);
        expect(circle.radius).toBeCloseTo(lengthOf(minus([2, 4, 6], [0, 0, 0])) / 4, 9);
        const upright: RakeShape = {
            kind: 'line',
            points: [
                [0, 0, 0],
                [0, 0, 8],
            ],
        };
        expectClose(normalOf(circleOf(asKind(upright, 'circle', [1, 0, 0]))), [1, 0, 0]);
    });
});
