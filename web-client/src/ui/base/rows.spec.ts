// @vitest-environment happy-dom
import { html, render } from 'lit';
import { describe, expect, it } from 'vitest';
import { numberField, type NumberField, NumberTyped, pairRow, typedNumber, typedValue, vectorFields } from './rows.ts';

/** Types into the only field, and returns what is taken, what the field shows, and what is said. */
function typed(text: string, field: Partial<NumberField> = {}): { taken: number[]; shown: string; said: (string | null)[] } {
    const taken: number[] = [];
    render(numberField({ shown: '4', change: (value) => void taken.push(value), ...field }), document.body);
    return { taken, ...entered(text) };
}

function entered(text: string, at = 0): { shown: string; said: (string | null)[] } {
    const said: (string | null)[] = [];
    const told = (event: Event): void => void said.push((event as NumberTyped).detail);
    document.body.addEventListener(NumberTyped.type, told);
    const input = document.querySelectorAll('input')[at]!;
    input.value = text;
    input.dispatchEvent(new Event('change'));
    document.body.removeEventListener(NumberTyped.type, told);
    return { shown: input.value, said };
}

describe('a field of a number', () => {
    it('takes a comma for a point, and shows what its panel makes of it', () => {
        expect(typed('0,9')).toEqual({ taken: [0.9], shown: '4', said: [null] });
    });

    it('says what is no number, and what cannot be, and shows what was there before', () => {
        expect(typed('1,234.5')).toMatchObject({ taken: [], shown: '4', said: [expect.stringContaining('is not clear')] });
        expect(typed('x').said).toEqual(['x is not a number.']);
        expect(typed('9', { min: 2, max: 8 })).toMatchObject({ taken: [], shown: '4' });
        expect(typed('9', { min: 2, max: 8 }).said).toEqual(['9 cannot be, only numbers from 2 to 8: it stays at 4.']);
        expect(typed('-1', { change: () => false }).said).toEqual(['-1 cannot be: it stays at 4.']);
    });

    it('that was emptied shows what was there before, and says nothing', () => {
        expect(typed(' ')).toEqual({ taken: [], shown: '4', said: [] });
    });
});

it('both ends of a range, and each part of a vector, take commas', () => {
    const pairs: unknown[] = [];
    render(
        pairRow('range', 'Range', [0, 2], (pair) => pairs.push(pair)),
        document.body,
    );
    entered('0,5', 0);
    entered('1,5', 1);
    expect(entered('9', 0).said).toEqual(['9 cannot be: it stays at 0.']);
    expect(pairs).toEqual([
        [0.5, 2],
        [0, 1.5],
    ]);
    const points: unknown[] = [];
    render(
        vectorFields(
            'Probe',
            [1, 2, 3],
            (_, value) => String(value),
            (point) => void points.push(point),
        ),
        document.body,
    );
    entered('0,5', 1);
    expect(points).toEqual([[1, 0.5, 3]]);
});

it('a field shows what it is given, except while it is typed into', () => {
    const shown = (value: string): string => {
        render(html`<input .value=${typedValue(value)} />`, document.body);
        return field().value;
    };
    const field = (): HTMLInputElement => document.querySelector('input')!;
    expect(shown('685')).toBe('685');
    field().focus();
    expect(shown('700')).toBe('700');
    field().value = '40';
    expect(shown('700')).toBe('40');
    expect(shown('800')).toBe('40');
    // As it is once the edit has been taken, still in the field.
    field().value = '400';
    expect(shown('400')).toBe('400');
    expect(shown('16')).toBe('16');
    field().value = '9';
    field().blur();
    expect(shown('16')).toBe('16');
});

describe('a number that is typed', () => {
    it.each([
        ['0,9', 0.9],
        ['0.9', 0.9],
        ['-1,25', -1.25],
        ['\u22121.25', -1.25],
        ['- 3', -3],
        ['+2', 2],
        [',5', 0.5],
        ['5.', 5],
        [' 12 ', 12],
        ['1 234 567,5', 1234567.5],
        ['1\u00a0234', 1234],
        ['12\u202f345.5', 12345.5],
        ['1e-3', 0.001],
        ['1,5E3', 1500],
        ['2.5 e+2', 250],
        ['0', 0],
    ])('may be written %s', (text, value) => {
        expect(typedNumber(text)).toBe(value);
    });

    it.each(['1,234.5', '1.234,5', '1,234,567', '1.234.567'])('is refused in words where %s may mean two', (text) => {
        expect(typedNumber(text)).toBe(`${text} is not clear: write the number with one comma or point, before its decimals.`);
    });

    it.each(['abc', '1 2', '12 34', '1e', '--1', '0x10', 'Infinity', '1e999', '.', ',', '-', '1;5', '3 m'])(
        'is refused in words where %s is none',
        (text) => {
            expect(typedNumber(text)).toBe(`${text} is not a number.`);
        },
    );

    it('is none yet in an empty field', () => {
        expect([typedNumber(''), typedNumber('  ')]).toEqual([null, null]);
    });
});
