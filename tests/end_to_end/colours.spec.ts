// Colours keep their meaning: while a surface plays, for those who come later, over all surfaces of a picture, and in a film.
import type { Browser, BrowserContext, Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import type { SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { bundledStore, ServerProcess } from './support/server_process.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

let server: ServerProcess;
let browser: Browser;
let context: BrowserContext;
let page: Page;
let link: string;

beforeAll(async () => {
    server = await ServerProcess.start({ store: bundledStore() });
    await server.imported();
    browser = await testBrowser();
    context = await newContext(browser, { width: 800, height: 520 });
    link = await server.streamSession();
    page = await openPage(context, link);
    await finalSurface(page);
    await page.getByRole('radio', { name: 'Streak' }).check();
    await page.waitForFunction(() => (window.wakesurf?.displayed?.epoch ?? 0) > 1);
    await finalSurface(page);
});

afterAll(async () => {
    await closePages();
    await server?.stop();
});

const bars = (on: Page = page): Promise<string[]> =>
    on.locator('wakesurf-scalar-bar figure').evaluateAll((all) => all.map((each) => each.getAttribute('aria-label') ?? ''));

function endsIn(words: string): [number, number] {
    const [, from, to] = / from (\S+) to ([^\s,]+)/.exec(words)!;
    return [Number(from!.replace('−', '-')), Number(to!.replace('−', '-'))];
}

async function colourBy(value: string, on: Page = page): Promise<void> {
    await on.getByRole('tab', { name: 'Look' }).click();
    await on.getByLabel('Colour by').selectOption(value);
}

async function goTo(time: number): Promise<void> {
    await page.locator('#go-to').fill(String(time));
    await page.keyboard.press('Enter');
    await page.waitForFunction((at) => window.wakesurf!.displayed!.time === at, time);
    await finalSurface(page);
}

/** Every label that the first bar has had since, while `act` went on. */
async function labelsWhile(act: () => Promise<unknown>): Promise<string[]> {
    await page.evaluate(() => {
        const root = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('wakesurf-scalar-bar')!.shadowRoot!;
        const had: string[] = [];
        const note = (): void => {
            const label = root.querySelector('figure')?.getAttribute('aria-label') ?? '';
            if (had.at(-1) !== label) had.push(label);
        };
        note();
        const observer = new MutationObserver(note);
        observer.observe(root, { subtree: true, childList: true, attributes: true });
        Object.assign(window, { labelsHad: had, labelObserver: observer });
    });
    await act();
    return page.evaluate(() => {
        const facts = window as unknown as { labelsHad: string[]; labelObserver: MutationObserver };
        facts.labelObserver.disconnect();
        return facts.labelsHad;
    });
}

describe('while a surface plays', () => {
    it('the range of its colours only grows, and says whose it is', async () => {
        await colourBy('vorticity');
        await page.waitForFunction(() => !window.wakesurf!.displayed!.withheld.includes('vorticity'));
        await goTo(9);
        const labels = await labelsWhile(async () => {
            await page.locator('#speed').selectOption('4');
            await page.getByRole('button', { name: 'Play' }).click();
            // Over the loop's end, where there is nothing to see.
            await page.waitForFunction(() => window.wakesurf!.displayed!.time > 14.5, null, { timeout: 60_000 });
            await page.waitForFunction(() => window.wakesurf!.displayed!.time < 11, null, { timeout: 60_000 });
            await page.getByRole('button', { name: 'Pause' }).click();
        });
        const ends = labels.map(endsIn);
        for (const [i, [from, to]] of ends.entries()) {
            if (i === 0) continue;
            expect(from, labels.join('\n')).toBeLessThanOrEqual(ends[i - 1]![0]);
            expect(to, labels.join('\n')).toBeGreaterThanOrEqual(ends[i - 1]![1]);
        }
        expect(labels.at(-1)).toMatch(/^Colours: \|Vorticity\|.*, of this surface/);
    });

    it('is the same for those who come later, and after a reload', async () => {
        await goTo(10);
        const [mine] = await bars();
        const other = await openPage(await newContext(browser, { width: 900, height: 600 }), link);
        await finalSurface(other);
        await colourBy('vorticity', other);
        await expect.poll(() => bars(other), { timeout: 20_000 }).toEqual([mine]);
        await other.context().close();
        await page.reload();
        await finalSurface(page);
        await expect.poll(() => bars(), { timeout: 20_000 }).toEqual([mine]);
    });
});

describe('a film', () => {
    it('has the range of the whole film from its first frame to its last, and says so', async () => {
        await goTo(9);
        // Another surface, whose colours nobody has seen yet.
        await page.getByRole('tab', { name: 'Flow' }).click();
        await page.locator('wakesurf-rake').getByRole('button', { name: 'Start' }).first().focus();
        const before = await ask(page, (hook) => hook.displayed?.epoch ?? 0);
        await page.keyboard.press('ArrowUp');
        // The epoch stays: that a phase is not the last one can be over before a slow page is asked.
        await page.waitForFunction((old) => (window.wakesurf?.displayed?.epoch ?? 0) > old, before);
        await finalSurface(page);
        await page.getByRole('tab', { name: 'Export' }).click();
        await page.locator('#film-fps').selectOption('12');
        await page.locator('#film-seconds').fill('0.5');
        await page.locator('#film-seconds').press('Tab');
        const labels = await labelsWhile(async () => {
            const download = page.waitForEvent('download', { timeout: 120_000 });
            await page.locator('#record-film').click();
            await page.getByText(/Looking up the range of the colours/).waitFor();
            await (await download).delete();
        });
        const inFilm = labels.filter((each) => each.includes('of the whole film'));
        expect(inFilm, labels.join('\n')).toHaveLength(1);
        expect(labels.indexOf(inFilm[0]!), labels.join('\n')).toBeGreaterThan(0);
        const [from, to] = endsIn(inFilm[0]!);
        for (const label of labels) {
            expect(endsIn(label)[0]).toBeGreaterThanOrEqual(from);
            expect(endsIn(label)[1]).toBeLessThanOrEqual(to);
        }
        expect((await bars())[0]).toContain('of this surface');
    });
});

describe('several surfaces', () => {
    it('that show the same field have one range and one bar, and others a bar each', async () => {
        await colourBy('speed');
        await page.getByRole('tab', { name: 'Flow' }).click();
        await page.getByRole('button', { name: 'New rake' }).click();
        await page.waitForFunction(() => window.wakesurf!.allDisplayed.length === 2, null, { timeout: 30_000 });
        await finalSurface(page);
        await expect.poll(() => bars()).toHaveLength(1);
        expect((await bars())[0]).toMatch(/^Colours: Speed.*, of all surfaces shown/);
        const [low, high] = endsIn((await bars())[0]!);
        const speeds = await ask(page, (hook) => hook.vertices(1).map(({ scalar }) => scalar));
        expect(Math.min(...speeds)).toBeGreaterThanOrEqual(low - 0.05);
        expect(Math.max(...speeds)).toBeLessThanOrEqual(high + 0.05);

        await colourBy('q_criterion');
        // The picture changes over when the values are here.
        await expect.poll(async () => (await bars())[0], { timeout: 20_000 }).toMatch(/^Colours: Q, above 0: vortex/);
        const [, second, third] = await bars();
        expect(third).toBeUndefined();
        expect(second).toMatch(/^Colours: Speed/);
    });
});

describe('a surface whose values someone else has taken away', () => {
    it('is drawn in one colour, whatever its mesh is replaced by, and the bar says of what there are none', async () => {
        const mine = await openPage(context, await server.streamSession());
        await finalSurface(mine);
        await colourBy('q_criterion', mine);
        await mine.waitForFunction(() => !window.wakesurf!.displayed!.withheld.includes('q_criterion'));
        await expect.poll(async () => (await bars(mine))[0]).toContain('Q, above 0: vortex');
        const session = await ask(mine, (hook) => hook.session);
        const state = (await server.call('session.state', { session })) as { surfaces: SurfaceRecord[] };
        const { surface, rake, dataset, separation, to } = state.surfaces[0]!;
        for (const change of [
            { kind: 'stream', from: 16, to },
            { kind: 'path', from: 8.5, to: 16 },
        ]) {
            const epoch = await ask(mine, (hook) => hook.displayed!.epoch);
            await server.call('surface.set', { session, surface, rake, dataset, separation, ...change, fields: [] });
            await mine.waitForFunction((old) => window.wakesurf!.displayed!.epoch > old, epoch);
            await finalSurface(mine);
            const scalars = await ask(mine, (hook) => hook.vertices(1).map(({ scalar }) => scalar));
            expect(scalars.length).toBeGreaterThan(100);
            expect(scalars.every(Number.isNaN)).toBe(true);
            expect(await bars(mine)).toEqual([]);
            const words = mine.locator('wakesurf-scalar-bar').getByText('Q, above 0: vortex: no values, so one colour');
            expect(await words.isVisible()).toBe(true);
        }
        await mine.getByText('It is drawn without.').waitFor();
    });
});
