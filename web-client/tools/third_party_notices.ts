// Writes the licences of all packages whose code is in the build into one file beside the page. Vite's own `build.license` does not
// look into workers, and has no text for a package that comes without a licence file, as draco3d does.
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Plugin, Rollup } from 'vite';

export const noticesFile = 'third-party-notices.txt';

const header = `This page contains the packages below. Each has a licence of its own, which follows its name.
The licence of wakesurf itself is in the file LICENSE of its sources.
`;

export interface ThirdPartyNotices {
    /** For the build of the page, which ends after those of its workers. */
    page: Plugin;
    /** For the builds of its workers. */
    worker: () => Plugin[];
}

export function thirdPartyNotices(): ThirdPartyNotices {
    const folders = new Set<string>();
    const collect = (bundle: Rollup.OutputBundle): void => {
        for (const part of Object.values(bundle)) {
            if (part.type === 'chunk') for (const folder of part.moduleIds.flatMap(packageFolder)) folders.add(folder);
        }
    };
    return {
        page: {
            name: 'third-party-notices',
            apply: 'build',
            generateBundle(_, bundle) {
                collect(bundle);
                const source = header + [...folders].sort().map(noticeOf).join('');
                this.emitFile({ type: 'asset', fileName: noticesFile, source });
            },
        },
        worker: () => [{ name: 'third-party-packages', apply: 'build', generateBundle: (_, bundle) => collect(bundle) }],
    };
}

/** Of a module; none where it is our own. A package inside another one's folder is itself, not the other. */
function packageFolder(module: string): string[] {
    const found = /^\0?(.*[\\/]node_modules[\\/](?:@[^\\/]+[\\/])?[^\\/]+)[\\/]/.exec(module);
    return found === null ? [] : [found[1]!];
}

function noticeOf(folder: string): string {
    const { name, version, license, author } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8')) as Record<
        string,
        unknown
    >;
    const by = typeof author === 'string' ? `\nBy ${author}` : '';
    const title = `${String(name)} ${String(version)}, ${String(license)}${by}`;
    // Some licences (MPL-2.0) ask for the place of the sources.
    const source = `Source: https://www.npmjs.com/package/${String(name)}/v/${String(version)}`;
    return `\n${'='.repeat(80)}\n${title}\n${source}\n\n${licenceText(folder, String(license))}\n`;
}

/** Error: where neither the package nor the list of known licences has it, so that no build goes out without. */
function licenceText(folder: string, license: string): string {
    const file = readdirSync(folder).find((name) => /^(licen[cs]e|copying)(\.\w+)?$/i.test(name));
    if (file !== undefined) return readFileSync(join(folder, file), 'utf8').trim();
    const known = new URL(`../node_modules/spdx-license-list/licenses/${license}.json`, import.meta.url);
    if (!existsSync(known)) throw new Error(`${folder} has no licence file, and ${license} is no licence whose words are known`);
    return (JSON.parse(readFileSync(known, 'utf8')) as { licenseText: string }).licenseText.trim();
}
