import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import { displayedOf, sampleStatistics } from '../../testing/records.ts';
import type { SurfaceRecord, SurfaceStats } from '../../protocol/messages.ts';
import type { DisplayedSurface, Stage } from '../../state/appState.ts';
import { SurfaceOutcomes } from './surfaceOutcomes.ts';

function displayed(stateSum: number, phase: DisplayedSurface['phase'] = 'final'): ReadonlyMap<string, DisplayedSurface> {
    return new Map([['s1', displayedOf('s1', { stateSum, phase })]]);
}

function bench() {
    const asked: string[] = [];
    let answer: SurfaceStats | Error = sampleStatistics({ stateSum: 7, coarsened: true });
    const state = {
        displayed: signal(displayed(7, 'coarse')),
        outcomes: signal<ReadonlyMap<string, SurfaceStats>>(new Map()),
        stage: signal<Stage>('running'),
        surfaces: signal<ReadonlyMap<string, SurfaceRecord>>(new Map([['s1', {} as SurfaceRecord]])),
    };
    const worker = {
        call: (method: string) => {
            asked.push(method);
            return answer instanceof Error ? Promise.reject(answer) : Promise.resolve(answer);
        },
    } as unknown as ConstructorParameters<typeof SurfaceOutcomes>[0]['worker'];
    const outcomes = new SurfaceOutcomes({ state, worker });
    return { state, asked, outcomes, answers: (next: SurfaceStats | Error) => (answer = next) };
}

describe('the outcome of a surface', () => {
    it('is asked for once where a page shows what was finished before it came', async () => {
        const { state, asked } = bench();
        expect(asked).toEqual([]);
        state.displayed.value = displayed(7);
        await Promise.resolve();
        state.displayed.value = displayed(7);
        expect(asked).toEqual(['surface.stats']);
        expect(state.outcomes.value.get('s1')?.coarsened).toBe(true);
    });

    it('is not asked for where the server has told it', () => {
        const { state, asked, outcomes } = bench();
        outcomes.done(sampleStatistics({ stateSum: 9 }));
        state.displayed.value = displayed(9);
        expect(asked).toEqual([]);
    });

    it('goes with the surface, and does not come back with a late answer', async () => {
        const { state, outcomes } = bench();
        state.displayed.value = displayed(7);
        await Promise.resolve();
        expect([...state.outcomes.value.keys()]).toEqual(['s1']);
        state.surfaces.value = new Map();
        expect(state.outcomes.value.size).toBe(0);
        outcomes.done(sampleStatistics({ stateSum: 9 }));
        expect(state.outcomes.value.size).toBe(0);
    });

    it('is asked for again after a failure', async () => {
        const { state, asked, answers } = bench();
        answers(new Error('the connection was lost'));
        state.displayed.value = displayed(7);
        await new Promise((done) => setTimeout(done));
        state.displayed.value = displayed(7);
        expect(asked).toEqual(['surface.stats', 'surface.stats']);
    });
});
