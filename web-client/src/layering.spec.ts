// Keeps the rooms apart: what draws knows no connection, what speaks the protocol knows nothing else.
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const forbidden: Record<string, RegExp> = {
    protocol: /from '\.\.\//,
    connection: /from '\.\.\/(scene|session|state|ui|worker)\//,
    scene: /from '\.\.\/(connection|session|state|ui|worker)\//,
    state: /from '\.\.\/(scene|session|ui|worker)\//,
    worker: /from '\.\.\/(scene|session|state|ui)\//,
    session: /from '\.\.\/ui\//,
};

describe('imports', () => {
    it.each(Object.entries(forbidden))('of %s/ stay within its rooms', (room, pattern) => {
        const folder = fileURLToPath(new URL(`./${room}/`, import.meta.url));
        const files = readdirSync(folder).filter((name) => /(?<!\.spec)\.ts$/.test(name));
        expect(files.length).toBeGreaterThan(0);
        for (const name of files) {
            const wrong = readFileSync(folder + name, 'utf8')
                .split('\n')
                .filter((line) => pattern.test(line));
            expect(wrong, name).toEqual([]);
        }
    });

    it('never build markup from text', () => {
        const root = fileURLToPath(new URL('./', import.meta.url));
        const files = readdirSync(root, { recursive: true, encoding: 'utf8' });
        for (const name of files.filter((file) => /(?<!\.spec)\.ts$/.test(file))) {
            const text = readFileSync(root + name, 'utf8');
            expect(text, name).not.toMatch(/innerHTML|insertAdjacentHTML|unsafeHTML/);
        }
    });
});
