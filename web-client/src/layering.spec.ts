// Keeps the rooms apart: what draws knows no connection, what speaks the protocol knows nothing else.
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';

const root = fileURLToPath(new URL('./', import.meta.url));

const allowed: Record<string, readonly string[]> = {
    mesh: [],
    protocol: [],
    connection: ['protocol'],
    scene: ['mesh', 'protocol'],
    state: ['mesh', 'protocol', 'connection'],
    worker: ['mesh', 'protocol', 'connection'],
    animation: ['mesh', 'protocol', 'scene', 'worker'],
    session: ['mesh', 'protocol', 'connection', 'scene', 'state', 'worker'],
    ui: ['mesh', 'protocol', 'connection', 'scene', 'state', 'worker', 'session'],
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

/** The folder of a room that a file is in; the room itself is '.'. */
function folderOf(room: string, file: string): string {
    return dirname(relative(join(root, room), file)).split('/')[0]!;
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

    it.each(['scene', 'session', 'ui'])('between the folders of %s/ go one way', (room) => {
        const leadsTo = new Map<string, Set<string>>();
        for (const file of sourcesOf(room)) {
            const from = folderOf(room, file);
            for (const [, imported] of readFileSync(file, 'utf8').matchAll(/(?:from|import) '(\.[^']+)'/g)) {
                const to = join(dirname(file), imported!);
                if (roomOf(file, imported!) !== room || folderOf(room, to) === from) continue;
                leadsTo.set(from, (leadsTo.get(from) ?? new Set()).add(folderOf(room, to)));
            }
        }
        const ends = new Set<string>();
        const follow = (folder: string, way: readonly string[]): void => {
            expect(way, [...way, folder].join(' → ')).not.toContain(folder);
            if (ends.has(folder)) return;
            for (const next of leadsTo.get(folder) ?? []) follow(next, [...way, folder]);
            ends.add(folder);
        };
        expect(leadsTo.size).toBeGreaterThan(3);
        for (const folder of leadsTo.keys()) follow(folder, []);
    });

    // Of types alone as well: a circle is read as a whole or not at all.
    it.each(Object.keys(allowed).filter((room) => room !== 'protocol'))('between the files of %s/ lead in no circle', (room) => {
        const done = new Set<string>();
        const follow = (file: string, way: readonly string[]): void => {
            expect(way, [...way, file].map((each) => relative(root, each)).join(' → ')).not.toContain(file);
            if (done.has(file)) return;
            for (const [, imported] of readFileSync(file, 'utf8').matchAll(/(?:from|import) '(\.[^']+)'/g)) {
                if (roomOf(file, imported!) === room) follow(join(dirname(file), imported!), [...way, file]);
            }
            done.add(file);
        };
        const files = sourcesOf(room);
        for (const file of files) follow(file, []);
        expect(done.size).toBeGreaterThanOrEqual(files.length);
    });

    it('never build markup from text', () => {
        for (const file of sourcesOf('.')) {
            const text = readFileSync(file, 'utf8');
            expect(text, relative(root, file)).not.toMatch(/innerHTML|insertAdjacentHTML|unsafeHTML/);
        }
    });
});
