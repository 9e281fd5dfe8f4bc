// The viewer of animations as one file without data, animation.html: `wakesurf surface -o FILE.html` puts a description and frames
// into it. Everything is inline, and the page's own policy allows this script and this style alone, and no request.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { build, type Plugin, type UserConfig } from 'vite';
import { noticesFile, thirdPartyNotices } from './third_party_notices.ts';

const folder = fileURLToPath(new URL('../src/animation/', import.meta.url));

function hashOf(text: string): string {
    return `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
}

/** Builds it with these settings, those of the page. */
export function animationPage({ resolve, plugins }: Pick<UserConfig, 'resolve' | 'plugins'>): Plugin {
    return {
        name: 'animation-page',
        apply: 'build',
        async generateBundle() {
            const built = await build({
                configFile: false,
                publicDir: false,
                logLevel: 'warn',
                resolve: resolve!,
                plugins: [plugins, thirdPartyNotices().page],
                build: {
                    target: 'es2022',
                    write: false,
                    modulePreload: false,
                    lib: { entry: `${folder}animationPage.ts`, formats: ['iife'], name: 'wakesurfAnimationPage' },
                },
            });
            const outputs = (Array.isArray(built) ? built : [built]).flatMap((each) => ('output' in each ? each.output : []));
            const code = outputs.flatMap((each) => (each.type === 'chunk' ? [each.code] : []));
            const notices = outputs.find((each) => each.type === 'asset' && each.fileName === noticesFile);
            if (code.length !== 1 || notices?.type !== 'asset') throw new Error('the animation page is not one script');
            // What would end the script, or begin a comment in it.
            const script = code[0]!.replace(/<\/(script)/gi, '<\\/$1').replaceAll('<!--', '<\\!--');
            const style = readFileSync(`${folder}animation.css`, 'utf8').replace(/\s*\n\s*/g, '');
            const parts: Record<string, string> = {
                policy: `default-src 'none'; script-src ${hashOf(script)} 'wasm-unsafe-eval'; style-src ${hashOf(style)}; base-uri 'none'; form-action 'none'`,
                notices: String(notices.source).replaceAll('<', '‹'),
                script,
                style,
            };
            const page = readFileSync(`${folder}animation.html`, 'utf8').replace(
                /\s*\{\{(\w+)\}\}\s*/g, // space round a script would change its hash
                (_, name: string) => parts[name]!,
            );
            this.emitFile({ type: 'asset', fileName: 'animation.html', source: page });
        },
    };
}
