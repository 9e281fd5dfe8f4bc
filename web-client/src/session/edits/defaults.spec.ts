import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { besideRake, defaultSweep, describedRange, firstLevel, freeLevel, freeRake, levelFields, levelOf } from './defaults.ts';

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

    it.each([
        [
            'upright',
            [
                [-1.4, 0.2, 0.3],
                [-1.4, 0.2, 5.7],
            ],
            1,
        ],
        [
            'at a wall',
            [
                [-1.4, 3.9, 0.3],
                [-1.4, 3.9, 5.7],
            ],
            1,
        ],
        [
            'across the flow',
            [
                [-1.4, -3, 2],
                [-1.4, 3, 2],
            ],
            2,
        ],
    ] as [string, Vec3[], number][])(
        'is half as long as the first, and beside it, not before or behind it: %s',
        (_, rake, axis) => {
            const [start, end] = freeRake(bounds, rake, [rake]);
            const length = ([a, b]: readonly Vec3[]): number => Math.hypot(...a!.map((v, k) => v - b![k]!));
            expect(length([start, end])).toBeCloseTo(length(rake) / 2, 9);
            const middles = [[start, end], rake].map(([a, b]) => a!.map((v, k) => (v + b![k]!) / 2));
            const moved = middles[0]!.map((v, k) => v - middles[1]![k]!);
            moved.forEach((by, k) => {
                if (k === axis) expect(Math.abs(by)).toBeGreaterThan(0.5);
                else expect(Math.abs(by)).toBeLessThan(1e-9);
            });
            expect(Math.abs(moved[axis]!)).toBeLessThan(2.5);
        },
    );

    it('that is a copy stands beside the first, where there is room', () => {
        const [x, y, z] = besideRake(bounds, first);
        expect([x, z]).toEqual([0, 0]);
        expect(Math.abs(y)).toBeGreaterThan(0.5);
        expect(Math.abs(y)).toBeLessThan(2);
    });
});

const surfaceFields = ['p', 'mask', 'error', 'U', 'deformation', 'approximated', 'q_criterion', 'velocity_x', 'normal_x'];
const dataset = datasetOf({
    fields: [
        fieldOf('U', { components: 3, range: [0.5, 1.5] }),
        fieldOf('mask'),
        fieldOf('p', { range: [-2, 4] }),
        fieldOf('error', { range: [1, 1] }),
    ],
    surfaceFields,
});

describe('fields of level surfaces', () => {
    it('are what the data have, not what only surfaces have', () => {
        expect(levelFields(dataset)).toEqual(['p', 'mask', 'error', 'U', 'q_criterion', 'velocity_x']);
    });

    it('begin in the middle of their range, or where that is not known at what shows the cores of vortices, or at 0', () => {
        expect(firstLevel(dataset)).toEqual({ field: 'p', level: 1 });
        expect(levelOf(dataset, 'q_criterion')).toEqual({ field: 'q_criterion', level: 75 });
        expect(levelOf(dataset, 'velocity_x')).toEqual({ field: 'velocity_x', level: 0 });
        expect(firstLevel({ ...dataset, surfaceFields: ['mask', 'U'] })).toEqual({ field: 'U', level: 1 });
        expect(freeLevel(dataset, new Set())).toEqual({ field: 'p', level: 1 });
        expect(freeLevel(dataset, new Set(['p']))).toEqual({ field: 'U', level: 1 });
        expect(freeLevel(dataset, new Set(levelFields(dataset)))).toEqual({ field: 'p', level: 2.5 });
    });

    it('have no range where all values are the same, or none is known', () => {
        expect(describedRange(dataset, 'error')).toBeNull();
        expect(describedRange(datasetOf({ fields: [fieldOf('p', { range: [null, null] })] }), 'p')).toBeNull();
    });
});
