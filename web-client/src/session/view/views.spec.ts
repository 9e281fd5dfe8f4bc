import { describe, expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import type { UrlState } from './urlState.ts';
import { Views, type ViewsOptions } from './views.ts';

describe('the view of a session that is made anew', () => {
    it('goes on with the new names of its surfaces, here and in the link, and forgets those that are missing', () => {
        const [state, view] = [new AppState(), new ViewState()];
        const looks = { s4: { opacity: 0.4 }, s7: { opacity: 0.7 } };
        const url: UrlState = {
            ...{ token: null, session: null, dataset: null },
            state: { view: { surface: 's7', looks }, rakes: [], surfaces: [] },
        };
        const scene = { onDraw: () => undefined } as unknown as ViewsOptions['scene'];
        const views = new Views({ state, view, scene, url });
        view.looks.value = new Map(Object.entries(looks).map(([id, look]) => [id, { ...usualLook, ...look }]));
        [state.activeRake.value, state.activeSurface.value] = ['r2', 's7'];

        views.madeAnew({ rakes: new Map([['r2', 'r1']]), surfaces: new Map([['s7', 's4']]) });
        expect([...view.looks.value]).toEqual([['s4', { ...usualLook, opacity: 0.7 }]]);
        expect([state.activeRake.value, state.activeSurface.value]).toEqual(['r1', 's4']);
        expect(url.state?.view).toEqual({ surface: 's4', looks: { s4: { opacity: 0.7 } } });
    });
});
