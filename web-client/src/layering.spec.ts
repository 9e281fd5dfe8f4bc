// Keeps the rooms apart: what draws knows no connection, what speaks the protocol knows nothing else.
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const root = fileURLToPath(new URL('./', import.meta.url));

const allowed: Record<string, readonly string[]> = {
    protocol: [],
    connection: ['protocol'],
    scene: ['protocol'],
    state: ['protocol', 'connection'],
    worker: ['protocol', 'connection'],
    session: ['protocol', 'connection', 'scene', 'state', 'worker'],
    ui: ['protocol', 'connection', 'scene', 'state', 'worker', 'session'],
};

function sourcesOf(folder: string): string[] {
    const files = readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' });
    return files.filter((name) => /(?<!\.spec)\.ts$/.test(name)).map((name) => join(root, folder, name));
}

/** The room that an import of a file leads to; null for one of a library. */
function roomOf(file: string, imported: string): string | null {
    if (!imported.startsWith('.')) return null;
    return relative(root, join(dirname(file), imported)).split('/')[0] ?? null;
}

describe('imports', () => {
    it.each(Object.entries(allowed))('of %s/ stay within its rooms', (room, rooms) => {
        const files = sourcesOf(room);
        expect(files.length).toBeGreaterThan(0);
        for (const file of files) {
            const imports = [...readFileSync(file, 'utf8').matchAll(/(?:from|import) '([^']+)'/g)];
            const led = imports.map(([, imported]) => roomOf(file, imported!));
            const wrong = led.filter((to) => to !== null && to !== room && !rooms.includes(to));
            expect(wrong, relative(root, file)).toEqual([]);
        }
    });

    it('never build markup from text', () => {
        for (const file of sourcesOf('.')) {
            const text = readFileSync(file, 'utf8');
            expect(text, relative(root, file)).not.toMatch(/innerHTML|insertAdjacentHTML|unsafeHTML/);
        }
    });
});
