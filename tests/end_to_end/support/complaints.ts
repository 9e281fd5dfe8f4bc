// What pages complain about: uncaught errors, rejections that nothing handles and errors in the console, of every page and worker
// of every browser that a test launches. support/setup.ts fails the test in which one is heard.
import type { Browser, BrowserContext } from 'playwright-core';

const heard: string[] = [];
const expected: RegExp[] = [];

function hear(context: BrowserContext): void {
    context.on('weberror', (event) => {
        const error = event.error();
        heard.push(error.stack ?? String(error));
    });
    context.on('console', (message) => {
        if (message.type() === 'error') heard.push(`${message.text()} (${message.location().url})`);
    });
    context.on('page', (page) => page.on('crash', () => heard.push(`The page ${page.url()} crashed.`)));
}

/** To be called before the browser has a page. */
export function hearComplaints(browser: Browser): void {
    browser.on('context', hear);
}

/** Until the end of the test, complaints that match are allowed; without one the test fails. */
export function expectComplaint(pattern: RegExp): void {
    expected.push(pattern);
}

/** What is wrong with the complaints heard since the last call: those that no test expected, and the expected ones that never came. */
export function takeComplaints(): string[] {
    const [complaints, patterns] = [heard.splice(0), expected.splice(0)];
    const unexpected = complaints.filter((complaint) => !patterns.some((pattern) => pattern.test(complaint)));
    const missing = patterns.filter((pattern) => !complaints.some((complaint) => pattern.test(complaint)));
    return [...unexpected, ...missing.map((pattern) => `no page complained: ${pattern}`)];
}
