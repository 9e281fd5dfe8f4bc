// An animation as its reader meets it: a file on a disk, without a server and without a network.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { newContext } from './support/browser_page.ts';
import { takeComplaints } from './support/complaints.ts';
import { projectRoot } from './support/project_root.ts';
import { closePages, testBrowser } from './support/test_browser.ts';

const binary = process.env['WAKESURF_BINARY'] ?? join(projectRoot, 'build/release/bin/wakesurf');
const folder = mkdtempSync(join(tmpdir(), 'wakesurf-animation-'));
const file = join(folder, 'wake.html');
const requests: string[] = [];
let page: Page;

interface Hook {
    count: number;
    step: () => number;
    goTo: (step: number) => void;
}

async function goTo(step: number): Promise<string> {
    await page.evaluate((to) => (window as unknown as { wakesurfAnimation: Hook }).wakesurfAnimation.goTo(to), step);
    await page.waitForFunction((to) => (window as unknown as { wakesurfAnimation: Hook }).wakesurfAnimation.step() === to, step);
    return (await page.screenshot()).toString('base64');
}

beforeAll(async () => {
    const words = ['--kind', 'stream', '--rake', '0.4,0.4,0.1 0.6,0.6,0.1', '--to', '6', '--separation', '0.05'];
    const made = spawnSync(binary, ['surface', 'flow:tornado', ...words, '--times', '0:6:0.2', '-o', file]);
    expect(made.status, String(made.stderr)).toBe(0);
    const context = await newContext(await testBrowser());
    await context.setOffline(true);
    page = await context.newPage();
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(`file://${file}`);
    await page.waitForFunction(() => 'wakesurfAnimation' in window);
});

afterAll(async () => {
    await closePages();
    rmSync(folder, { recursive: true });
});

describe('an animation opened from the disk', () => {
    it('shows other pixels at another step', async () => {
        const [early, late] = [await goTo(3), await goTo(30)];
        expect(late).not.toBe(early);
        expect(await page.locator('#time').textContent()).toMatch(/^t = 6/);
    });

    it('asks for nothing but itself', async () => {
        await goTo(10);
        expect(requests).toEqual([`file://${file}`]);
        const reached = await page.evaluate(() =>
            fetch('data:text/plain,x').then(
                () => true,
                () => false,
            ),
        );
        expect(reached).toBe(false);
        expect(takeComplaints().join('\n')).toContain('Content Security Policy');
    });

    it('plays on from where it is when told to', async () => {
        await goTo(5);
        await page.getByRole('button', { name: 'Play' }).click();
        await page.waitForFunction(() => (window as unknown as { wakesurfAnimation: Hook }).wakesurfAnimation.step() > 6);
        await page.getByRole('button', { name: 'Pause' }).click();
    });

    it('says how exact it is', async () => {
        await page.locator('summary').click();
        const facts = await page.locator('#facts').textContent();
        expect(facts).toContain('Tracing error at the last step: 99 % of the vertices are within');
        expect(facts).toContain('none is stated, because the field is frozen');
    });
});
