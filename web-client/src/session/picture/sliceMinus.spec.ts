// What a slice subtracts, from a record and back, and in words.
import { expect, it } from 'vitest';
import { FieldColours } from './fieldColours.ts';
import { membersOf, minusOf, minusWish } from './sliceMinus.ts';
import { pathOf, type SliceWish } from './sliceValues.ts';

it.each([
    [{}, null],
    [{ minus: 'b' }, { dataset: 'b', time: { kind: 'same' } }],
    [{ minusOffset: -0.5 }, { dataset: null, time: { kind: 'offset', by: -0.5 } }],
    [
        { minus: 'b', minusTime: 2 },
        { dataset: 'b', time: { kind: 'at', time: 2 } },
    ],
] as const)('is the same in a record and on the page: %j', (members, minus) => {
    expect(minusOf(members)).toEqual(minus);
    expect(membersOf(minusOf(members))).toEqual(members);
});

it('is asked for with its time, and named', () => {
    const nameOf = (id: string): string => `case ${id}`;
    const place: SliceWish = { dataset: 'a', origin: [0, 0, 0], normal: [0, 0, 1], field: 'p', time: 3 };
    const wished = (members: object): [string, string] => {
        const minus = minusWish(minusOf(members)!, 'a', 3, nameOf);
        const query = new URL(pathOf({ ...place, minus }, 8), 'http://h').searchParams;
        return [`${query.get('minus')} ${query.get('minusTime')}`, minus.words];
    };
    expect(wished({ minus: 'b' })).toEqual(['b 3', 'minus that of case b']);
    expect(wished({ minusOffset: -0.5 })).toEqual(['a 2.5', 'minus that 0.5 earlier']);
    expect(wished({ minus: 'b', minusTime: 1 })).toEqual(['b 1', 'minus that of case b at t = 1']);
});

it('has colours of its own, the same about 0 whichever signs there are', () => {
    const colours = new FieldColours();
    colours.show('c1', 'p', [3, 8]);
    colours.show('c2', 'p', [0.1, 0.4], 'minus that of b');
    expect(colours.meanings.value.get('c1')).toMatchObject({ map: 'viridis', range: [3, 8] });
    expect(colours.meanings.value.get('c2')).toMatchObject({ map: 'coolToWarm', range: [-0.4, 0.4] });
    colours.show('c3', 'p', [0, 0], 'minus itself');
    expect(colours.meanings.value.get('c3')!.range, 'there is a scale where all is 0').toEqual([-1, 1]);
});
