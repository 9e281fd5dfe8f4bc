// The test rig itself: a test fails when its page complains, whatever else the test looks at.
import type { Page } from 'playwright-core';
import { beforeAll, expect, it } from 'vitest';
import { expectComplaint, takeComplaints } from './support/complaints.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 400, height: 300 });
});

const complaints: Record<string, (page: Page) => Promise<unknown>> = {
    'throws an error that nothing catches': async (page) =>
        Promise.all([
            page.context().waitForEvent('weberror'),
            page.evaluate(() => {
                setTimeout(() => {
                    throw new Error('made by the test');
                });
            }),
        ]),
    'leaves a rejection unhandled': async (page) =>
        Promise.all([
            page.context().waitForEvent('weberror'),
            page.evaluate(() => void Promise.reject(new Error('made by the test'))),
        ]),
    'writes an error to the console': async (page) =>
        Promise.all([page.waitForEvent('console'), page.evaluate(() => console.error('made by the test'))]),
    'throws in its worker': async (page) =>
        Promise.all([
            page.context().waitForEvent('weberror'),
            page.workers()[0]!.evaluate(() => {
                setTimeout(() => {
                    throw new Error('made by the test');
                });
            }),
        ]),
};

it('whatever a page complains of is heard, and allowed to in a test that expects it', async () => {
    for (const [what, complain] of Object.entries(complaints)) {
        await complain(page);
        expect(takeComplaints(), what).toEqual([expect.stringContaining('made by the test')]);
        expectComplaint(/made by the test/);
        await complain(page);
        expect(takeComplaints(), what).toEqual([]);
    }
});

it.fails('a test fails in which a page complains', { retry: 0 }, async () => {
    await complaints['writes an error to the console']!(page);
});

it.fails('a test that expects a complaint fails without one', { retry: 0 }, () => {
    expectComplaint(/made by the test/);
});

it('only the complaint that is expected is allowed', async () => {
    expectComplaint(/of another kind/);
    await complaints['writes an error to the console']!(page);
    const found = takeComplaints();
    expect(found).toHaveLength(2);
    expect(found[0]).toContain('made by the test');
    expect(found[1]).toBe('no page complained: /of another kind/');
});
