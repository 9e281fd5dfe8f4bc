import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { middleOf, translate } from './rakeDrag.ts';

describe('translate and middleOf', () => {
    it('move the middle with the ends', () => {
        const points: Vec3[] = [
            [0, 0, 0],
            [2, 4, 6],
        ];
        expect(middleOf(points)).toEqual([1, 2, 3]);
        expect(middleOf(translate(points, [1, 1, 1]))).toEqual([2, 3, 4]);
    });
});
