// What pages complain about: uncaught errors, rejections that nothing handles and errors in the console, of every page and worker
// of every browser that a test launches. support/setup.ts fails the test in which one is heard.
import type { Browser, BrowserContext } from 'playwright-core';

const heard: string[] = [];
const expected: RegExp[] = [];
const allowed: RegExp[] = [];

/** Beside the tests, so that the run fails also where the test passes when it is run once more. */
function crashed(url: string): void {
    heard.push(`The page ${url} crashed.`);
    setTimeout(() => {
        throw new Error(`The page ${url} crashed.`);
    });
}

function hear(context: BrowserContext): void {
    context.on('weberror', (event) => {
        const error = event.error();
        heard.push(error.stack ?? String(error));
    });
    context.on('console', (message) => {
        if (message.type() === 'error') heard.push(`${message.text()} (${message.location().url})`);
    });
    context.on('page', (page) => page.on('crash', () => crashed(page.url())));
}

/** To be called before the browser has a page. */
export function hearComplaints(browser: Browser): void {
    browser.on('context', hear);
}

/** Until the end of the test, complaints that match are allowed; without one the test fails. */
export function expectComplaint(pattern: RegExp): void {
    expected.push(pattern);
}

/** The same of a complaint that the browser makes or not, as fast as it is. */
function allowComplaint(pattern: RegExp): void {
    allowed.push(pattern);
}

/** For a test that ends connections: the browser says so of each attempt that it makes meanwhile. */
export function allowLostConnections(): void {
    allowComplaint(/net::ERR_(CONNECTION_REFUSED|INTERNET_DISCONNECTED|CONNECTION_RESET|EMPTY_RESPONSE)/);
}

/** What is wrong with the complaints heard since the last call: those that no test expected, and the expected ones that never came. */
export function takeComplaints(): string[] {
    const [complaints, wanted, known] = [heard.splice(0), expected.splice(0), allowed.splice(0)];
    const unexpected = complaints.filter((complaint) => ![...wanted, ...known].some((pattern) => pattern.test(complaint)));
    const missing = wanted.filter((pattern) => !complaints.some((complaint) => pattern.test(complaint)));
    return [...unexpected, ...missing.map((pattern) => `no page complained: ${pattern}`)];
}
