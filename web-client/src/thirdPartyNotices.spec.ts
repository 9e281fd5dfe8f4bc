// Checks that what the page is made of is said beside it, with licences, in a build that is there.
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { thirdPartyNotices } from '../tools/third_party_notices.ts';

const fromRoot = (path: string): string => fileURLToPath(new URL(`../${path}`, import.meta.url));
const built = fromRoot('dist/third-party-notices.txt');

interface LockedPackage {
    version: string;
    license: string;
    dependencies?: Record<string, string>;
}

/** What is said in each of the licences that the packages have. */
const licenceWords = /Permission is hereby granted|Redistribution and use|TERMS AND CONDITIONS FOR USE|Mozilla Public License/;

/** Types leave no code behind, and lit's stand-in for a DOM is for servers. */
const notInBrowsers = /^@types\/|^@lit-labs\/ssr-dom-shim$/;

/** Returns what package.json names for the page, and what that needs. */
function packagesOfThePage(): Map<string, LockedPackage> {
    const lock = JSON.parse(readFileSync(fromRoot('package-lock.json'), 'utf8')) as { packages: Record<string, LockedPackage> };
    const found = new Map<string, LockedPackage>();
    const follow = (names: readonly string[]): void => {
        for (const name of names) {
            const locked = lock.packages[`node_modules/${name}`];
            if (locked === undefined || found.has(name) || notInBrowsers.test(name)) continue;
            found.set(name, locked);
            follow(Object.keys(locked.dependencies ?? {}));
        }
    };
    follow(Object.keys(lock.packages['']!.dependencies!));
    return found;
}

describe.skipIf(!existsSync(built))('the notices beside the page', () => {
    it('name each package that is in it, with its version and the words of its licence', () => {
        const sections = readFileSync(built, 'utf8')
            .split(/^={80}\n/m)
            .slice(1);
        const packages = packagesOfThePage();
        expect(packages.size).toBeGreaterThan(5);
        expect(sections.map((text) => text.split(' ')[0]).sort()).toEqual([...packages.keys()].sort());
        for (const [name, { version, license }] of packages) {
            const section = sections.find((text) => text.startsWith(`${name} ${version}, ${license}\n`));
            expect(section, name).toContain(`\nSource: https://www.npmjs.com/package/${name}/v/${version}\n`);
            expect(section, name).toMatch(licenceWords);
        }
    });
});

describe('a build', () => {
    it('fails where a package has no licence that could be handed on', () => {
        const folder = mkdtempSync(join(tmpdir(), 'wakesurf-'));
        const of = join(folder, 'node_modules/nameless');
        mkdirSync(of, { recursive: true });
        writeFileSync(join(of, 'package.json'), JSON.stringify({ name: 'nameless', version: '1.0.0', license: 'UNLICENSED' }));
        const generate = thirdPartyNotices().page.generateBundle as (this: object, options: object, bundle: object) => void;
        const emitted: string[] = [];
        const build = (): void =>
            generate.call(
                { emitFile: ({ source }: { source: string }) => emitted.push(source) },
                {},
                {
                    'a.js': { type: 'chunk', moduleIds: [join(of, 'index.js')] },
                },
            );
        expect(build).toThrow(/nameless has no licence file/);
        writeFileSync(join(of, 'LICENSE.md'), 'Do what you like.');
        build();
        expect(emitted[0]).toMatch(/nameless 1\.0\.0, UNLICENSED\nSource: \S+\n\nDo what you like\./);
        rmSync(folder, { recursive: true });
    });
});
