// The build: relative URLs throughout, so that the page also works behind a proxy with a prefix.
import { defineConfig } from 'vite';

export default defineConfig({
    base: './',
    build: {
        target: 'es2022',
        outDir: 'dist',
        assetsInlineLimit: 0,
        modulePreload: { polyfill: false },
        chunkSizeWarningLimit: 900,
    },
    worker: { format: 'es' },
});
