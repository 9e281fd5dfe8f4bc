// @vitest-environment happy-dom
import { html, render } from 'lit';
import { expect, it } from 'vitest';
import { typedValue } from './typedValue.ts';

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
