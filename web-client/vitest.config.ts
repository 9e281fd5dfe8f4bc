// Three projects: `unit` beside the sources; `browser` and `timing` in tests/end_to_end against the real server. What takes how long by
// the clock is in `timing`, which ./check runs when nothing else runs.
import { fileURLToPath } from 'node:url';
import { defineConfig, type TestProjectInlineConfiguration } from 'vitest/config';
import { resolveFromWebClient } from './tools/resolve_from_web_client.js';
import { unstableTests } from './tools/unstable_tests.ts';

const browserTests = fileURLToPath(new URL('../tests/end_to_end/', import.meta.url));
const timingTests = '**/*.timing.spec.ts';

function inBrowser(name: string, files: { include: string[]; exclude?: string[] }): TestProjectInlineConfiguration {
    return {
        plugins: [resolveFromWebClient(browserTests), unstableTests()],
        server: { fs: { strict: false } },
        test: {
            name,
            dir: browserTests,
            ...files,
            setupFiles: [`${browserTests}support/setup.ts`],
            environment: 'node',
            // All files have one browser (support/test_browser.ts).
            isolate: false,
            // One Chromium with software rendering saturates two cores: files run in turn.
            fileParallelism: false,
            // What passes then is named, see tools/unstable_tests.ts.
            retry: 1,
            testTimeout: 60_000,
            hookTimeout: 120_000,
            expect: { poll: { timeout: 15_000 } },
        },
    };
}

export default defineConfig({
    test: {
        projects: [
            {
                test: { name: 'unit', include: ['src/**/*.spec.ts'], environment: 'node' },
            },
            inBrowser('browser', { include: ['**/*.spec.ts'], exclude: [timingTests] }),
            inBrowser('timing', { include: [timingTests] }),
        ],
    },
});
