// The first picture of a dataset is of its surface, not of an empty box, and first and last times can be typed.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import type { SurfaceRecord } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, screenshot } from './support/browser_page.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useStand } from './support/stand.ts';

const stand = useStand(['flow:tornado', 'flow:double-gyre']);
const size = { width: 1000, height: 700 };

/** Parts of the picture's width and height that the surface takes. */
function filled(page: Page): Promise<{ width: number; height: number }> {
    return ask(page, (hook) => {
        const canvas = document.querySelector('wakesurf-app')!.shadowRoot!.querySelector('canvas')!.getBoundingClientRect();
        const seen = hook.vertices(7).map(({ point }) => hook.project(point)!);
        const part = (axis: 'x' | 'y', whole: number): number => {
            const all = seen.map((at) => at[axis]);
            return (Math.max(...all) - Math.min(...all)) / whole;
        };
        return { width: part('x', canvas.width), height: part('y', canvas.height) };
    });
}

async function open(page: Page, dataset: string): Promise<void> {
    await page.getByLabel('Dataset').selectOption(dataset);
    await page.getByRole('button', { name: 'Open', exact: true }).click();
    await page.waitForFunction((id) => location.hash.includes(`dataset=${id}`), dataset);
    await finalSurface(page);
}

describe('the first picture', () => {
    it('is filled by the surface, in flows of which that is a small part too', async () => {
        const page = await stand.visit(size);
        const largest = ({ width, height }: { width: number; height: number }): number => Math.max(width, height);
        expect(largest(await filled(page))).toBeGreaterThan(0.55);
        for (const dataset of ['tornado', 'double-gyre']) {
            await open(page, dataset);
            await screenshot(page, `first_${dataset}`);
            expect(largest(await filled(page)), dataset).toBeGreaterThan(0.55);
        }
    });

    it('stays where someone has turned it while the surface changes', async () => {
        const page = await stand.visit(size);
        await page.getByRole('button', { name: 'Fit' }).click();
        const camera = await ask(page, (hook) => hook.camera);
        await page.getByRole('radio', { name: 'Streak' }).click();
        await page.waitForFunction(() => window.wakesurf?.phase !== 'final');
        await finalSurface(page);
        expect(await ask(page, (hook) => hook.camera)).toEqual(camera);
    });
});

describe('first and last times', () => {
    it('are typed where the length is chosen, and stop at the ends of the data in words', async () => {
        const page = await stand.visit(size);
        const session = await ask(page, (hook) => hook.session);
        const record = async (): Promise<Pick<SurfaceRecord, 'from' | 'to' | 'kind'>> => {
            const { surfaces } = await stand.server.call('surface.list', { session });
            const [{ from, to, kind }] = surfaces as [SurfaceRecord];
            return { from, to, kind };
        };
        await page.getByRole('radio', { name: 'Streak' }).click();
        await expect.poll(async () => (await record()).kind).toBe('streak');
        const { to } = await record();
        await page.getByLabel('From', { exact: true }).fill('11.5');
        await page.keyboard.press('Tab');
        await expect.poll(record).toMatchObject({ from: 11.5, to });
        await page.getByLabel('To', { exact: true }).fill('12.5');
        await page.keyboard.press('Enter');
        await expect.poll(record).toMatchObject({ from: 11.5, to: 12.5 });
        await expectServersMesh(stand.server, page);

        const last = (await stand.server.call('dataset.describe', { dataset: 'sqcyl' }))['times'] as number[];
        await page.getByLabel('To', { exact: true }).fill('1000');
        await page.keyboard.press('Enter');
        await expect.poll(async () => (await record()).to).toBe(last.at(-1));
        await page.getByText('t = 1000 is outside the data').waitFor();
        await page.getByLabel('To', { exact: true }).fill('11.5');
        await page.keyboard.press('Enter');
        await page.getByText('It ends at another time than it begins.').waitFor();
        expect(await record()).toMatchObject({ from: 11.5, to: last.at(-1) });
    });
});
