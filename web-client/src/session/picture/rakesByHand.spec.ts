import { describe, expect, it } from 'vitest';
import type { RakeMove, RakeUser } from '../../scene/rake/rakeInteraction.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { connectRakes, type RakesByHandOptions } from './rakesByHand.ts';

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
