// Tells of each test that failed and then passed what it said the first time; its name is a line of the file WAKESURF_UNSTABLE too.
import { appendFileSync } from 'node:fs';
import type { Plugin } from 'vite';
import type { Reporter, TestCase } from 'vitest/node';

const reporter: Reporter = {
    onTestCaseResult(test: TestCase): void {
        // One that is to fail has done so each time.
        if (test.diagnostic()?.flaky !== true || test.options.fails === true) return;
        const errors = test.result().errors ?? [];
        console.log(`unstable: ${test.fullName}`, ...errors.map(({ stack, message }) => `\n${stack ?? message}`));
        const file = process.env['WAKESURF_UNSTABLE'];
        if (file !== undefined) appendFileSync(file, `${test.fullName}\n`);
    },
};

/** Beside whatever reporters the command line asks for, which take the place of those of a configuration. */
export function unstableTests(): Plugin {
    return {
        name: 'unstable-tests',
        configureVitest({ vitest }) {
            const { reporters } = vitest.config;
            if (!reporters.includes(reporter)) reporters.push(reporter);
        },
    };
}
