// Turns what the user does to the rakes in the picture into edits for the server, which others see while the
// hand still moves.
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { Edits } from '../edits/edits.ts';
import type { People } from '../people/people.ts';
import type { OwnCopy } from '../sessions/ownCopy.ts';

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
        refused: () => tellLocked(state, view, ownCopy),
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

function tellLocked(
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
