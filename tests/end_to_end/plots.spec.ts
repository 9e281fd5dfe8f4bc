// Plots below the picture, and the histogram of what is coloured: what they show is what the server samples, and what a user does to them acts.
import { readFile } from 'node:fs/promises';
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { SampledPoints, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let page: Page;

beforeAll(async () => {
    page = await rig.visit({ width: 1100, height: 760 });
    await finalSurface(page);
});

async function saved(name: string): Promise<string> {
    const [download] = await Promise.all([
        page.waitForEvent('download'),
        page.getByRole('button', { name, exact: true }).click(),
    ]);
    return readFile(await download.path(), 'utf8');
}

function rowsOf(csv: string): (number | null)[][] {
    const [, ...rows] = csv.trim().split('\n');
    return rows.map((row) => row.split(',').map((cell) => (cell === '' ? null : Number(cell))));
}

async function sampled(points: (number | null)[][], time: number): Promise<SampledPoints> {
    const { datasets } = (await rig.server.call('dataset.list', {})) as { datasets: { dataset: string }[] };
    const { dataset } = datasets[0]!;
    return (await rig.server.call('probe.sample', { dataset, points, time, fields: ['U'] })) as unknown as SampledPoints;
}

describe('a plot', () => {
    it('along a line has the speed that the server samples there, gaps in the body, and goes when it is closed', async () => {
        await page.getByRole('button', { name: 'Plot', exact: true }).click();
        await page.locator('wakesurf-plot-chart canvas').waitFor();
        await page.locator('#plot-of').selectOption('line');
        await page.getByRole('textbox', { name: 'From y' }).fill('0.05');
        await page.keyboard.press('Enter');
        await page.getByRole('button', { name: 'Table', exact: true }).click();
        await page.getByRole('cell', { name: '0.05', exact: true }).first().waitFor();
        const rows = rowsOf(await saved('CSV'));
        expect(rows.length).toBe(401);
        const places = rows.map(([, x, y, z]) => [x!, y!, z!]);
        const { inside, values } = await sampled(places, rows[0]![4]!);
        rows.forEach((row, i) => {
            const velocity = values['U']![i] as Vec3 | null;
            expect(row[5]).toEqual(velocity === null ? null : Math.hypot(...velocity));
        });
        expect(inside).toContain(false);
        expect(await saved('SVG')).toContain('</svg>');
        await page.getByRole('button', { name: 'Close the plot' }).click();
        await page.locator('wakesurf-plot-dock').waitFor({ state: 'detached' });
    }, 120_000);

    it('over time has a value for each time-step, and a click sets the time of the picture', async () => {
        await page.getByRole('button', { name: 'Plot', exact: true }).click();
        await page.locator('#plot-of').selectOption('point');
        const chart = page.locator('wakesurf-plot-chart[choosable] .u-over');
        await chart.waitFor();
        await page.locator('wakesurf-plot-dock progress').waitFor({ state: 'detached' });
        await page.getByRole('button', { name: 'Table', exact: true }).click();
        await page.locator('wakesurf-plot-dock tbody tr').nth(15).waitFor();
        await page.getByRole('button', { name: 'Table', exact: true }).click();
        const { x, y, width, height } = (await chart.boundingBox())!;
        const time = page.locator('#go-to');
        await page.mouse.click(x + width * 0.5, y + height / 2);
        await expect.poll(async () => Math.abs(Number(await time.inputValue()) - 12.25)).toBeLessThan(0.3);
        await page.getByRole('button', { name: 'Close the plot' }).click();
    }, 120_000);
});

describe('the histogram of what is coloured', () => {
    it('has ends that are dragged and moved by keys, which the bar follows', async () => {
        await finalSurface(page);
        await page.getByRole('tab', { name: 'Look' }).click();
        const high = page.locator('#range-high');
        await high.scrollIntoViewIfNeeded();
        const { x, y, width, height } = (await high.boundingBox())!;
        const before = Number(await page.getByRole('textbox', { name: 'Range to' }).inputValue());
        await page.mouse.move(x + width - 7, y + height / 2);
        await page.mouse.down();
        await page.mouse.move(x + width / 2, y + height / 2, { steps: 8 });
        await page.mouse.up();
        const typed = page.getByRole('textbox', { name: 'Range to' });
        await expect.poll(async () => Number(await typed.inputValue()) / before).toBeLessThan(0.6);
        const dragged = Number(await typed.inputValue());
        await high.press('ArrowLeft');
        await expect.poll(async () => Number(await typed.inputValue())).toBeLessThan(dragged);
        await page
            .locator('wakesurf-scalar-bar')
            .getByRole('figure', { name: /locked/ })
            .waitFor();
        await page.locator('#root').check();
        await page.locator('#bands').fill('6');
        await page.locator('#bands').press('Enter');
        await page
            .locator('wakesurf-scalar-bar')
            .getByRole('figure', { name: /by the root, in 6 bands/ })
            .waitFor();
        await page.locator('#range-all').click();
        await expect.poll(async () => Number(await typed.inputValue())).toBeGreaterThan(dragged);
    }, 120_000);
});
