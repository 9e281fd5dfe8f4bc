// Two projects: `unit` beside the sources, `browser` in tests/end_to_end against the real server.
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { resolveFromWebClient } from './tools/resolve_from_web_client.js';

const browserTests = fileURLToPath(new URL('../tests/end_to_end/', import.meta.url));

export default defineConfig({
    test: {
        projects: [
            {
                test: { name: 'unit', include: ['src/**/*.spec.ts'], environment: 'node' },
            },
            {
                plugins: [resolveFromWebClient(browserTests)],
                server: { fs: { strict: false } },
                test: {
                    name: 'browser',
                    dir: browserTests,
                    include: ['**/*.spec.ts'],
                    setupFiles: [`${browserTests}support/setup.ts`],
                    environment: 'node',
                    // All files have one browser (support/test_browser.ts).
                    isolate: false,
                    // One Chromium with software rendering saturates two cores: files run in turn.
                    fileParallelism: false,
                    testTimeout: 60_000,
                    hookTimeout: 120_000,
                    expect: { poll: { timeout: 15_000 } },
                },
            },
        ],
    },
});
