import { expect, it } from 'vitest';
import { isolated } from './foreignText.ts';

it('names that turn the direction of writing are kept apart from what is beside them, and others are as they are', () => {
    for (const name of ['', 'wake 2', 'Köln, 東京', '<b>"\'&']) expect(isolated(name)).toBe(name);
    expect(isolated('\u05d0\u05d1 1')).toBe('\u2068\u05d0\u05d1 1\u2069');
    expect(isolated('a\u202eb\u2069\u2067c')).toBe('\u2068abc\u2069');
});
