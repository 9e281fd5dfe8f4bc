import { describe, expect, it } from 'vitest';
import type { Participant, RakeRecord, Vec3 } from '../../protocol/messages.ts';
import type { RakeMove, RakeUser } from '../../scene/rake/rakeInteraction.ts';
import type { DrawnRake } from '../../scene/rake/rakeLayer.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { displayedOf, rakeOf, sampleStatistics } from '../../testing/records.ts';
import { connectRakes, holderOf, rakeColour, rakeColours, type RakesByHandOptions, showRakes } from './rakesInPicture.ts';

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

function bench() {
    const [state, view] = [new AppState(), new ViewState()];
    state.stage.value = 'running';
    const heard: unknown[] = [];
    const users: RakeUser[] = [];
    const edits: RakesByHandOptions['edits'] = {
        moveRake: ({ dragging }) => void heard.push(['moved', dragging]),
        draggedNow: ({ shape, dragging }) => (dragging ? { rake: 'r1', points: [...shape.points] } : null),
        chooseRake: (rake) => void heard.push(['chosen', rake]),
    };
    const people = { tell: (presence: object) => void heard.push(presence) };
    const ownCopy = { begin: async () => void heard.push('copied') };
    connectRakes({ state, view, edits, people, ownCopy, scene: { interaction: { connect: (made) => void users.push(made) } } });
    return { state, view, heard, user: users[0]! };
}

const move: RakeMove = { shape: { kind: 'line', points: [[0, 0, 1]] }, dragging: true, movedAt: 0 };

describe('the hand on a rake', () => {
    it('makes an edit, and others see where it is while it moves', () => {
        const { heard, user } = bench();
        user.moved(move);
        user.moved({ ...move, dragging: false });
        expect(heard).toEqual([
            ['moved', true],
            { dragging: { rake: 'r1', points: [[0, 0, 1]] } },
            ['moved', false],
            { dragging: null },
        ]);
    });

    it('chooses a rake by a click', () => {
        const { heard, user } = bench();
        user.chose('r2');
        expect(heard).toEqual([['chosen', 'r2']]);
    });

    it('moves nothing that may not be changed, nor while another tool has the pointer', () => {
        const { state, view, user } = bench();
        expect([user.mayMove(), user.hasPointer()]).toEqual([true, true]);
        view.tool.value = 'probe';
        expect(user.hasPointer()).toBe(false);
        state.role.value = 'viewer';
        expect(user.mayMove()).toBe(false);
    });

    it('is told that the rake is locked, and how to unlock it', () => {
        const { state, view, user } = bench();
        state.activeRake.value = 'r1';
        user.refused();
        expect(state.notices.all.value.size).toBe(0);
        view.changeVisibility({ lockedRakes: new Set(['r1', 'r2']) });
        user.refused();
        expect(state.notices.all.value.get('locked')).toBe('You have locked this rake.');
        state.notices.remedyOf('locked')?.act();
        expect([...view.visibility.value.lockedRakes]).toEqual(['r2']);
        expect(state.notices.all.value.size).toBe(0);
    });

    it('is offered a copy where a link is for looking', () => {
        const { state, heard, user } = bench();
        state.role.value = 'viewer';
        user.refused();
        expect(state.notices.all.value.get('locked')).toBe('This link is for viewing: you cannot move rakes.');
        state.notices.remedyOf('locked')?.act();
        expect(heard).toEqual(['copied']);
    });

    it('puts the tool away that has placed a point, and no other', () => {
        const { view, user } = bench();
        view.tool.value = 'place';
        expect(user.hasPointer()).toBe(true);
        user.placed();
        expect(view.tool.value).toBe('none');
        view.tool.value = 'measure';
        user.placed();
        expect(view.tool.value).toBe('measure');
    });
});

function rakesOf(...colours: (string | undefined)[]): Map<string, RakeRecord> {
    return new Map(colours.map((colour, i) => [`r${i}`, rakeOf(`r${i}`, { colour })]));
}

describe('the colour of a rake', () => {
    it('is its own, or else one by its place', () => {
        const rakes = rakesOf(undefined, '#123456', '');
        const colours = [...rakes.values()].map((each) => rakeColour(each, rakes));
        expect(colours).toEqual([rakeColours[0], '#123456', rakeColours[2]]);
    });
});
