import { describe, expect, it } from 'vitest';
import type { Participant, Vec3 } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { displayedOf, rakeOf, sampleStatistics } from '../../testing/records.ts';
import type { DrawnRake } from '../../scene/rake/rakeLayer.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { holderOf, showRakes } from './rakeScene.ts';

const record = rakeOf('r1', { dragging: true, leasedBy: 'p2' });

function stateWith(ann: Partial<Participant> = {}): AppState {
    const state = new AppState();
    const person: Participant = { participant: 'p2', name: 'Ann', colour: '#009e73', role: 'editor', connected: true, ...ann };
    state.you.value = 'p1';
    state.participants.value = new Map([['p2', person]]);
    return state;
}

describe('who holds a rake', () => {
    it('is told by name and colour, and where they have it if they say so of this rake', () => {
        expect(holderOf(stateWith(), record)).toEqual({ name: 'Ann', colour: '#009e73' });
        const points: Vec3[] = [
            [0, 2, 0],
            [1, 2, 0],
        ];
        expect(holderOf(stateWith({ dragging: { rake: 'r1', points } }), record)).toMatchObject({ points });
        expect(holderOf(stateWith({ dragging: { rake: 'r2', points } }), record)).not.toHaveProperty('points');
    });

    it('is no one else where it is this page’s user, or no one', () => {
        expect(holderOf(stateWith(), { ...record, leasedBy: 'p1' })).toBeNull();
        expect(holderOf(stateWith(), { ...record, dragging: false })).toBeNull();
    });

    it('may be a script, or someone who has just left', () => {
        expect(holderOf(stateWith(), { ...record, leasedBy: 'script' })?.name).toBe('A script');
        expect(holderOf(stateWith(), { ...record, leasedBy: 'p9' })?.name).toBe('Someone');
    });
});

describe('a rake whose surface is empty', () => {
    it('says why beside it, until another state of the surface is there', () => {
        const { state } = new PageBench();
        let drawn: readonly DrawnRake[] = [];
        const rakes = { chosenId: null, setRakes: (all: readonly DrawnRake[]) => void (drawn = all) };
        const interaction = { abandon: () => undefined, place: () => undefined };
        showRakes(state, new ViewState(), { rakes, interaction, loop: { request: () => undefined } } as never);
        expect(drawn.map(({ remark }) => remark)).toEqual(['']);
        const message = 'the whole rake lies inside the body';
        const empty = { reason: 'inBody', message, hint: 'move it' } as const;
        const show = (stateSum: number): void =>
            void (state.displayed.value = new Map([['surface-1', displayedOf('surface-1', { stateSum })]]));
        show(7);
        state.outcomes.value = new Map([['surface-1', sampleStatistics({ surface: 'surface-1', stateSum: 7, empty })]]);
        expect(drawn.map(({ remark }) => remark)).toEqual([message]);
        show(8);
        expect(drawn.map(({ remark }) => remark)).toEqual(['']);
    });
});
