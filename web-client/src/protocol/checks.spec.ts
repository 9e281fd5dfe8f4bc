import { describe, expect, it } from 'vitest';
import { flag, is, list, mapOf, members, number, oneOf, optional, orNull, point, text, token, tuple, whole } from './checks.ts';

const shape = members({
    name: text,
    kind: oneOf(['line', 'circle']),
    points: list(point),
    seeds: whole,
    time: optional(orNull(number)),
    on: optional(flag),
});
const sound = { name: 'a', kind: 'line', points: [[0, 0, 0]], seeds: 3 };

describe('checks', () => {
    it('take a value of the shape, also with members that they do not know', () => {
        expect(shape(sound)).toBeNull();
        expect(shape({ ...sound, time: null, on: true, newer: 7 })).toBeNull();
        expect(is(sound, shape)).toBe(true);
    });

    it('say where a value is wrong, and what is', () => {
        expect(shape(7)).toBe(' is not an object');
        expect(shape({ ...sound, name: undefined })).toBe('.name is not a text');
        expect(shape({ ...sound, kind: 'knot' })).toBe('.kind is not one of line, circle');
        expect(
            shape({
                ...sound,
                points: [
                    [0, 0, 0],
                    [0, 0, Number.NaN],
                ],
            }),
        ).toBe('.points[1] is not three finite numbers');
        expect(shape({ ...sound, seeds: 2.5 })).toBe('.seeds is not a whole number');
        expect(shape({ ...sound, time: Number.POSITIVE_INFINITY })).toBe('.time is not a finite number');
        expect(shape({ ...sound, on: 'yes' })).toBe('.on is not true or false');
        expect(mapOf(number)({ a: 1, b: 'x' })).toBe('.b is not a finite number');
        expect(list(number, 2)([1])).toBe(' has 1 entries, not 2');
        expect(token(null)).toBe(' is not a text or a number');
    });

    it('take a list whose entries differ entry by entry', () => {
        const pair = tuple<[number, string]>([whole, text]);
        expect(pair([3, 'a'])).toBeNull();
        expect(pair([3, 4])).toBe('[1] is not a text');
        expect(pair([3, 'a', 'b'])).toBe(' has 3 entries, not 2');
        expect(pair('3a')).toBe(' is not a list');
    });
});
