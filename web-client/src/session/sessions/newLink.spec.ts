import { describe, expect, it } from 'vitest';
import { readNewLink } from './newLink.ts';

const here = { base: 'http://127.0.0.1:8080/flow/', session: 'session-3' };
const token = '0123456789abcdef'.repeat(4);
const read = (text: string): unknown => readNewLink(text, here);

describe('a link that is pasted', () => {
    it('lets the page in where it leads here, also as the server prints it or as a token alone', () => {
        const wanted = { to: 'here', token };
        expect(read(`http://127.0.0.1:8080/flow/#token=${token}`)).toEqual(wanted);
        expect(read(` wakesurf: http://127.0.0.1:8080/flow/#token=${token}\n`)).toEqual(wanted);
        expect(read(`http://127.0.0.1:8080/flow/#session=session-3&token=${token}`)).toEqual(wanted);
        expect(read(token)).toEqual(wanted);
    });

    it('opens another session or address', () => {
        const fragment = `#session=session-4&token=${token}`;
        expect(read(`http://127.0.0.1:8080/flow/${fragment}`)).toEqual({ to: 'session', fragment });
        for (const address of [`http://127.0.0.1:8081/flow/#token=${token}`, `http://127.0.0.1:8080/#token=${token}`]) {
            expect(read(address)).toEqual({ to: 'elsewhere', address });
        }
    });

    it('is none without a token, or where it is not of the web', () => {
        const texts = ['', 'hello', 'http://127.0.0.1:8080/flow/', `javascript:alert(1)#token=${token}`, `${token} ${token}`];
        for (const text of texts) expect(read(text), text).toBeNull();
    });
});
