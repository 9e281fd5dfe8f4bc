// Checks that all that is made from the description of the API is used.
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { expect, test } from 'vitest';

const root = fileURLToPath(new URL('../', import.meta.url));
const sources = readdirSync(root, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts') && !name.endsWith('.spec.ts') && !/(^|\/)testing\//.test(name))
    .map((name) => ({ name, text: readFileSync(root + name, 'utf8') }));

test('every type, list, check and table that is generated is used by the page', () => {
    const words = sources.flatMap(({ text }) => text.match(/\w+/g) ?? []);
    const uses = new Map<string, number>();
    for (const word of words) uses.set(word, (uses.get(word) ?? 0) + 1);
    const generated = sources.filter(({ name }) => name.startsWith('protocol/generated/'));
    const exported = generated.flatMap(({ text }) => [...text.matchAll(/^export (?:const|type|interface) (\w+)/gm)]);
    expect(exported.length).toBeGreaterThan(100);
    // Once where it is declared.
    expect(exported.map(([, name]) => name!).filter((name) => uses.get(name) === 1)).toEqual([]);
});
