// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { beforeEach, describe, expect, it } from 'vitest';
import type { StepHeld } from '../../protocol/messages.ts';
import { PageBench, put } from '../../testing/pageBench.ts';
import { displayedOf } from '../../testing/records.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import { type KeyPress, timeKey } from './timeBar.ts';
import './timeBar.ts';

const press = (key: string, more: Partial<KeyPress> = {}): KeyPress => ({
    ...{ key, ctrlKey: false, altKey: false, metaKey: false, defaultPrevented: false, ...more },
});

describe('timeKey', () => {
    it('knows three keys', () => {
        expect([' ', ',', '.', 'a', 'Enter'].map((key) => timeKey(press(key), false))).toEqual([
            ...['toggle', 'back', 'forward', null, null],
        ]);
    });

    it('leaves keys to the elements that want them', () => {
        expect(timeKey(press(' '), true)).toBeNull();
        expect(timeKey(press('.'), true)).toBe('forward');
        expect(timeKey(press(' ', { ctrlKey: true }), false)).toBeNull();
        expect(timeKey(press(' ', { defaultPrevented: true }), false)).toBeNull();
    });
});

let bench: PageBench;
let bar: ShownPanel;
let copies: number;

beforeEach(async () => {
    bench = new PageBench();
    copies = 0;
    const ownCopy = { possible: signal(true), begin: () => void ++copies };
    bar = await ShownPanel.of('wakesurf-time-bar', Object.assign(bench, { ownCopy }));
});

const clock = () => bench.state.clock.value!;
const surface = () => bench.surfaces[0]!;
const typed = (): string => bar.get('#go-to').value;

async function streak(): Promise<void> {
    bench.chooseKind('streak');
    await rested();
}

/** Returns the place of a mark of the line, in per cent from its left end. */
function placed(selector: string, name: string): number {
    return parseFloat(bar.get<HTMLElement>(selector).getAttribute(name)!);
}

function percent(time: number): number {
    return (100 * (time - 8.5)) / 7.5;
}

async function keyOfPage(key: string): Promise<void> {
    document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, composed: true }));
    await rested();
}

describe('the timeline', () => {
    it('shows which time-steps are in memory, each at its time', async () => {
        const steps = Array.from({ length: 16 }, (_, i): StepHeld => [i < 6 ? 10 : 0, 0]);
        bench.state.heldSteps.value = { steps, whole: 10 };
        await rested();
        const marks = bar.all('[data-state]');
        expect(marks.map((mark) => mark.getAttribute('data-state'))).toEqual(
            steps.map(([held]) => (held > 0 ? 'resident' : 'cold')),
        );
        for (const [i, mark] of marks.entries()) {
            const hollow = mark.querySelector('.hollow')!;
            const [x, width] = ['x', 'width'].map((name) => parseFloat(hollow.getAttribute(name)!)) as [number, number];
            expect(x + width / 2).toBeCloseTo(percent(8.5 + i / 2), 1);
        }
        // Full or hollow: not by colour alone.
        expect(bar.all('.filled')).toHaveLength(6);
        expect(bar.get<HTMLElement>('#resident').textContent).toBe('6 of 16 time-steps in memory');
    });

    it('plays, stops, steps and goes where it is told, on the clock of the session', async () => {
        await streak();
        await bar.press('Play');
        const played = { playing: true, loop: true, from: 8.5, to: 16, speed: 0.75 };
        expect(clock()).toMatchObject(played);
        await bar.enter('#speed', 'Speed', 2);
        expect(clock()).toMatchObject({ ...played, speed: 1.5 });
        await bar.press('Loop');
        expect(clock()).toMatchObject({ ...played, speed: 1.5, loop: false });
        await keyOfPage(' ');
        expect(clock().playing).toBe(false);
        await bar.enter('#go-to', 'Shown at time', 12.25);
        expect(clock().time).toBe(12.25);
        // Typed, these are characters, not commands.
        await bar.key('#go-to', undefined, '.');
        expect(clock().time).toBe(12.25);
        for (const [key, time] of [
            ['.', 12.5],
            ['.', 13],
            [',', 12.5],
            [',', 12],
        ] as const) {
            await keyOfPage(key);
            expect(clock().time).toBe(time);
        }
        await bar.press('To the end');
        expect(clock().time).toBe(16);
        await bar.enter('#speed', 'Speed', 0.25);
        await bar.press('Play');
        expect(clock()).toMatchObject({ playing: true, speed: 0.1875, loop: false });
        // Without loop the server stops it at the end.
        bench.tell([put('clock', 'clock', { ...clock(), playing: false, time: 16 })]);
        await rested();
        expect(bar.all('button', 'Play')).toHaveLength(1);
    });

    it('shows four digits of the time that runs, always as many, and what was typed as it was typed', async () => {
        await streak();
        const shown = async (time: number, playing: boolean): Promise<string> => {
            bench.tell([put('clock', 'clock', { ...clock(), playing, time })]);
            // The picture that is there runs with the clock.
            bench.state.displayed.value = new Map([['surface-1', displayedOf('surface-1', { epoch: surface().epoch, time })]]);
            await rested();
            return typed();
        };
        expect(await shown(13.9826059345, true)).toBe('13.98');
        expect(await shown(9.5000000001, true)).toBe('9.50');
        expect(await shown(13.9826059345, false)).toBe('13.98');
        expect(await shown(9.5, false)).toBe('9.5');
        await bar.enter('#go-to', 'Shown at time', '9,12345');
        expect([clock().time, typed()]).toEqual([9.12345, '9.12345']);
    });

    it('keeps what is being typed while time passes, and goes on with it afterwards', async () => {
        await streak();
        bar.get('#go-to').focus();
        const before = typed();
        bench.tell([put('clock', 'clock', { ...clock(), time: 13 })]);
        await rested();
        expect(typed()).toBe(before);
        bar.get('#go-to').blur();
        await rested();
        expect(typed()).toBe('13');
    });

    it('leaves space alone where it would do something else, and plays where it would do nothing', async () => {
        await streak();
        const focused = async (markup: string): Promise<boolean> => {
            bench.tell([put('clock', 'clock', { ...clock(), playing: false })]);
            const host = document.createElement('div');
            host.innerHTML = markup;
            document.body.append(host);
            const event = new KeyboardEvent('keydown', { key: ' ', bubbles: true, composed: true, cancelable: true });
            host.firstElementChild!.dispatchEvent(event);
            await rested();
            return clock().playing;
        };
        expect(await focused('<input type="radio" checked>')).toBe(true);
        expect(await focused('<button role="tab" aria-selected="true">Look</button>')).toBe(true);
        for (const taker of ['<input type="radio">', '<button>Loop</button>', '<input type="checkbox" checked>', '<input>']) {
            expect(await focused(taker), taker).toBe(false);
        }
    });

    it('goes by time-steps with arrow keys, and by five with page keys', async () => {
        await streak();
        for (const [key, time] of [
            ['Home', 8.5],
            ['ArrowRight', 9],
            ['PageUp', 11.5],
            ['End', 16],
        ] as const) {
            await bar.key('#clock', 'Shown at', key);
            expect(clock().time).toBe(time);
        }
    });

    it('plays a stream surface by freezing the field at one time-step after the other', async () => {
        await bar.enter('#speed', 'Speed', 2);
        await bar.press('Play');
        const seen: number[] = [];
        for (let i = 0; i < 60 && seen.length < 3; ++i) {
            await bench.time.pass(100);
            await rested();
            if (surface().from !== seen.at(-1) && surface().from !== 16) seen.push(surface().from);
        }
        // It began at the last time-step, and plays from the first.
        expect(seen).toEqual([8.5, 9, 9.5]);
        await bar.press('Pause');
        await bench.time.pass(2000);
        expect(surface().from).toBe(9.5);
        await bar.press('Next time-step');
        expect(surface().from).toBe(10);
        expect(typed()).toBe('10');
    });

    it('shows both sides of a path surface that goes both ways', async () => {
        bench.chooseKind('path');
        await rested();
        bench.tell([put('surface', 'surface-1', { ...surface(), from: 11, to: 13, direction: 'both' })]);
        await rested();
        expect(placed('.shown', 'x')).toBeCloseTo(percent(9), 2);
        expect(placed('.shown', 'x') + placed('.shown', 'width')).toBeCloseTo(percent(13), 2);
        bench.tell([put('clock', 'clock', { ...clock(), time: 12 })]);
        await rested();
        expect(placed('.other', 'x1')).toBeCloseTo(percent(10), 2);
    });

    it('has a handle for the release, which goes from time-step to time-step', async () => {
        await streak();
        await bar.key('#time', 'Release', 'ArrowRight');
        expect(surface().from).toBe(9);
        await bar.enter('#time', 'Release', 10.6);
        expect([surface().from, surface().to]).toEqual([10.5, 16]);
        expect(placed('.shown', 'x')).toBeCloseTo(percent(10.5), 2);
        expect(placed('.shown', 'x') + placed('.shown', 'width')).toBeCloseTo(percent(16), 2);
    });

    it('follows others who move the clock, and lets no viewer play', async () => {
        await streak();
        bench.tell([put('clock', 'clock', { ...clock(), time: 13 })]);
        await rested();
        expect([typed(), bar.get('#clock').value]).toEqual(['13', '13']);
        bench.state.role.value = 'viewer';
        await rested();
        for (const button of bar.within('[aria-label="Time controls"]').all('button')) {
            expect(button.matches(':disabled')).toBe(true);
        }
        await keyOfPage(' ');
        expect(bench.asked('time.play')).toEqual([]);
        await bar.press('Continue in a copy');
        expect(copies).toBe(1);
    });
});
