import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { emptyStorage } from '../testing/keptTexts.ts';
import { KeptLogins } from './keptLogins.ts';

describe('the logins of a browser', () => {
    beforeEach(() => emptyStorage('localStorage', 'sessionStorage'));
    afterEach(() => void vi.unstubAllGlobals());

    it('lead from a session into a copy of it and back, in one window', () => {
        const kept = new KeptLogins('http://localhost/');
        const [link, copy] = [
            { login: 'a.1', session: 'main' },
            { login: 'b.1', session: 'session-2' },
        ];
        kept.keep(link);
        kept.keep(copy);
        expect(kept.recall('session-2')).toEqual(copy);
        expect(kept.recall('main')).toEqual(link);
        expect(kept.recall(null)).toEqual(copy);
        kept.drop('a.1');
        expect(kept.recall('main'), 'the server says what it is not good for').toEqual(copy);
    });

    it('let a window that came by a link be what the link allows, beside one that has the token', () => {
        const kept = new KeptLogins('http://localhost/');
        kept.keep({ login: 'token.1', session: null });
        emptyStorage('sessionStorage');
        const link = { login: 'a.1', session: 'main' };
        kept.keep(link);
        expect(kept.recall('main')).toEqual(link);
        emptyStorage('sessionStorage');
        expect(kept.recall('main')?.session, 'another window').toBeNull();
    });
});
