// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import type { SurfaceKind } from '../../protocol/messages.ts';
import { sampleStatistics } from '../../testing/records.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './surfacePanel.ts';

let bench: PageBench;
let panel: ShownPanel;

beforeEach(async () => {
    bench = new PageBench();
    panel = await ShownPanel.of('wakesurf-surface', bench);
});

const surface = () => bench.surfaces[0]!;
const choose = (kind: string): Promise<void> => panel.click('[type=radio]', kind);
const direct = (direction: string): Promise<void> => panel.enter('#direction', 'Direction', direction);
const note = () => panel.get<HTMLElement>('#kind-note').textContent;
const direction = () => panel.get<HTMLSelectElement>('#direction');

describe('the kinds of surface', () => {
    it('are those of the server, and move only where the data do', async () => {
        const kinds = () => panel.all('[type=radio]') as HTMLInputElement[];
        const offered = () => kinds().flatMap(({ disabled, value }) => (disabled ? [] : [value]));
        expect(offered()).toEqual(['stream', 'path', 'streak', 'time']);
        bench.state.capabilities.value = ['stream', 'streak'];
        await rested();
        expect(offered()).toEqual(['stream', 'streak']);
        bench.state.dataset.value = { ...bench.state.dataset.value!, times: [0] };
        await rested();
        expect(offered()).toEqual(['stream']);
        expect(note()).toBe('The data have one time, 0: only stream surfaces and isosurfaces can be shown.');
        bench.state.dataset.value = { ...bench.state.dataset.value, steady: true };
        await rested();
        expect(note()).toBe('The flow does not change: a stream surface is also the streak surface.');
    });

    it('that move are said to stay short where the data last for little of the way', async () => {
        expect(panel.all('#kind-note')).toEqual([]);
        bench.state.dataset.value = { ...bench.state.dataset.value!, times: [8.5, 9, 9.5] };
        await rested();
        expect(note()).toBe('The data last 1, and the fluid takes 20 to pass: surfaces that move stay short.');
    });

    it('releases a streak surface until the slider says', async () => {
        await choose('Streak');
        expect(surface()).toMatchObject({ kind: 'streak', from: 8.5, to: 16 });
        expect(surface().releaseUntil).toBeUndefined();
        await panel.enter('#release-until', 'Release until', 3.75);
        expect(surface().releaseUntil).toBeCloseTo(12.25);
        await panel.click('#release', /Keep releasing/);
        expect(surface().releaseUntil).toBeUndefined();
        await panel.click('#release', /Keep releasing/);
        expect(surface().releaseUntil).toBeCloseTo(12.25);
        // Of what was released until then, half of the time is as old as a particle gets.
        await panel.click('#release', /Keep releasing/);
        await panel.click('#live-on', 'Particles live on');
        expect(surface().life).toBeCloseTo(3.75);
    });

    it('sweeps a time surface across the flow until told otherwise', async () => {
        await choose('Time');
        // Released late enough that it has not left the domain.
        expect(surface()).toMatchObject({ kind: 'time', to: 16 });
        expect(surface().from).toBeGreaterThan(8.5);
        const { sweep } = surface();
        expect(sweep?.map((each) => each !== 0)).toEqual([false, true, false]);
        await panel.enter('input', 'Sweep along z', 0.5);
        expect(surface().sweep).toEqual([0, sweep![1], 0.5]);
        await choose('Path');
        expect(surface().sweep).toBeUndefined();
        expect(panel.text).toContain('To the end of the data.');
        const slider = panel.get('#length');
        expect([slider.value, slider.max]).toEqual([String(surface().to - surface().from), slider.value]);
        await panel.enter('#length', 'Integration time', slider.min);
        expect(surface().to).toBeCloseTo(surface().from + 7 / 100);
    });

    it('goes back in time as the direction says, released where the data have time for it, and shows so to who comes later', async () => {
        await direct('backward');
        expect(surface()).toMatchObject({ kind: 'stream', direction: 'backward', from: 16 });
        expect(surface().to).toBeLessThan(16);
        await choose('Streak');
        expect(surface()).toMatchObject({ kind: 'streak', direction: 'backward', from: 16, to: 8.5 });
        expect(panel.text).toContain('Shown at 8.5 now, no longer at 16:');
        panel = await ShownPanel.of('wakesurf-surface', bench);
        expect(panel.get('[type=radio]:checked').value).toBe('streak');
        expect(direction().value).toBe('backward');
    });

    it('offers both directions only where a surface need not be there at one time, and says what becomes of them', async () => {
        expect(direction().options).toHaveLength(3);
        await direct('both');
        await choose('Path');
        expect(surface()).toMatchObject({ kind: 'path', direction: 'both', from: 8.5, to: 16 });
        expect(panel.text).toContain('Forward only: the data begin at its release');
        bench.playback.release(11);
        await rested();
        expect(surface()).toMatchObject({ direction: 'both', from: 11, to: 16 });
        expect(panel.text).toContain('Back to 8.5 only, where the data begin');
        await choose('Streak');
        expect(surface()).toMatchObject({ kind: 'streak', direction: 'forward', from: 11, to: 16 });
        expect(panel.text).toContain('A streak surface goes one way in time: this one goes forward.');
        expect(direction().value).toBe('forward');
        expect(direction().options).toHaveLength(2);
    });
});

describe('an isosurface', () => {
    const surface = () => bench.surfaces.at(-1)!;

    it('takes a field and any level of it, beside the surfaces of rakes', async () => {
        bench.state.dataset.value = { ...bench.state.dataset.value!, surfaceFields: ['U', 'q_criterion', 'error'] };
        await bench.edits.actions.newIsosurface();
        await rested();
        expect(surface().rake).toBeUndefined();
        expect(surface()).toMatchObject({ kind: 'level', field: 'U', level: 0.896, from: 8.5, to: 16 });
        expect(panel.get<HTMLElement>('#level-range').textContent).toBe('0.002 to 1.79 in the data.');
        await panel.enter('#level', 'Level', 1.5);
        expect(surface().level).toBe(1.5);
        const fields = [...panel.get<HTMLSelectElement>('#level-field').options].map(({ value }) => value);
        expect(fields).toEqual(['U', 'q_criterion']);
        await panel.enter('#level-field', 'Field', 'q_criterion');
        expect(surface()).toMatchObject({ field: 'q_criterion', level: 0.91 });
        // What the data have of it is known once the server has looked.
        expect(panel.all('#level-range')).toEqual([]);
        const stats = sampleStatistics({ surface: 'surface-2', fieldRange: [-3, 4] });
        bench.state.outcomes.value = new Map([['surface-2', stats]]);
        await rested();
        expect([panel.get('#level').min, panel.get('#level').max]).toEqual(['-3', '4']);
        for (const level of [1e6, 0.5]) {
            await panel.enter('#level-value', 'Level', level);
            expect(surface()).toMatchObject({ field: 'q_criterion', level });
        }
        expect(bench.surfaces[0]!.kind).toBe('stream');
        bench.edits.chooseRake('rake-1');
        await rested();
        expect(panel.all('#level-field')).toEqual([]);
    });
});

describe('first and last times', () => {
    it('are typed where the length is chosen, and stop at the ends of the data in words', async () => {
        await choose('Streak');
        await panel.enter('#time-from', 'From', 11.5);
        expect(surface()).toMatchObject({ from: 11.5, to: 16 });
        await panel.enter('#time-to', 'To', 12.5);
        expect(surface()).toMatchObject({ from: 11.5, to: 12.5 });
        await panel.enter('#time-to', 'To', 1000);
        expect(surface().to).toBe(16);
        expect(panel.text).toContain('t = 1000 is outside the data');
        await panel.enter('#time-to', 'To', 11.5);
        expect(panel.text).toContain('It ends at another time than it begins.');
        expect(surface()).toMatchObject({ from: 11.5, to: 16 });
        expect(panel.get('#time-to').value).toBe('16');
    });
});

describe('a rake', () => {
    it('has several surfaces or none, each with its kind', async () => {
        expect(panel.all('#which-surface')).toEqual([]);
        await panel.press('Add surface');
        expect(bench.surfaces).toHaveLength(2);
        await choose('Path');
        expect(bench.surfaces.map(({ kind }): SurfaceKind => kind)).toEqual(['stream', 'path']);
        await panel.enter('#which-surface', 'Surface', 'surface-1');
        expect(panel.get('[type=radio]:checked').value).toBe('stream');
        for (const left of [1, 0]) {
            await panel.press('Delete surface');
            expect(bench.surfaces).toHaveLength(left);
        }
        expect(panel.text).toContain('This rake has no surface.');
        expect(bench.rakes).toHaveLength(1);
    });
});

describe('a surface that someone may only look at', () => {
    it('has controls that cannot be used', async () => {
        bench.state.role.value = 'viewer';
        await rested();
        for (const id of ['#length', '#direction', '#separation', '[value=path]']) {
            expect(panel.get(id).matches('fieldset:disabled *'), id).toBe(true);
        }
    });
});
