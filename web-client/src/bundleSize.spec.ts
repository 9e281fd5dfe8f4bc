// The page must load quickly on a slow line: what the last build weighs, as a server would send it.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { describe, expect, it } from 'vitest';

const assets = fileURLToPath(new URL('../dist/assets/', import.meta.url));

/** Loaded when first needed. */
const later = /^(curvedCells|obstacle|webm)-/;

function gzippedKilobytes(extension: string): number {
    const files = readdirSync(assets).filter((name) => name.endsWith(extension) && !later.test(name));
    return files.reduce((sum, name) => sum + gzipSync(readFileSync(assets + name)).length, 0) / 1000;
}

describe.skipIf(!existsSync(assets))('the bundle', () => {
    it('stays within its budget', () => {
        expect(gzippedKilobytes('.js')).toBeLessThan(310);
        expect(gzippedKilobytes('.js')).toBeGreaterThan(50);
        expect(gzippedKilobytes('.wasm')).toBeLessThan(85);
    });

    it('refers to nothing outside the server', () => {
        const page = readFileSync(`${assets}../index.html`, 'utf8');
        expect(page).not.toMatch(/https?:\/\//);
        expect(page).not.toMatch(/(src|href)="\//);
    });
});
