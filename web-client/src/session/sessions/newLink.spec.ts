import { describe, expect, it } from 'vitest';
import { readNewLink } from './newLink.ts';

const token = '0123456789abcdef'.repeat(4);
const read = (text: string): unknown => readNewLink(text, 'session-3');

describe('a link that is pasted', () => {
    it('lets the page in where it leads here, also as the server prints it or as a token alone', () => {
        const wanted = { to: 'here', token };
        expect(read(`http://127.0.0.1:8080/flow/#token=${token}`)).toEqual(wanted);
        expect(read(` wakesurf: http://127.0.0.1:8080/flow/#token=${token}\n`)).toEqual(wanted);
        expect(read(`http://127.0.0.1:8080/flow/#session=session-3&token=${token}`)).toEqual(wanted);
        expect(read(token)).toEqual(wanted);
        // A tunnel to another port, or a prefix that the server does not know of.
        for (const address of ['http://127.0.0.1:8081/flow/', 'http://127.0.0.1:8080/', 'https://node7.lab:8443/']) {
            expect(read(`${address}#token=${token}`)).toEqual(wanted);
        }
    });

    it('opens another session', () => {
        const fragment = `#session=session-4&token=${token}`;
        expect(read(`http://127.0.0.1:8080/flow/${fragment}`)).toEqual({ to: 'session', fragment });
    });

    it('is none without a token, or where it is not of the web', () => {
        const texts = ['', 'hello', 'http://127.0.0.1:8080/flow/', `javascript:alert(1)#token=${token}`, `${token} ${token}`];
        for (const text of texts) expect(read(text), text).toBeNull();
    });
});
