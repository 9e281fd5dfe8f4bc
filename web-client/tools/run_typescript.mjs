// Bundles one TypeScript file with its own imports and runs it, on any node that Vite runs on. Packages stay
// outside the bundle, which therefore lies where they are found: under web-client/node_modules.
import { rmSync } from 'node:fs';
import { basename, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';

const file = process.argv[2];
if (file === undefined) {
    console.error('usage: node tools/run_typescript.mjs FILE.ts');
    process.exit(2);
}
const outDir = fileURLToPath(new URL('../node_modules/.cache/run_typescript/', import.meta.url));
const entryFileNames = `${basename(file, '.ts')}.${process.pid}.mjs`;
await build({
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    build: {
        outDir,
        emptyOutDir: false,
        target: 'es2022',
        minify: false,
        ssr: resolve(file),
        rollupOptions: { external: /^[@a-z]/i, output: { entryFileNames } },
    },
});
try {
    await import(pathToFileURL(outDir + entryFileNames).href);
} finally {
    rmSync(outDir + entryFileNames);
}
