import { describe, expect, it } from 'vitest';
import { type KeyPress, timeKey } from './timeKeys.ts';

const press = (key: string, more: Partial<KeyPress> = {}): KeyPress => ({
    ...{ key, ctrlKey: false, altKey: false, metaKey: false, defaultPrevented: false, ...more },
});

describe('timeKey', () => {
    it('knows three keys', () => {
        expect([' ', ',', '.', 'a', 'Enter'].map((key) => timeKey(press(key), false))).toEqual([
            ...['toggle', 'back', 'forward', null, null],
        ]);
    });

    it('leaves keys to the elements that want them', () => {
        expect(timeKey(press(' '), true)).toBeNull();
        expect(timeKey(press('.'), true)).toBe('forward');
        expect(timeKey(press(' ', { ctrlKey: true }), false)).toBeNull();
        expect(timeKey(press(' ', { defaultPrevented: true }), false)).toBeNull();
    });
});
