import { describe, expect, it } from 'vitest';
import { framesOf } from './obstacle.ts';

describe('framesOf', () => {
    it('cuts the body at the lengths', () => {
        const bytes = Uint8Array.of(2, 0, 0, 0, 10, 11, 1, 0, 0, 0, 12);
        expect(framesOf(bytes).map((frame) => [...frame])).toEqual([[10, 11], [12]]);
        expect(framesOf(new Uint8Array())).toEqual([]);
    });

    it('refuses a body that ends within a frame', () => {
        expect(() => framesOf(Uint8Array.of(9, 0, 0, 0, 1))).toThrow(/incomplete/);
    });
});
