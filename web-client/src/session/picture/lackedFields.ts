// Says what looks need and their surfaces do not carry, as after a link or a bookmark: all else of the looks
// is drawn, and this is said.
import { effect } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { OwnCopy } from '../sessions/ownCopy.ts';
import { neededFields } from './surfaceFields.ts';

export interface LackedFieldsOptions {
    state: Pick<AppState, 'stage' | 'role' | 'surfaces' | 'hiddenSurfaces' | 'editsPending' | 'notices'>;
    view: Pick<ViewState, 'lookOf'>;
    ownCopy: Pick<OwnCopy, 'begin'>;
}

const about = 'lacked fields';

export function tellLackedFields({ state, view, ownCopy }: LackedFieldsOptions): void {
    effect(() => {
        // Those that are being asked for are on their way.
        if (state.stage.value !== 'running' || state.editsPending.value) return;
        const lacked = [...state.surfaces.value.values()].flatMap(({ surface, fields }) => {
            const names = neededFields(view.lookOf(surface)).filter((name) => !fields.includes(name));
            return names.length === 0 || state.hiddenSurfaces.value.has(surface) ? [] : [`${names.join(', ')} with ${surface}`];
        });
        if (lacked.length === 0) {
            state.notices.solved(about);
            return;
        }
        const looksOn = state.role.value === 'viewer';
        state.notices.say(
            about,
            `This view needs what the server does not send: ${lacked.join('; ')}. It is drawn without. ` +
                (looksOn ? 'Someone who can edit, or you in a copy, can choose it under Look.' : 'Choose it again under Look.'),
            looksOn ? { label: 'Continue in a copy', act: () => void ownCopy.begin() } : null,
        );
    });
}
