// How long someone waits for the first picture.
import { describe, expect, it } from 'vitest';
import { ask } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();

describe('a visit', () => {
    it('sees the domain within two seconds of opening', async () => {
        const visits: number[] = [];
        for (let i = 0; i < 3; ++i) {
            const page = await rig.visit({ width: 900, height: 600 });
            visits.push((await ask(page, (hook) => hook.firstPictureMs))!);
            await page.context().close();
        }
        const [, usual] = visits.sort((a, b) => a - b);
        expect(usual, visits.join(', ')).toBeLessThan(2000);
    });
});
