// Rakes as people work with them: by mouse, by keyboard alone, by clicks alone, by touch; several of them, of every kind. What
// is done must be under the pointer at once and in the server's records afterwards.
import type { BrowserContext, Page } from 'playwright-core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { RakeRecord, SurfaceRecord, Vec3 } from '../../web-client/src/protocol/messages.ts';
import { ask, finalSurface, newContext, openPage } from './support/browser_page.ts';
import { Guest } from './support/guest.ts';
import { dragHandle, takeHandle } from './support/rake_drag.ts';
import { expectServersMesh } from './support/server_mesh.ts';
import { useTestRig } from './support/test_rig.ts';

const rig = useTestRig();
let context: BrowserContext;
let page: Page;
let session: string;
let firstRake: RakeRecord;

/** Its tests go on where the one before has left the rakes. */
async function visit(): Promise<void> {
    context = await newContext(rig.browser, { width: 900, height: 560 });
    page = await openPage(context, await rig.server.streamSession());
    await finalSurface(page);
    // By how many pixels hands move is chosen for the whole domain.
    await page.getByRole('button', { name: 'Fit' }).click();
    session = (await ask(page, (hook) => hook.session))!;
    firstRake = (await rakes())[0]!;
}

/** The first rake where it was at first. */
async function restored(): Promise<void> {
    const { rake, kind, points, seeds } = firstRake;
    await rig.server.call('rake.set', { session, rake, kind, points, seeds });
    await page.waitForFunction((all) => JSON.stringify(window.wakesurf!.rakePoints) === all, JSON.stringify(points));
    await finalSurface(page);
}

async function rakes(): Promise<RakeRecord[]> {
    return (await rig.server.call('rake.list', { session }))['rakes'] as RakeRecord[];
}

async function surfaces(): Promise<SurfaceRecord[]> {
    return (await rig.server.call('surface.list', { session }))['surfaces'] as SurfaceRecord[];
}

/** Asks the server until it says what is expected. */
async function eventually<Fact>(ask: () => Promise<Fact>, holds: (fact: Fact) => boolean): Promise<Fact> {
    let fact = await ask();
    await expect.poll(async () => holds((fact = await ask())), { timeout: 30_000, interval: 40 }).toBe(true);
    return fact;
}

function shown(): Promise<Vec3[]> {
    return ask(page, (hook) => hook.rakePoints);
}

/** What is on the screen of the chosen rake is in its record, the person who dragged it has let go, and it is not what it was. */
async function recorded(index = 0, was: Vec3[] = []): Promise<RakeRecord> {
    const both = async () => ({ seen: await shown(), rake: (await rakes())[index]! });
    const same = await eventually(both, ({ seen, rake }) => {
        const points = JSON.stringify(rake.points);
        return !rake.dragging && JSON.stringify(seen) === points && points !== JSON.stringify(was);
    });
    return same.rake;
}

function distance(a: Vec3, b: Vec3): number {
    return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

function middle([a, b]: Vec3[]): Vec3 {
    return [(a![0] + b![0]) / 2, (a![1] + b![1]) / 2, (a![2] + b![2]) / 2];
}

async function onScreen(points: Vec3[]): Promise<{ x: number; y: number }[]> {
    return page.evaluate((all) => all.map((point) => window.wakesurf!.project(point)!), points);
}

function angleOf(from: { x: number; y: number }, to: { x: number; y: number }): number {
    return Math.atan2(to.y - from.y, to.x - from.x);
}

function turn(from: number, to: number): number {
    return Math.atan2(Math.sin(to - from), Math.cos(to - from));
}

async function pixelAt(at: { x: number; y: number }): Promise<[number, number, number]> {
    return (await page.evaluate((point) => window.wakesurf!.pixelsAt([point]), at))[0]!;
}

/** But for the softened edge of a thin line. */
function expectColour(seen: [number, number, number], colour: string): void {
    seen.forEach((each, k) => expect(Math.abs(each - parseInt(colour.slice(1 + 2 * k, 3 + 2 * k), 16))).toBeLessThan(60));
}

describe('several rakes', () => {
    beforeAll(visit);

    /** Presses Tab until the control with this name, or id, has the focus. */
    async function tabTo(name: string): Promise<void> {
        for (let i = 0; i < 120; ++i) {
            await page.keyboard.press('Tab');
            const focused = await page.evaluate(() => {
                let at = document.activeElement;
                while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
                return [at?.id ?? '', at?.getAttribute('aria-label') ?? '', at?.textContent?.trim() ?? ''];
            });
            if (focused.includes(name)) return;
        }
        throw new Error(`Tab does not lead to ${name}`);
    }

    it('are made and changed by keyboard alone', async () => {
        const at = (await rakes()).length;
        const keys = page.keyboard;
        await tabTo('New rake');
        await keys.press('Enter');
        await eventually(surfaces, (each) => each.length === at + 1);
        await page.waitForFunction((index) => window.wakesurf!.rakes[index]?.chosen === true, at);

        await tabTo('End');
        const before = await shown();
        for (let i = 0; i < 3; ++i) await keys.press('Shift+ArrowRight');
        await keys.press('PageUp');
        const nudged = await recorded(at);
        expect(nudged.points[1]![0] - before[1]![0]).toBeCloseTo(1.5, 6);
        expect(nudged.points[1]![1] - before[1]![1]).toBeCloseTo(0.05, 6);
        expect(nudged.points[0]).toEqual(before[0]);

        await tabTo('End z');
        await keys.press('Control+A');
        await keys.type('4.25');
        await keys.press('Enter');
        await eventually(rakes, (each) => each[at]!.points[1]![2] === 4.25);
        await tabTo('Turn');
        const length = distance(...((await shown()) as [Vec3, Vec3]));
        await keys.press('ArrowLeft');
        await keys.press('Shift+ArrowLeft');
        const turned = await recorded(at);
        expect(distance(turned.points[0]!, turned.points[1]!)).toBeCloseTo(length, 9);
        expect(turned.points[0]).not.toEqual(before[0]);

        await tabTo('rake-name');
        await keys.press('Control+A');
        await keys.type('Upper sheet');
        await keys.press('Enter');
        await eventually(rakes, (each) => each[at]!.name === 'Upper sheet');
        await tabTo('direction');
        await keys.press('ArrowDown');
        await eventually(surfaces, (each) => each[at]!.direction === 'backward');
        // Out of the list, where the key would choose.
        await tabTo('Geometry');
        await keys.press('Control+Z');
        await eventually(surfaces, (each) => each[at]!.direction === 'forward');
        await keys.press('Control+Z');
        await eventually(rakes, (each) => each[at]!.name === `Rake ${at + 1}`);
        await keys.press('Control+Shift+Z');
        await eventually(rakes, (each) => each[at]!.name === 'Upper sheet');
    });

    it('are drawn apart, chosen by a click on their line, and each has its settings', async () => {
        const at = (await rakes()).length;
        await page.getByRole('button', { name: 'New rake' }).click();
        await page.waitForFunction((index) => window.wakesurf!.rakes[index]?.chosen === true, at);
        await finalSurface(page);
        const [first, ...others] = await ask(page, (hook) => hook.rakes);
        expect(others.map(({ colour }) => colour)).not.toContain(first!.colour);
        // A quarter along the other's line, clear of its middle.
        const [a, b] = await onScreen([...first!.shape.points] as Vec3[]);
        const quarter = { x: a!.x + 0.25 * (b!.x - a!.x), y: a!.y + 0.25 * (b!.y - a!.y) };
        expectColour(await pixelAt(quarter), first!.colour);
        await page.mouse.click(quarter.x, quarter.y);
        await page.waitForFunction(() => window.wakesurf!.rakes[0]!.chosen);
        const untouched = (await rakes())[at]!;
        await dragHandle(page, 0, 15, 10, 4);
        await recorded();
        await page.getByRole('textbox', { name: 'Seeds' }).fill('48');
        await page.keyboard.press('Enter');
        await page.getByRole('combobox', { name: 'Accuracy' }).selectOption('exact');
        await page.getByRole('combobox', { name: 'Interpolation' }).selectOption('smooth');
        await page.getByRole('combobox', { name: 'Separation' }).selectOption({ index: 3 });
        await page.getByRole('combobox', { name: 'Direction' }).selectOption('both');
        await eventually(surfaces, (each) => each[0]!.direction === 'both' && each[0]!.accuracy === 'exact');
        await eventually(surfaces, (each) => each[0]!.interpolation === 'smooth');
        const now = await surfaces();
        expect(now[0]!.separation).toBeCloseTo(4 * 0.1675, 2);
        expect(now[at]).toMatchObject({ direction: 'forward', accuracy: 'balanced', interpolation: 'linear' });
        expect((await eventually(rakes, (each) => each[0]!.seeds === 48))[at]).toEqual(untouched);
        await page.getByLabel('Colour of the rake').fill('#ff00ff');
        await eventually(rakes, (each) => each[0]!.colour === '#ff00ff');
        await finalSurface(page);
        const ends = await onScreen(await shown());
        expectColour(
            await pixelAt({ x: 0.3 * ends[0]!.x + 0.7 * ends[1]!.x, y: 0.3 * ends[0]!.y + 0.7 * ends[1]!.y }),
            '#ff00ff',
        );
    });
});

describe('a rake', () => {
    beforeAll(visit);

    it('is held by the mouse or a finger at its ends, its middle or beside it, in any projection', async () => {
        const start = await shown();
        await dragHandle(page, 0, 24, -18, 5);
        const moved = await shown();
        expect(moved[1]).toEqual(start[1]);
        expect((await recorded()).points[0]).toEqual(moved[0]);

        await dragHandle(page, 'middle', 30, 12, 5);
        const away = await shown();
        const by = away.map((point, i) => point.map((v, k) => v - moved[i]![k]!));
        by[0]!.forEach((v, k) => expect(v).toBeCloseTo(by[1]![k]!, 9));

        const before = await onScreen([middle(away), ...away]);
        const handle = (await ask(page, (hook) => hook.handleOnScreen('rotate')))!;
        await dragHandle(page, 'rotate', 40, 30, 6);
        const turned = await shown();
        const after = await onScreen([middle(turned), ...turned]);
        expect(distance(middle(turned), middle(away))).toBeLessThan(1e-9);
        expect(distance(turned[0]!, turned[1]!)).toBeCloseTo(distance(away[0]!, away[1]!), 9);
        const pointerTurn = turn(angleOf(before[0]!, handle), angleOf(before[0]!, { x: handle.x + 40, y: handle.y + 30 }));
        expect(Math.abs(pointerTurn)).toBeGreaterThan(0.3);
        // Seen in perspective a rake that leans towards the viewer turns a little more or less than the hand.
        expect(turn(angleOf(before[0]!, before[2]!), angleOf(after[0]!, after[2]!))).toBeCloseTo(pointerTurn, 0.8);
        await recorded();

        await page.getByRole('button', { name: 'Parallel' }).click();
        await dragHandle(page, 1, -10, 20, 4);
        await dragHandle(page, 'rotate', 25, 25, 4);
        await recorded();
        await page.getByRole('button', { name: 'Parallel' }).click();

        // By touch, from beside the handle: a finger is wide.
        const devtools = await context.newCDPSession(page);
        const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', at?: { x: number; y: number }): Promise<unknown> =>
            devtools.send('Input.dispatchTouchEvent', { type, touchPoints: at === undefined ? [] : [at] });
        const untouched = await shown();
        const end = (await ask(page, (hook) => hook.handleOnScreen(1)))!;
        const finger = { x: end.x + 12, y: end.y + 10 };
        await touch('touchStart', finger);
        for (let i = 1; i <= 5; ++i) await touch('touchMove', { x: finger.x + 8 * i, y: finger.y + 3 * i });
        await touch('touchEnd');
        const touched = await recorded();
        const [, under] = await onScreen(touched.points);
        expect(Math.hypot(under!.x - end.x - 40, under!.y - end.y - 15)).toBeLessThan(1);
        expect(touched.points[0]).toEqual(untouched[0]);
    });

    it('keeps to the axis that the hand is nearest to with Shift, or to a grid, and says so', async () => {
        const [, end] = await shown();
        await takeHandle(page, 1);
        const at = (await ask(page, (hook) => hook.handleOnScreen(1)))!;
        await page.keyboard.down('Shift');
        await page.mouse.move(at.x + 70, at.y - 12, { steps: 4 });
        await page.getByText('along x', { exact: true }).waitFor();
        const [, seen] = await onScreen(await shown());
        // Nearest to the pointer on the axis: off it by no more than the hand left the axis.
        expect(Math.hypot(seen!.x - at.x - 70, seen!.y - at.y + 12)).toBeLessThan(12);
        await page.mouse.up();
        await page.keyboard.up('Shift');
        const [, moved] = await shown();
        expect(moved![0] - end![0]).toBeGreaterThan(0.5);
        expect(moved!.slice(1)).toEqual(end!.slice(1));
        await page.getByText('along x', { exact: true }).waitFor({ state: 'hidden' });
        await recorded();

        await page.getByRole('checkbox', { name: 'Snap to a grid of 0.5' }).check();
        await takeHandle(page, 1);
        const from = (await ask(page, (hook) => hook.handleOnScreen(1)))!;
        await page.mouse.move(from.x + 50, from.y + 31, { steps: 4 });
        await page.getByText('grid 0.5', { exact: true }).waitFor();
        await page.mouse.up();
        const { points } = await recorded();
        for (const value of points[1]!) expect(value * 2).toBe(Math.round(value * 2));
        expect((await shown())[1]).toEqual(points[1]);
        await page.getByRole('checkbox', { name: 'Snap to a grid of 0.5' }).uncheck();
    });

    it('that someone else moves says who does, moves before the eyes, and cannot be taken meanwhile', async () => {
        const ann = await Guest.join(rig.server, session, { name: 'Ann', colour: '#cc79a7' });
        const { rake, kind, points, seeds } = (await rakes())[0]!;
        const moved = (by: number): Vec3[] => points.map(([x, y, z]) => [x + by, y, z]);
        const handle = (await ask(page, (hook) => hook.handleOnScreen(0)))!;
        await ann.call('rake.set', { rake, kind, points: moved(0.2), seeds, dragging: true });
        // Where her page has it at the moment, which may be ahead of the record.
        await ann.call('presence.update', { dragging: { rake, points: moved(-0.9) } });
        await page.getByText('Ann is moving this', { exact: true }).waitFor();
        await page.getByRole('button', { name: /Ann is moving it/ }).waitFor();
        await page.waitForFunction(() => window.wakesurf!.rakes[0]!.holder?.points !== undefined);
        expect(await ask(page, (hook) => hook.rakes[0]!.holder)).toEqual({ name: 'Ann', colour: '#cc79a7', points: moved(-0.9) });
        const ends = await onScreen(moved(-0.9));
        // Dashed, so somewhere along it.
        const along = [0.2, 0.21, 0.22, 0.23, 0.24, 0.25, 0.26, 0.27].map((part) => ({
            x: ends[0]!.x + part * (ends[1]!.x - ends[0]!.x),
            y: ends[0]!.y + part * (ends[1]!.y - ends[0]!.y),
        }));
        const seen = await page.evaluate((all) => window.wakesurf!.pixelsAt(all), along);
        expect(seen.some(([r, g, b]) => r > 150 && g < 150 && b > 120)).toBe(true);

        await page.mouse.move(handle.x, handle.y);
        await page.mouse.down();
        await page.mouse.move(handle.x + 12, handle.y, { steps: 3 });
        await page.mouse.up();
        expect(await shown()).toEqual(moved(0.2));
        await ann.call('rake.set', { rake, kind, points: moved(0.2), seeds, dragging: false });
        await ann.call('presence.update', { dragging: null });
        await page.getByText('Ann is moving this', { exact: true }).waitFor({ state: 'hidden' });

        await dragHandle(page, 0, 20, 10, 6);
        expect((await recorded()).points).not.toEqual(moved(0.2));
        // She was told meanwhile, and of the end.
        await eventually(
            () => Promise.resolve(ann.told),
            (told) => told.length > 1 && told.at(-1) === null,
        );
        expect(ann.told[0]!.points).toHaveLength(2);
        ann.leave();
        await finalSurface(page);
    });

    it('is a polyline with points added, moved and removed, or a circle with a centre, a size and a plane to hold on to', async () => {
        await restored();
        await page.getByRole('combobox', { name: 'Shape' }).selectOption('polyline');
        await eventually(rakes, (each) => each[0]!.points.length === 3);
        await dragHandle(page, 1, 40, -6, 5);
        const bent = await recorded();
        await page.getByRole('button', { name: 'Point 2', exact: true }).click();
        await page.getByRole('button', { name: 'Add point after' }).click();
        const more = (await eventually(rakes, (each) => each[0]!.points.length === 4))[0]!;
        more.points[2]!.forEach((v, k) => expect(v).toBeCloseTo((bent.points[1]![k]! + bent.points[2]![k]!) / 2, 9));
        await dragHandle(page, 2, 25, 4, 4);
        await recorded();
        await finalSurface(page);
        await page.getByRole('button', { name: 'Point 2', exact: true }).click();
        await page.getByRole('button', { name: 'Remove point' }).click();
        const less = (await eventually(rakes, (each) => each[0]!.points.length === 3))[0]!;
        expect(less.points[0]).toEqual(bent.points[0]);

        await page.getByRole('combobox', { name: 'Shape' }).selectOption('circle');
        const [circle] = await eventually(rakes, (each) => each[0]!.kind === 'circle');
        const [centre, rim, side] = circle!.points as [Vec3, Vec3, Vec3];
        expect(distance(centre, rim)).toBeCloseTo(distance(centre, side), 9);
        // Across the flow, which goes along x.
        for (const point of [rim, side]) expect(point[0]).toBeCloseTo(centre[0], 9);

        await dragHandle(page, 1, 3, 22, 5);
        const smaller = await recorded();
        expect(distance(smaller.points[0]!, smaller.points[1]!)).toBeLessThan(distance(centre, rim) * 0.9);
        expect(smaller.points).toHaveLength(3);
        for (const point of smaller.points) expect(point[0]).toBeCloseTo(centre[0], 9);

        await dragHandle(page, 2, 6, -4, 4);
        const tipped = await recorded();
        const radius = distance(smaller.points[0]!, smaller.points[1]!);
        expect(tipped.points[0]).toEqual(smaller.points[0]);
        for (const i of [1, 2]) expect(distance(tipped.points[0]!, tipped.points[i]!)).toBeCloseTo(radius, 9);
        expect(distance(tipped.points[2]!, smaller.points[2]!)).toBeGreaterThan(0.05);

        await page.getByRole('textbox', { name: 'Radius' }).fill('1.5');
        await page.keyboard.press('Enter');
        await eventually(rakes, (each) => Math.abs(distance(each[0]!.points[0]!, each[0]!.points[2]!) - 1.5) < 1e-9);
        // Out through the side wall: it stays a circle, inside.
        await page.getByRole('textbox', { name: 'Centre y' }).fill('3.9');
        await page.keyboard.press('Enter');
        const [inside] = await eventually(rakes, (each) => each[0]!.points[0]![1] > 2);
        expect(inside!.kind).toBe('circle');
        expect(inside!.points[0]![1]).toBeLessThan(3);
        await finalSurface(page);
    });

    it('is changed, copied and deleted by clicks alone', async () => {
        await restored();
        const click = (name: string, exact = true): Promise<void> => page.getByRole('button', { name, exact }).click();
        const start = await shown();
        await click('End');
        await click('End plus x');
        await click('End minus z');
        const nudged = await recorded();
        expect(nudged.points[1]![0] - start[1]![0]).toBeCloseTo(0.05, 9);
        expect(nudged.points[1]![2] - start[1]![2]).toBeCloseTo(-0.05, 9);

        // On the surface of the nudged rake, where the picture shows it: beside it the end would be kept inside the domain.
        await expectServersMesh(rig.server, page);
        const at = await ask(page, (hook) => {
            const seen = hook.vertices(7).map(({ point }) => hook.project(point)!);
            return seen.slice(Math.floor(seen.length / 3)).find((place) => typeof hook.pick(place)?.surface === 'string')!;
        });
        await click('Place End with a click');
        await page.mouse.click(at.x, at.y);
        const placed = await recorded(0, nudged.points);
        const [seen] = await onScreen([placed.points[1]!]);
        expect(Math.hypot(seen!.x - at.x, seen!.y - at.y)).toBeLessThan(1.5);

        await click('Turn left');
        await click('Add point after');
        expect((await eventually(rakes, (each) => each[0]!.kind === 'polyline'))[0]!.points).toHaveLength(3);
        await click('Undo');
        await eventually(rakes, (each) => each[0]!.kind === 'line');
        await click('Duplicate');
        const two = await eventually(rakes, (each) => each.length === 2);
        expect(two[1]!.name).toBe('Rake 1 copy');
        await eventually(surfaces, (each) => each.length === 2);
        await page.waitForFunction(() => window.wakesurf!.rakes[1]?.chosen === true);
        await click('Delete');
        await eventually(rakes, (each) => each.length === 1);
        await click('Undo');
        await eventually(rakes, (each) => each.length === 2);
        expect(await surfaces()).toHaveLength(2);
        await page.getByRole('list', { name: 'In the picture' }).getByRole('button').first().click();
        await page.waitForFunction(() => window.wakesurf!.rakes[0]!.chosen);
    });
});
