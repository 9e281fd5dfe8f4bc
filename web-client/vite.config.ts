// The build: relative URLs throughout, so that the page also works behind a proxy with a prefix.
import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { animationPage } from './tools/animation_page.ts';
import { thirdPartyNotices } from './tools/third_party_notices.ts';

const python = fileURLToPath(new URL('../python/', import.meta.url));

/** The client for Python lies beside the page as one file, so that someone who copies a script from it can fetch what the script needs. */
const pythonClient: Plugin = {
    name: 'python-client',
    apply: 'build',
    generateBundle() {
        const modules = readdirSync(`${python}wakesurf`, { recursive: true, encoding: 'utf8' }).filter((name) =>
            name.endsWith('.py'),
        );
        const text = (name: string): string => readFileSync(`${python}wakesurf/${name}`, 'utf8');
        const sources = Object.fromEntries(modules.sort().map((name) => [name.slice(0, -'.py'.length), text(name)]));
        const template = readFileSync(`${python}one_file.py`, 'utf8');
        // What JSON calls an object of strings, Python calls a dictionary.
        const source = template.replace('_SOURCES = {}', () => `_SOURCES = ${JSON.stringify(sources, null, 1)}`);
        this.emitFile({ type: 'asset', fileName: 'wakesurf.py', source });
    },
};

/** Matches the parts of three's shaders that no material of the page has: of physically based, cartoon-like and
 *  glossy ones, of shadows, and of surfaces with bones, bumps, reflections or tone mapping. */
const unusedShaders =
    /^.*\/(?:(?:lights_(?:physical|toon|phong)|transmission|iridescence|clearcoat|cube_uv_reflection|envmap|shadowm\w+|lightprobes|tonemapping|morph\w+|skin\w*|batching|bumpmap|normalmap|alphahash|gradientmap)_\w+)\.glsl\.js$/;

/** The page does not ship comments within the text of its own shaders. */
const shaderComments: Plugin = {
    name: 'shader-comments',
    apply: 'build',
    enforce: 'pre',
    transform: (code, id) => (/\/src\/scene\/.*\.ts$/.test(id) ? code.replace(/^ *(?:\/\/.*|\/\*\*[^]*?\*\/)$/gm, '') : null),
};

/** The page itself is fetched beside its first module, which imports it. */
const fetchPageAtOnce: Plugin = {
    name: 'fetch-page-at-once',
    apply: 'build',
    transformIndexHtml: {
        order: 'post',
        handler: (_html, { bundle = {} }) => {
            const chunks = Object.values(bundle).filter((each) => each.type === 'chunk');
            const page = chunks.find((each) => each.facadeModuleId?.endsWith('/src/main.ts'));
            if (page === undefined) throw new Error('src/main.ts has no chunk of its own');
            return [page.fileName, ...page.imports].map((name) => ({
                tag: 'link',
                attrs: { rel: 'modulepreload', crossorigin: true, href: `./${name}` },
                injectTo: 'head',
            }));
        },
    },
};

const notices = thirdPartyNotices();

const resolve = {
    alias: [
        // Its sources are a module a part; the package's own bundle has all of them.
        { find: /^three$/, replacement: 'three/src/Three.js' },
        { find: unusedShaders, replacement: 'data:text/javascript,export default ""' },
    ],
};

export default defineConfig({
    base: './',
    resolve,
    plugins: [pythonClient, shaderComments, fetchPageAtOnce, notices.page, animationPage({ resolve, plugins: [shaderComments] })],
    build: {
        target: 'es2022',
        outDir: 'dist',
        assetsInlineLimit: 0,
        modulePreload: { polyfill: false },
        chunkSizeWarningLimit: 900,
    },
    worker: { format: 'es', plugins: notices.worker },
});
