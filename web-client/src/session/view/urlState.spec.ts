import { describe, expect, it } from 'vitest';
import { readFragment, writeFragment } from './urlState.ts';

describe('the fragment of the link', () => {
    it('carries token, session and dataset in', () => {
        expect(readFragment('#token=ab-_c&session=x')).toEqual({
            token: 'ab-_c',
            session: 'x',
            dataset: null,
            state: null,
        });
        expect(readFragment('')).toEqual({ token: null, session: null, dataset: null, state: null });
    });

    it('comes back without a token', () => {
        const { session, dataset } = readFragment('#token=secret&session=a%20b&dataset=d');
        const fragment = writeFragment(session, dataset);
        expect(fragment).not.toContain('secret');
        expect(readFragment(fragment)).toEqual({ token: null, session: 'a b', dataset: 'd', state: null });
        expect(writeFragment(null, null)).toBe('');
    });
});
