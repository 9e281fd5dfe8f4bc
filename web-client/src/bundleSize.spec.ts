// The page must load quickly on a slow line: what the last build weighs, as a server would send it.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';

const dist = fileURLToPath(new URL('../dist/', import.meta.url));
const built = existsSync(dist + 'index.html');
const assets = built ? readdirSync(`${dist}assets`) : [];

const text = (file: string): string => readFileSync(dist + file, 'utf8');

/** Returns what the page names, and what that names, other than by `import()` and in the list of what such imports need: this
 *  is fetched before anything is shown. */
function loadedAtStart(): string[] {
    const found: string[] = [];
    const follow = (source: string): void => {
        const now = source.replace(/import\([`'"]\.\/[^)]*\)|m\.f=\[[^\]]*\]/g, '');
        for (const name of assets.filter((each) => now.includes(each))) {
            // Perhaps by what another one names.
            if (found.includes(name)) continue;
            found.push(name);
            if (name.endsWith('.js')) follow(text(`assets/${name}`));
        }
    };
    follow(text('index.html'));
    return found;
}

function gzippedKilobytes(names: string[], extension: string): number {
    const files = names.filter((name) => name.endsWith(extension));
    return files.reduce((sum, name) => sum + gzipSync(readFileSync(`${dist}assets/${name}`)).length, 0) / 1000;
}

describe.skipIf(!built)('the bundle', () => {
    it('stays within its budget at the start, and in all', () => {
        const start = loadedAtStart();
        expect(start.length).toBeLessThan(assets.length);
        expect(gzippedKilobytes(start, '.js')).toBeLessThan(330);
        expect(gzippedKilobytes(start, '.js')).toBeGreaterThan(250);
        // With what is loaded later: curved cells, bodies, films as WebM and MP4, numbers, comparing, slices, streamlines, means and plots with their library.
        expect(gzippedKilobytes(assets, '.js')).toBeLessThan(460);
        expect(gzippedKilobytes(assets, '.wasm')).toBeLessThan(85);
    });

    it('refers to nothing outside the server', () => {
        const page = text('index.html');
        expect(page).not.toMatch(/https?:\/\//);
        expect(page).not.toMatch(/(src|href)="\//);
    });
});
