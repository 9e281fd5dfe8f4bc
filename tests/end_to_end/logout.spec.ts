// Leaving for good: what ends in this browser, and what goes on elsewhere.
import { describe, expect, it } from 'vitest';
import { ask, entered, newContext, openPage } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const size = { width: 780, height: 420 };
describe('logging out', () => {
    it('ends all windows of this browser, and no one else’s', async () => {
        const host = await openPage(await newContext(rig.browser, size), await rig.server.streamSession());
        const session = await entered(host);
        const context = await newContext(rig.browser, size);
        const page = await openPage(context, `${rig.server.link}&session=${session}`);
        await entered(page);
        const beside = await openPage(context, `${new URL('/', rig.server.link).href}#session=${session}`);
        await entered(beside);
        await page.getByRole('tab', { name: 'Share' }).click();
        await page.getByRole('button', { name: 'Log out' }).click();
        await page.getByText('You are logged out.').waitFor();
        await beside.locator('#ended').getByText('This browser is logged out').waitFor();
        await page.reload();
        await page.getByText('needs the access token').waitFor();
        expect(await ask(host, (hook) => hook.connection)).toBe('open');
        await context.close();
    });
});
