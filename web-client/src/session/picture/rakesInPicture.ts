// The session's rakes in the scene: each as its record says, the active one as the user has it, those that others move with their name and
// colour and, where their page says so, where they have it at the moment; and what the user does to them in the picture as edits for the
// server, which others see while the hand still moves.
import { effect } from '@preact/signals-core';
import type { RakeRecord } from '../../protocol/messages.ts';
import type { DrawnRake, RakeHolder } from '../../scene/rake/rakeLayer.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { shows } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { Edits } from '../edits/edits.ts';
import type { People } from '../people/people.ts';
import type { OwnCopy } from '../sessions/ownCopy.ts';

const ofNobody = '#ffffff';

export function showRakes(state: AppState, view: ViewState, scene: FlowScene): void {
    effect(() => {
        const { rakes, activeRake } = state;
        // Read in any case, or this would not be run again when it changes.
        const settled = state.rakeShape.value;
        if (scene.rakes.chosenId !== activeRake.value) scene.interaction.abandon();
        const own = scene.interaction.dragging ? scene.rakes.shape : settled;
        const visibility = view.visibility.value;
        const shown = [...rakes.value.values()].filter(({ rake }) => shows(visibility, rake, activeRake.value));
        const drawn = shown.map((record): DrawnRake => {
            const chosen = record.rake === activeRake.value;
            const colour = rakeColour(record, rakes.value);
            const locked = state.locked.value || visibility.lockedRakes.has(record.rake);
            const people = { locked, holder: holderOf(state, record), remark: whyNothing(state, record.rake) };
            return { rake: record.rake, shape: chosen ? own : record, colour, chosen, ...people };
        });
        scene.rakes.setRakes(drawn);
        scene.loop.request();
    });
    // Another tool takes the click that would have placed a point.
    effect(() => {
        if (view.tool.value !== 'place') scene.interaction.place(null);
    });
}

/** Why there is nothing to see where an empty surface of the rake would be. Empty: there is
 *  something. */
function whyNothing({ displayed, outcomes, surfaces }: AppState, rake: string): string {
    for (const { surface, rake: its } of surfaces.value.values()) {
        const outcome = outcomes.value.get(surface);
        const explained = its === rake && outcome?.stateSum === displayed.value.get(surface)?.stateSum;
        if (explained && outcome?.empty !== undefined) return outcome.empty.message;
    }
    return '';
}

/** Null where no other user holds it. */
export function holderOf(state: AppState, record: RakeRecord): RakeHolder | null {
    const by = record.dragging ? record.leasedBy : undefined;
    if (by === undefined || by === state.you.value) return null;
    const participant = state.participants.value.get(by);
    if (participant === undefined) return { name: by.startsWith('script') ? 'A script' : 'Someone', colour: ofNobody };
    const { name, colour, dragging } = participant;
    const points = dragging?.rake === record.rake ? { points: dragging.points } : {};
    return { name, colour, ...points };
}

export interface RakesByHandOptions {
    state: Pick<AppState, 'locked' | 'role' | 'activeRake' | 'notices'>;
    view: Pick<ViewState, 'tool' | 'visibility' | 'changeVisibility'>;
    scene: { interaction: Pick<FlowScene['interaction'], 'connect'> };
    edits: Pick<Edits, 'moveRake' | 'draggedNow' | 'chooseRake'>;
    people: Pick<People, 'tell'>;
    ownCopy: Pick<OwnCopy, 'begin'>;
}

export function connectRakes({ state, view, scene, edits, people, ownCopy }: RakesByHandOptions): void {
    scene.interaction.connect({
        mayMove: () => !state.locked.value,
        refused: () => announceLocked(state, view, ownCopy),
        hasPointer: () => view.tool.value === 'none' || view.tool.value === 'place',
        moved: (move) => {
            edits.moveRake(move);
            people.tell({ dragging: edits.draggedNow(move) });
        },
        chose: (rake) => edits.chooseRake(rake),
        placed: () => {
            if (view.tool.value === 'place') view.tool.value = 'none';
        },
    });
}

function announceLocked(
    { role, activeRake, notices }: RakesByHandOptions['state'],
    view: RakesByHandOptions['view'],
    copy: Pick<OwnCopy, 'begin'>,
): void {
    const rake = activeRake.value ?? '';
    const { lockedRakes } = view.visibility.value;
    if (role.value === 'viewer') {
        const act = (): void => void copy.begin();
        notices.sayUntil('press', 'locked', 'This link is for viewing: you cannot move rakes.', {
            label: 'Continue in a copy',
            act,
        });
    } else if (lockedRakes.has(rake)) {
        const act = (): void => {
            view.changeVisibility({ lockedRakes: new Set([...lockedRakes].filter((each) => each !== rake)) });
            notices.solved('locked');
        };
        notices.sayUntil('press', 'locked', 'You have locked this rake.', { label: 'Unlock', act });
    }
}

/**
 * For rakes that have none of their own: bright colours that differ from each other and from the maps that surfaces are
 * coloured with.
 */
export const rakeColours = ['#ff7a45', '#4cc2ff', '#ffd84d', '#ff7ab8', '#9be564', '#c79bff', '#ffffff', '#ff5c5c'] as const;

/** Its own, or one by its place among the rakes of the session. */
export function rakeColour(record: RakeRecord, rakes: ReadonlyMap<string, RakeRecord>): string {
    if (record.colour !== undefined && record.colour !== '') return record.colour;
    return byOrder([...rakes.keys()].indexOf(record.rake));
}

function byOrder(place: number): string {
    return rakeColours[Math.max(0, place) % rakeColours.length] ?? rakeColours[0];
}
