// Leaving for good: what ends in this browser, and what goes on elsewhere.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import { ask } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const size = { width: 780, height: 420 };
let host: Page;
let session: string;

beforeAll(async () => {
    host = await stand.visit(size);
    session = (await ask(host, (hook) => hook.session))!;
});

describe('logging out', () => {
    it('ends all windows of this browser, and no one else’s', async () => {
        const page = await stand.visit({ ...size, link: `${stand.server.link}&session=${session}` });
        const beside = await stand.open(page, `${new URL('/', stand.server.link).href}#session=${session}`);
        await page.getByRole('tab', { name: 'Share' }).click();
        await page.getByRole('button', { name: 'Log out' }).click();
        await page.getByText('You are logged out.').waitFor();
        await beside.locator('#ended').getByText('This browser is logged out').waitFor();
        await page.reload();
        await page.getByText('needs the access token').waitFor();
        expect(await ask(host, (hook) => hook.connection)).toBe('open');
        await page.context().close();
    });
});
