// Lists what a first visit is led through: from dragging the rake to showing the result to another user.
import type { FlowScene } from '../../scene/scene.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';

/** Describes what the steps look at to see what the user has done. */
export interface TourFacts {
    state: Pick<AppState, 'rakes' | 'dataset' | 'times' | 'clock' | 'participants'>;
    view: Pick<ViewState, 'looks'>;
    edits: Pick<Edits, 'intent'>;
    scene: Pick<FlowScene, 'controls'>;
    /** Fingers, not a mouse. */
    touch: boolean;
    /** The panel is below the picture, not beside it. */
    narrow: boolean;
}

export interface TourStep {
    id: string;
    title: string;
    words: (facts: TourFacts) => string;
    /** Returns whether the user has done it; the tour goes on by itself then. */
    done: (facts: TourFacts, before: TourStart) => boolean;
}

/** Describes how things stood when the step began. */
export interface TourStart {
    rakeRevisions: string;
    pose: string;
    looks: ViewState['looks']['value'];
}

export function tourStart({ state, scene, view }: Omit<TourFacts, 'touch' | 'narrow'>): TourStart {
    const revisions = [...state.rakes.value.values()].map(({ rake, rev }) => `${rake} ${rev}`);
    return { rakeRevisions: revisions.join(), pose: JSON.stringify(scene.controls.pose), looks: view.looks.value };
}

export const tourSteps: readonly TourStep[] = [
    {
        id: 'drag',
        title: 'Drag the rake',
        words: () =>
            'The line with the round handles releases particles; the sheet shows where they go. ' +
            'Drag a handle: the surface follows, coarse at first, then final.',
        done: (facts, before) => tourStart(facts).rakeRevisions !== before.rakeRevisions,
    },
    {
        id: 'turn',
        title: 'Look around',
        words: ({ touch }) =>
            touch
                ? 'Drag beside the rake with one finger to rotate the view, with two fingers to pan, and pinch to zoom.'
                : 'Drag beside the rake to rotate the view, drag with the right button to pan, and scroll to zoom.',
        done: (facts, before) => tourStart(facts).pose !== before.pose,
    },
    {
        id: 'streak',
        title: 'Choose a streak surface',
        words: ({ state, narrow }) =>
            state.dataset.value?.steady === true || state.times.value.length < 2
                ? 'This flow does not change with time. In a flow that does, a streak surface shows particles released one after another, like smoke.'
                : `${narrow ? 'Below the picture' : 'On the right'}, under Flow, choose Streak: particles released one after another, like smoke. It moves with the flow.`,
        done: ({ edits }) => edits.intent.value?.kind === 'streak',
    },
    {
        id: 'play',
        title: 'Watch it move',
        words: ({ state }) =>
            'Press play under the picture' +
            (state.dataset.value?.obstacle === true ? ' and watch the sheet tear around the body' : '') +
            '. Everyone in the session sees the same time.',
        done: ({ state }) => state.clock.value?.playing === true,
    },
    {
        id: 'look',
        title: 'Make it readable',
        words: () =>
            'Under Look, colour the surface by another field (by Q, vortices are red), make it transparent, or draw lines on it.',
        done: ({ view }, before) => view.looks.value !== before.looks,
    },
    {
        id: 'share',
        title: 'Show it to someone',
        words: () =>
            'Under Share, make a link: anyone who opens it sees this view and may drag rakes too. ' +
            'Under Export, save pictures, films and meshes.',
        done: ({ state }) => state.participants.value.size > 1,
    },
];
