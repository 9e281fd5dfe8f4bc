// The first picture of a dataset is of its surface, not of an empty box.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig(['flow:tornado', 'flow:double-gyre']);
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
    it('is filled by the surface, in flows of which that is a small part too, which have no body to show the flow along', async () => {
        const page = await rig.visit({ ...size, link: await rig.server.newSession() });
        const largest = ({ width, height }: { width: number; height: number }): number => Math.max(width, height);
        expect(largest(await filled(page))).toBeGreaterThan(0.55);
        for (const dataset of ['tornado', 'double-gyre']) {
            await open(page, dataset);
            expect(largest(await filled(page)), dataset).toBeGreaterThan(0.55);
        }
        // No flow can be shown along a body where there is none.
        await page.getByRole('tab', { name: 'Look' }).click();
        await page.locator('#body-group summary').click();
        await page.getByText('There is no body in this dataset.').waitFor();
    });
});
