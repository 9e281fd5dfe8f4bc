// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import type { SurfaceStats } from '../../protocol/messages.ts';
import type { SurfaceStatus } from '../../state/appState.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { displayedOf, sampleStatistics } from '../../testing/records.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './statusPanel.ts';

let bench: PageBench;
let panel: ShownPanel;
let stopped: number;

beforeEach(async () => {
    bench = new PageBench();
    stopped = 0;
    const progress = { stop: () => ++stopped };
    panel = await ShownPanel.of('wakesurf-status', Object.assign(bench, { progress, mesh: {} }));
});

const surface = () => bench.surfaces[0]!;
const status = (): string | null => panel.get<HTMLElement>('[role=status]').textContent;

/** What the server has counted on the state that is shown. */
async function counted(change: Partial<SurfaceStats>): Promise<void> {
    const stats = { ...sampleStatistics({ surface: 'surface-1' }), ...change };
    bench.state.outcomes.value = new Map([['surface-1', stats]]);
    await rested();
}

describe('a surface that is there', () => {
    it('is final, with what 99 % of its vertices keep within', async () => {
        await counted({ error99: 0.002 });
        expect(status()).toMatch(/^Final, 99 % of vertices within \S+$/);
    });

    it('says how far interpolating between stored times may put it off, or why that is not said', async () => {
        const between = (): string => panel.get<HTMLElement>('#between-times').textContent.trim();
        bench.chooseKind('streak');
        await rested();
        await counted({ kind: 'streak', intervalPending: true, intervalLeftOut: 'it is not estimated yet' });
        expect(between()).toBe('Between stored times: being estimated');
        await counted({ intervalError99: 0.412, separation: 0.02, intervalUnresolved: 0.123, advisedInterval: 0.104 });
        expect(between()).toBe(
            'Between stored times: 99 % within 0.41, 12 % not resolved; data every 0.1 would bring it to 0.02',
        );
        await counted({ intervalError99: 0.001, separation: 0.02, intervalUnresolved: 0.004, advisedInterval: 3 });
        expect(between()).toBe('Between stored times: 99 % within 0.001, less than 1 % not resolved');
        await counted({ kind: 'streak', intervalLeftOut: 'the surface uses 3 stored times, and at least 5 are needed' });
        expect(between()).toBe('Between stored times: the surface uses 3 stored times, and at least 5 are needed');
    });

    it('says to what its quad limit made it coarser, and is as asked for once the limit is raised', async () => {
        await bench.worker.call('surface.set', { ...surface(), maxQuads: 500 });
        await counted({ coarsened: true, separation: 0.23456 });
        expect(status()).toBe('Coarsened to 0.2346: raise the quad limit');
        expect(panel.text).toContain('500 quads are too few for the separation asked for.');
        await panel.press('Allow 2 000');
        expect(surface().maxQuads).toBe(2000);
        await counted({ coarsened: false });
        expect(status()).toMatch(/^Final/);
    });

    it('says why it is empty', async () => {
        const empty = {
            reason: 'obstacle',
            message: 'the whole rake lies inside the body',
            hint: 'move the rake into the fluid',
        };
        await counted({ empty } as Partial<SurfaceStats>);
        expect(status()).toBe('Nothing to see');
        expect(panel.get<HTMLElement>('#empty-reason').textContent).toBe(
            'The whole rake lies inside the body: move the rake into the fluid.',
        );
    });

    it('says why it cannot be made', async () => {
        const text = 'level 1000000 is outside the range of q_criterion at t = 16, -3 to 4';
        bench.state.surfaceErrors.value = new Map([['surface-1', { epoch: surface().epoch, text, stopped: false }]]);
        await rested();
        expect(status()).toBe('Not computed');
        expect(panel.text).toContain(text);
        expect(panel.all('button', /^Compute/)).toEqual([]);
    });

    it('has its quality asked for on demand, once a state', async () => {
        const terminated = { domain: 12, time: 400, obstacle: 0, stagnation: 0, budget: 0 };
        const counts = { vertices: 1000, approximated: 50, vertexSteps: 12_345, terminated };
        bench.answers['surface.stats'] = () => sampleStatistics({ surface: 'surface-1', ...counts });
        expect(bench.asked('surface.stats')).toEqual([]);
        const quality = panel.get<HTMLDetailsElement>('#quality');
        quality.open = true;
        quality.dispatchEvent(new Event('toggle'));
        await rested();
        expect(bench.asked('surface.stats')).toEqual([{ surface: 'surface-1' }]);
        const shown = new Map(panel.all('[data-name]').map((row) => [row.getAttribute('data-name'), row.textContent]));
        const rows = ['approximated', 'domain', 'time', 'vertexSteps'].map((name) => shown.get(name));
        expect(rows).toEqual(['5.0 %', '12', '400', '12\u202f345']);
        // Why curves ended: those that never came are left out.
        const reasons = Object.keys(terminated).filter((reason) => shown.has(reason));
        expect(reasons).toEqual(['domain', 'time']);
    });
});

describe('a surface that takes long', () => {
    const computing: SurfaceStatus = {
        ...{ surface: 'surface-1', fraction: 0.4, message: '', time: 11.25, quads: 12_345, remaining: 8 },
        lasting: 'a while',
    };

    async function takes(change: Partial<SurfaceStatus>): Promise<void> {
        bench.state.progress.value = { ...computing, ...change };
        await rested();
    }

    beforeEach(async () => {
        bench.chooseKind('streak');
        await rested();
        bench.state.displayed.value = new Map([
            ['surface-1', displayedOf('surface-1', { epoch: surface().epoch, phase: 'coarse' })],
        ]);
    });

    it('says how far it is, in time and quads, once people have waited', async () => {
        await takes({ lasting: 'briefly' });
        expect(panel.get<HTMLProgressElement>('progress', 'Surface').getAttribute('value')).toBe('0.4');
        expect(panel.all('#standing')).toEqual([]);
        await takes({});
        expect(panel.get<HTMLElement>('#standing').textContent).toBe('t = 11.25 of 16, 12\u202f345 quads, about 8 s left');
        await panel.press('Stop');
        expect(stopped).toBe(1);
    });

    it('can be had faster, or until where it has come', async () => {
        const { separation } = surface();
        await takes({ lasting: 'long' });
        const offers = () => panel.within('[aria-label="Instead of waiting"]');
        await offers().press('Until t = 11.25');
        expect(surface()).toMatchObject({ from: 8.5, to: 11.25 });
        await offers().press('Fast accuracy');
        expect(surface().accuracy).toBe('fast');
        await offers().press(/^Separation /);
        expect(surface().separation).toBeCloseTo(2 * separation, 6);
        await takes({ lasting: 'long', time: null });
        expect(offers().all('button', /^Until/)).toEqual([]);
    });

    it('is computed again on request where it was stopped', async () => {
        const text = 'stopped by Ada';
        bench.state.surfaceErrors.value = new Map([['surface-1', { epoch: surface().epoch, text, stopped: true }]]);
        await rested();
        expect(status()).toBe('Stopped before it was final');
        expect(panel.text).toContain(text);
        const { rev } = surface();
        await panel.press('Compute it again');
        expect(surface().rev).toBe(rev + 1);
    });
});
