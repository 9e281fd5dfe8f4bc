// Time-steps of which four do not fit into the server's memory: the timeline shows what part of each is there, with the server's numbers.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Browser, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { ResultOf } from '../../web-client/src/protocol/messages.ts';
import { finalSurface, newContext, openPage } from './support/browser_page.ts';
import { projectRoot } from './support/project_root.ts';
import { ServerProcess } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const folder = mkdtempSync(join(tmpdir(), 'wakesurf-parts-'));
const mebi = 2 ** 20;
/** 4 x 4 x 4 bricks of 33 x 33 x 33 nodes. */
const brick = 33 ** 3 * 12;
const whole = 64 * brick;
let server: ServerProcess;
let browser: Browser;
let page: Page;

beforeAll(async () => {
    const binary = process.env['WAKESURF_BINARY'] ?? join(projectRoot, 'build/release/bin/wakesurf');
    const data = join(folder, 'tornado');
    const grid = ['--grid', '129,129,129', '--times', '0:9:4', '--layout', 'bricks'];
    execFileSync(binary, ['generate', 'tornado', data, ...grid], { stdio: 'ignore' });
    server = await ServerProcess.start({ data, store: join(folder, 'store'), memory: '160MiB' });
    await server.imported();
    browser = await testBrowser();
    page = await openPage(await newContext(browser, { width: 900, height: 480 }), await server.streamSession());
    await finalSurface(page);
});

afterAll(async () => {
    await closePages();
    await server?.stop();
    rmSync(folder, { recursive: true, force: true });
});

async function status(): Promise<ResultOf<'cache.status'>> {
    return (await server.call('cache.status', { dataset: 'tornado' })) as unknown as ResultOf<'cache.status'>;
}

/** How much of each mark is filled, 0 to 1. */
function drawn(): Promise<number[]> {
    return page.locator('wakesurf-timeline .mark').evaluateAll((all) =>
        all.map((mark) => {
            const height = (name: string): number => mark.querySelector(name)?.getBoundingClientRect().height ?? 0;
            return height('.filled') / 10;
        }),
    );
}

/** The tooltip of what is under the mouse. */
function pointedAt({ x, y }: { x: number; y: number }): Promise<string | undefined> {
    return page.evaluate(
        ([left, top]) => {
            let found = document.elementFromPoint(left, top);
            for (let inner = found; inner !== null;) {
                found = inner;
                const below: Element | null = inner.shadowRoot?.elementFromPoint(left, top) ?? null;
                inner = below === inner ? null : below;
            }
            return found?.closest('.mark')?.querySelector('title')?.textContent;
        },
        [x, y] as const,
    );
}

const share = (bytes: number): number => (bytes === 0 ? 0 : Math.max(0.15, bytes / whole));

/** "1.5" of "Time-step 2 at 6: 1.5 MiB of 26.32 MiB in memory". */
const mebiIn = (title: string | undefined): number => Number(/: ([\d.]+) MiB of 26\.32 MiB in memory/.exec(title ?? '')?.[1]);

/** What the server has, once the page shows that and nothing is coming any more. */
async function settled(): Promise<number[]> {
    let resident: number[] = [];
    await expect
        .poll(
            async () => {
                const { held, bytesPerStep } = await status();
                expect(bytesPerStep).toBe(whole);
                resident = held.map(([bytes]) => bytes);
                const shown = await drawn();
                const same =
                    shown.length === held.length && shown.every((part, i) => Math.abs(part - share(resident[i]!)) < 0.01);
                return same && held.every(([, loading]) => loading === 0) ? 'settled' : { held, shown };
            },
            { timeout: 30_000, interval: 50 },
        )
        .toBe('settled');
    return resident;
}

/** Reads the bricks that have these points at a stored time. */
async function probe(step: number, points: [number, number, number][]): Promise<void> {
    await server.call('probe.sample', { dataset: 'tornado', points, time: 3 * step });
}

describe('time-steps in parts', () => {
    it('are marked as far as they are in memory, and the mouse tells the bytes', async () => {
        const { bounds } = (await server.call('dataset.describe', {
            dataset: 'tornado',
        })) as unknown as ResultOf<'dataset.describe'>;
        const at = (x: number, y: number, z: number): [number, number, number] =>
            [x, y, z].map((part, axis) => bounds[2 * axis]! + part * (bounds[2 * axis + 1]! - bounds[2 * axis]!)) as never;
        const cold = (await settled()).lastIndexOf(0);
        expect(cold, 'what no surface has asked for').toBeGreaterThanOrEqual(0);
        await probe(cold, [at(0.1, 0.1, 0.1), at(0.12, 0.1, 0.1), at(0.6, 0.1, 0.9)]);
        let resident = await settled();
        expect(resident[cold]).toBe(2 * brick);
        const marks = await page.locator('wakesurf-timeline .mark .hollow').all();
        expect(marks.length).toBe(4);
        for (const [step, mark] of marks.entries()) {
            const box = (await mark.boundingBox())!;
            const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
            await page.mouse.move(middle.x, middle.y);
            const title = await pointedAt(middle);
            expect(title).toMatch(new RegExp(`^Time-step ${step} at ${3 * step}\\b`));
            expect(Math.abs(mebiIn(title) - resident[step]! / mebi)).toBeLessThan(0.006);
        }
        const all = resident.reduce((sum, bytes) => sum + bytes, 0) / mebi;
        const words = (await page.locator('#resident').textContent()) ?? '';
        const told = /^(\d) of 4 time-steps in memory in part, ([\d.]+) MiB of 105\.3 MiB$/.exec(words);
        expect(Number(told?.[1]), words).toBe(resident.filter((bytes) => bytes > 0).length);
        expect(Math.abs(Number(told?.[2]) - all)).toBeLessThan(0.06);

        // A layer of bricks: what is told while the page is open.
        const some = [0.1, 0.3, 0.6, 0.9].flatMap((x) => [0.1, 0.3, 0.6, 0.9].map((y) => at(x, y, 0.4)));
        await probe(cold, some);
        resident = await settled();
        expect(resident[cold]).toBe(18 * brick);
    });
});
