// Numbers as people type them, on keyboards and in browsers of other languages.
import { describe, expect, it } from 'vitest';
import { ask } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();

describe.each(['en-US', 'de-DE', 'fr-FR'])('in a browser whose language is %s', (locale) => {
    it('a rake goes where a comma or a point says, and not where two marks may mean two', async () => {
        const page = await rig.visit({ width: 900, height: 700, locale });
        expect(await page.evaluate(() => navigator.language)).toBe(locale);
        const end = (): Promise<number[]> => ask(page, (hook) => [...hook.rakePoints.at(-1)!]);
        const field = page.getByRole('textbox', { name: 'End x' });
        const type = async (text: string): Promise<void> => {
            await field.click({ clickCount: 3 });
            await page.keyboard.type(text);
            await page.keyboard.press('Enter');
        };
        const [, y, z] = await end();
        await type('-0,9');
        await expect.poll(end).toEqual([-0.9, y, z]);
        expect(await field.inputValue()).toBe('-0.9');
        await type('1,234.5');
        await page.getByText('1,234.5 is not clear').waitFor();
        expect([await end(), await field.inputValue()]).toEqual([[-0.9, y, z], '-0.9']);
        await type('-1.25');
        await expect.poll(end).toEqual([-1.25, y, z]);
        await page.getByText('1,234.5 is not clear').waitFor({ state: 'detached' });
        await page.context().close();
    });
});
