// People together: a link made on the page, where others look and point, following them, notes.
import type { Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Participant, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface } from './support/browser_page.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
const size = { width: 900, height: 560 };
let host: Page;
let guest: Page;

async function linkToEdit(): Promise<string> {
    await host.getByRole('tab', { name: 'Share' }).click();
    await host.getByLabel('What the link allows').selectOption('to edit');
    await host.getByRole('button', { name: 'Make a link' }).click();
    await host.locator('#share-link').waitFor();
    return host.locator('#share-link').inputValue();
}

beforeAll(async () => {
    host = await rig.visit(size);
    await host.evaluate(() => window.wakesurf!.setCamera([5, -26, 8], [5, 0, 3]));
    guest = await rig.visit({ ...size, link: await linkToEdit() });
});

async function participantsOf(page: Page): Promise<Participant[]> {
    const session = await ask(page, (hook) => hook.session);
    return (await rig.server.call('session.state', { session }))['participants'] as Participant[];
}

/** The colour of a participant as it is drawn. */
function rgbOf(colour: string): number[] {
    return [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
}

function near(a: readonly number[], b: readonly number[], slack: number): boolean {
    return a.length === b.length && a.every((value, i) => Math.abs(value - b[i]!) <= slack);
}

describe('a link made on the page', () => {
    it('opens the same view of the same session; both are listed with what they may do, which the host changes at once', async () => {
        const [mine, theirs] = [await ask(host, (hook) => hook.camera), await ask(guest, (hook) => hook.camera)];
        expect(near(theirs.position, mine.position, 1e-3)).toBe(true);
        expect(near(theirs.target, mine.target, 1e-3)).toBe(true);
        expect(await ask(guest, (hook) => hook.session)).toBe(await ask(host, (hook) => hook.session));
        const may = host.getByRole('combobox', { name: /What guest 2 may do/ });
        await may.waitFor();
        expect(await may.inputValue()).toBe('editor');
        await guest.getByRole('tab', { name: 'Share' }).click();
        await guest.getByText('Only people who can invite can make links').waitFor();
        expect(await guest.getByRole('list', { name: 'People in this session' }).getByRole('listitem').count()).toBe(2);
        await may.selectOption('can look');
        await expect.poll(async () => (await participantsOf(host)).find(({ name }) => name === 'guest 2')!.role).toBe('viewer');
        await guest.getByText('Your link is for looking').waitFor();
        await may.selectOption('can edit');
        await guest.getByText('Your link is for looking').waitFor({ state: 'detached' });
    });

    it('shows everyone under the name they give themselves', async () => {
        await host.getByLabel('Your name').fill('Ada');
        await host.keyboard.press('Enter');
        await guest.getByRole('button', { name: 'Follow Ada' }).waitFor();
        expect((await participantsOf(host)).map(({ name }) => name)).toEqual(expect.arrayContaining(['Ada', 'guest 2']));
        // The page is still in the session: it sees what others edit.
        await guest.getByRole('tab', { name: 'Flow' }).click();
        await guest.getByRole('textbox', { name: 'Start x' }).fill('-1.8');
        await guest.keyboard.press('Enter');
        await host.waitForFunction(() => window.wakesurf!.rakePoints[0]![0] === -1.8);
        await finalSurface(host);
        await guest.getByRole('tab', { name: 'Share' }).click();
    });
});

describe('the others in the picture', () => {
    it('are shown where they point, in their colour', async () => {
        // A vertex of the surface that nothing covers: the host points at it, the guest sees the dot there.
        const at = await host.evaluate(() => {
            const hook = window.wakesurf!;
            const seen = hook.vertices(11).map(({ point }) => hook.project(point)!);
            return seen.find(({ x, y }) => x > 250 && x < 450 && y > 150 && y < 400)!;
        });
        await host.mouse.move(at.x - 3, at.y);
        await host.mouse.move(at.x, at.y);
        const you = (await participantsOf(host)).find(({ name }) => name === 'Ada')!;
        const apart = async (): Promise<number> => {
            const pointer = (await participantsOf(host)).find(({ name }) => name === 'Ada')!.pointer ?? null;
            if (pointer === null) return 99;
            const pointed = (await host.evaluate((point) => window.wakesurf!.project(point), pointer))!;
            return Math.hypot(pointed.x - at.x, pointed.y - at.y);
        };
        await expect.poll(apart).toBeLessThan(2);
        const pointer = (await participantsOf(host)).find(({ name }) => name === 'Ada')!.pointer as Vec3;
        const colour = rgbOf(you.colour);
        const seen = async (): Promise<number[]> =>
            guest.evaluate((point) => window.wakesurf!.pixelsAt([window.wakesurf!.project(point)!])[0]!, pointer);
        await expect.poll(async () => near(await seen(), colour, 12)).toBe(true);
        await guest.locator('.person', { hasText: you.name }).first().waitFor();
    });

    it('are shown where they look from, and their view is taken by following until the camera is moved', async () => {
        await host.evaluate(() => window.wakesurf!.setCamera([60, -60, 40], [5, 0, 3]));
        await guest.mouse.move(300, 420);
        await guest.mouse.down();
        await guest.mouse.move(330, 412, { steps: 3 });
        await guest.mouse.up();
        const eye = (await ask(guest, (hook) => hook.camera)).position;
        // The name stands over the eye of their camera.
        const label = host.locator('.person', { hasText: 'guest 2' }).first();
        await expect
            .poll(async () => {
                const [box, at] = [
                    await label.boundingBox(),
                    await host.evaluate((point) => window.wakesurf!.project(point), eye),
                ];
                return box === null || at === null
                    ? 99
                    : Math.hypot(box.x + box.width / 2 - at.x, box.y + box.height / 2 - (at.y - 14));
            })
            .toBeLessThan(3);

        await host.getByRole('button', { name: 'Follow guest 2' }).click();
        const together = async (): Promise<boolean> =>
            near((await ask(host, (hook) => hook.camera)).position, (await ask(guest, (hook) => hook.camera)).position, 1e-3);
        await expect.poll(together).toBe(true);
        await guest.mouse.move(300, 420);
        await guest.mouse.down();
        await guest.mouse.move(200, 390, { steps: 4 });
        await guest.mouse.up();
        await expect.poll(together).toBe(true);
        await guest.getByRole('button', { name: 'Fit the whole domain' }).click();
        await expect.poll(together).toBe(true);
        // Someone who moves the camera has it to themselves again.
        await host.mouse.move(300, 420);
        await host.mouse.down();
        await host.mouse.move(350, 412, { steps: 3 });
        await host.mouse.up();
        expect(await host.getByRole('button', { name: 'Follow guest 2' }).getAttribute('aria-pressed')).toBe('false');
        expect(await together()).toBe(false);
    });
});

describe('someone of whom nothing is in the picture', () => {
    it('has their name at the edge, on the way to where they look from', async () => {
        await host.evaluate(() => window.wakesurf!.setCamera([5, -26, 8], [5, 0, 3]));
        await guest.evaluate(() => window.wakesurf!.setCamera([70, 10, 12], [5, 0, 3]));
        await guest.mouse.move(300, 420);
        await guest.mouse.down();
        await guest.mouse.move(302, 420);
        await guest.mouse.up();
        await guest.getByRole('tab', { name: 'Share' }).hover();
        const eye = (await ask(guest, (hook) => hook.camera)).position;
        const hint = host.locator('.person', { hasText: /guest 2 .$/ });
        const picture = (await host.locator('canvas').first().boundingBox())!;
        const middle = { x: picture.x + picture.width / 2, y: picture.y + picture.height / 2 };
        // Left free for the buttons.
        const inset = { left: 8, right: 112, top: 48, bottom: 8 };
        await expect
            .poll(async () => {
                const [box, at] = [
                    await hint.boundingBox(),
                    await host.evaluate((point) => window.wakesurf!.project(point), eye),
                ];
                if (box === null || at === null) return 99;
                // Where the way there crosses the border, and how far along its words the label is held.
                const reach = (picture.width / 2 - inset.right) / (at.x - middle.x);
                const crossing = { x: middle.x + reach * (at.x - middle.x), y: middle.y + reach * (at.y - middle.y) };
                const share = (crossing.y - picture.y - inset.top) / (picture.height - inset.top - inset.bottom);
                return Math.hypot(box.x + box.width - crossing.x, box.y + box.height * share - crossing.y);
            })
            .toBeLessThan(2);
        const box = (await hint.boundingBox())!;
        const tools = (await host.getByRole('group', { name: 'Tools' }).boundingBox())!;
        expect(box.x + box.width).toBeLessThan(tools.x);
    });
});

describe('notes', () => {
    it('stand where they were put, for everyone, until they are deleted', async () => {
        await host.evaluate(() => window.wakesurf!.setCamera([5, -26, 8], [5, 0, 3]));
        const at = await host.evaluate(() => {
            const hook = window.wakesurf!;
            const seen = hook.vertices(11).map(({ point }) => hook.project(point)!);
            return seen.find(({ x, y }) => x > 250 && x < 450 && y > 200 && y < 400)!;
        });
        await host.getByRole('button', { name: 'Note', exact: true }).click();
        await host.mouse.click(at.x, at.y);
        await host.getByLabel('A note for everyone here').fill('Tears here');
        await host.getByRole('button', { name: 'Save' }).click();
        await guest.getByRole('listitem').filter({ hasText: 'Tears here' }).waitFor();
        const session = await ask(host, (hook) => hook.session);
        const { annotations } = (await rig.server.call('annotation.list', { session })) as {
            annotations: { position: Vec3 }[];
        };
        const seen = (await host.evaluate((point) => window.wakesurf!.project(point), annotations[0]!.position))!;
        expect(Math.hypot(seen.x - at.x, seen.y - at.y)).toBeLessThan(2);

        await guest.getByRole('button', { name: 'Change' }).click();
        await guest.getByLabel('Change the note').fill('Tears there');
        await guest.getByRole('button', { name: 'Save' }).click();
        await host.getByRole('listitem').filter({ hasText: 'Tears there' }).waitFor();
        await host.getByRole('button', { name: 'Delete', exact: true }).click();
        await expect.poll(() => guest.getByText('Tears there').count()).toBe(0);
    });
});
