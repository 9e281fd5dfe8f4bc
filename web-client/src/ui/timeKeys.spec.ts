import { describe, expect, it } from 'vitest';
import { type KeyPress, timeKey } from './timeKeys.ts';

const press = (key: string, more: Partial<KeyPress> = {}): KeyPress => ({
    ...{ key, ctrlKey: false, altKey: false, metaKey: false, defaultPrevented: false, ...more },
});
const plain = { typedIn: false, takesSpace: false, inDialog: false };

describe('timeKey', () => {
    it('knows three keys', () => {
        expect([' ', ',', '.', 'a', 'Enter'].map((key) => timeKey(press(key), plain))).toEqual([
            ...['toggle', 'back', 'forward', null, null],
        ]);
    });

    it('leaves keys to whoever wants them', () => {
        expect(timeKey(press(' '), { ...plain, takesSpace: true })).toBeNull();
        expect(timeKey(press('.'), { ...plain, takesSpace: true })).toBe('forward');
        expect(timeKey(press('.'), { ...plain, typedIn: true })).toBeNull();
        expect(timeKey(press('.'), { ...plain, inDialog: true })).toBeNull();
        expect(timeKey(press(' ', { ctrlKey: true }), plain)).toBeNull();
        expect(timeKey(press(' ', { defaultPrevented: true }), plain)).toBeNull();
    });
});
