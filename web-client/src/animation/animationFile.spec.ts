import { describe, expect, it } from 'vitest';
import { readAnimation } from './animationFile.ts';

const base64 = (bytes: number[]): string => Buffer.from(bytes).toString('base64');

describe('a file', () => {
    it('is read as the frames that stand behind their lengths', () => {
        const { frames, description } = readAnimation('{"title":"wake"}', base64([2, 0, 0, 0, 7, 8, 1, 0, 0, 0, 9]));
        expect(frames.map((frame) => [...frame])).toEqual([[7, 8], [9]]);
        expect(description.title).toBe('wake');
    });

    it('that was cut off is refused', () => {
        expect(() => readAnimation('{}', base64([2, 0, 0, 0, 7]))).toThrow(/not whole/);
        expect(() => readAnimation('{}', base64([1, 0, 0, 0, 7, 2, 0]))).toThrow(/not whole/);
    });

    it('without an animation says what writes one', () => {
        expect(() => readAnimation('', '')).toThrow(/wakesurf surface -o FILE\.html/);
    });
});
