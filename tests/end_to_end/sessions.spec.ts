// Sessions as people meet them: the printed link leads to one for all, and a list shows all there are. What else the list does,
// and what becomes of a session that is deleted, is tested beside it.
import type { Page } from 'playwright-core';
import { describe, expect, it } from 'vitest';
import type { SessionEntry } from '../../web-client/src/protocol/messages.ts';
import { ask } from './support/browser_page.ts';
import { dragHandle } from './support/rake_drag.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const size = { width: 780, height: 420 };

async function listed(trash = false): Promise<SessionEntry[]> {
    return (await rig.server.call('session.list', { trash }))['sessions'] as SessionEntry[];
}

async function named(name: string): Promise<SessionEntry | undefined> {
    return (await listed()).find((each) => each.name === name);
}

async function openList(page: Page): Promise<void> {
    await page.getByRole('complementary').getByRole('button', { name: 'Sessions', exact: true }).click();
    await page.getByRole('list', { name: 'Sessions on this server' }).waitFor();
}

function card(page: Page, name: string): ReturnType<Page['locator']> {
    return page
        .getByRole('dialog')
        .getByRole('listitem')
        .filter({ has: page.getByTitle(name, { exact: true }) });
}

function sessionOf(page: Page): Promise<string | null> {
    return ask(page, (hook) => hook.session);
}

describe('the printed link', () => {
    it('makes no session however often it is opened: everyone meets in one, with a first surface that no one has edited', async () => {
        const pages: Page[] = [];
        for (let visit = 0; visit < 2; ++visit) pages.push(await rig.visit({ ...size, link: rig.server.link }));
        expect(await Promise.all(pages.map(sessionOf))).toEqual(['main', 'main']);
        expect(await listed()).toMatchObject([{ session: 'main', rakes: 1, surfaces: 1, edited: false, participants: 2 }]);
        await dragHandle(pages[0]!, 0, 12, -8, 3);
        const moved = await ask(pages[0]!, (hook) => hook.rakePoints);
        await pages[1]!.waitForFunction(
            (points) => JSON.stringify(window.wakesurf!.rakePoints) === JSON.stringify(points),
            moved,
        );
        await expect.poll(async () => (await listed())[0]!.edited).toBe(true);
        for (const page of pages) await page.context().close();
    });
});

describe('the list of sessions', () => {
    it('shows who is there, what is in it, and how it looks', async () => {
        const page = await rig.visit({ ...size, link: await rig.server.streamSession('Thesis figure 4') });
        await dragHandle(page, 1, 14, 6, 3);
        await expect.poll(async () => (await named('Thesis figure 4'))?.thumbnail, { timeout: 20_000 }).toBe(true);
        const session = (await sessionOf(page))!;
        const framesBefore = await ask(page, (hook) => hook.framesDrawn);
        await openList(page);
        const own = card(page, 'Thesis figure 4');
        await own.getByText('you are here').waitFor();
        await own.getByText('1 rake, 1 surface').waitFor();
        const picture = own.locator('img');
        await expect
            .poll(() => picture.evaluate((img: HTMLImageElement) => [img.naturalWidth, img.naturalHeight]))
            .toEqual([320, 200]);
        // As many colours as a surface has, not a blank canvas.
        const colours = await picture.evaluate((img: HTMLImageElement) => {
            const canvas = new OffscreenCanvas(img.naturalWidth, img.naturalHeight);
            const drawing = canvas.getContext('2d')!;
            drawing.drawImage(img, 0, 0);
            const { data } = drawing.getImageData(0, 0, canvas.width, canvas.height);
            const seen = new Set<number>();
            for (let i = 0; i < data.length; i += 4) {
                seen.add(((data[i]! >> 5) << 10) | ((data[i + 1]! >> 5) << 5) | (data[i + 2]! >> 5));
            }
            return seen.size;
        });
        expect(colours).toBeGreaterThan(12);
        await page.keyboard.press('Escape');
        expect(await page.getByRole('dialog').count()).toBe(0);
        // Nothing is drawn for the list, and no second picture of what has not changed is sent.
        expect((await ask(page, (hook) => hook.framesDrawn)) - framesBefore).toBeLessThanOrEqual(1);
        const { headers } = await page.request
            .get(new URL(`/api/v1/sessions/${session}/thumbnail`, rig.server.link).href, {
                headers: { Authorization: `Bearer ${rig.server.token}` },
            })
            .then((reply) => ({ headers: reply.headers() }));
        expect(headers['content-type']).toBe('image/jpeg');
        // In the trash it is the same picture.
        await rig.server.call('session.delete', { session });
        await openList(page);
        await page.getByRole('button', { name: /^Trash/ }).click();
        const deleted = card(page, 'Thesis figure 4').locator('img');
        await expect.poll(() => deleted.evaluate((img: HTMLImageElement) => img.naturalWidth)).toBe(320);
        await page.context().close();
    });
});
