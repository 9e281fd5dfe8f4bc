// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { wishOf } from './meansPanel.ts';

const typed = (all: Record<string, string>) => wishOf(['p'], (name) => all[name] ?? '');

it('means take numbers as people type them, leave what is empty to the server, and refuse in words', () => {
    expect(typed({})).toEqual({ fields: ['p'] });
    expect(typed({ from: '8,5', phases: '12', label: ' late ' })).toEqual({
        fields: ['p'],
        from: 8.5,
        phases: 12,
        label: 'late',
    });
    expect(typed({ period: 'two' })).toEqual(expect.stringContaining('two'));
});
