// Share links as a host sees them: how long they hold, who made them, and what ends with them; and leaving for good.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { ShareLink } from '../../web-client/src/protocol/messages.ts';
import { ask, screenshot } from './support/browser_page.ts';
import { useStand } from './support/stand.ts';

const stand = useStand();
const size = { width: 1000, height: 800 };
const week = 7 * 24 * 3600;
let host: Page;
let session: string;

beforeAll(async () => {
    host = await stand.visit(size);
    session = (await ask(host, (hook) => hook.session))!;
    await host.getByRole('tab', { name: 'Share' }).click();
});

async function shares(): Promise<ShareLink[]> {
    return (await stand.server.call('session.shares', { session }))['shares'] as ShareLink[];
}

/** A link that hosts, and one that someone who came by it has made. */
async function linkWithChild(): Promise<ShareLink> {
    const made = await stand.server.call('session.share', { session, role: 'host' });
    const reply = await fetch(new URL('/rpc', stand.server.link), {
        method: 'POST',
        headers: { Authorization: `Bearer ${String(made['key'])}`, 'Content-Type': 'application/json' },
        body: JSON.stringify({ jsonrpc: '2.0', id: 1, method: 'session.share', params: { session, role: 'viewer' } }),
    });
    expect(await reply.json()).toHaveProperty('result');
    return made as unknown as ShareLink;
}

describe('a link', () => {
    it('holds for 7 days where nothing else is chosen, which is said where it is made, and names who made it', async () => {
        await host.getByLabel('Your name').fill('Ada');
        await host.keyboard.press('Enter');
        await expect.poll(async () => JSON.stringify(await stand.server.call('session.state', { session }))).toContain('"Ada"');
        await host.getByText('A link is valid for 7 days unless you choose another time').waitFor();
        await host.getByRole('button', { name: 'Make a link' }).click();
        const listed = host.getByRole('list', { name: 'Valid links' }).getByRole('listitem');
        await listed.filter({ hasText: 'made by Ada' }).waitFor();
        const [link] = await shares();
        expect(Math.abs(link!.expires! - Date.now() / 1000 - week)).toBeLessThan(120);
        expect(link!.madeBy.name).toBe('Ada');

        await host.getByLabel('How long the link is valid').selectOption('until revoked');
        await host.getByRole('button', { name: 'Make a link' }).click();
        await listed.filter({ hasText: 'until it is revoked' }).waitFor();
        for (const { grant } of await shares()) await stand.server.call('session.unshare', { session, grant });
    });

    it('that has made others is taken back with them or without', async () => {
        for (const [answer, left] of [
            ['Only this one', 1],
            ['Both', 0],
        ] as const) {
            const { grant } = await linkWithChild();
            // The list is asked for again with every look at it.
            await host.getByRole('tab', { name: 'View' }).click();
            await host.getByRole('tab', { name: 'Share' }).click();
            const item = host.locator(`[data-grant="${grant}"]`);
            await item.getByText('1 link or copy was made by people who used it').waitFor();
            await item.getByRole('button', { name: 'Revoke' }).click();
            await item.getByText('Revoke what those people made as well?').waitFor();
            await screenshot(host, 'link-with-children');
            await item.getByRole('button', { name: answer }).click();
            await item.waitFor({ state: 'detached' });
            expect((await shares()).length).toBe(left);
            for (const each of await shares()) await stand.server.call('session.unshare', { session, grant: each.grant });
        }
    });
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
