import { describe, expect, it } from 'vitest';
import { readPageView } from '../../state/pageView.ts';
import { AppState } from '../../state/appState.ts';
import { plainBody } from '../../state/bodyLook.ts';
import { usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { surfaceOf } from '../../testing/records.ts';
import type { UrlState } from './urlState.ts';
import { Views, type ViewsOptions } from './views.ts';

/** One that no user looks at, with these masks. */
function sceneWith(surfaces: Partial<ViewsOptions['scene']['surfaces']>): ViewsOptions['scene'] {
    const still = (): void => undefined;
    return {
        onDraw: () => still,
        loop: { request: still },
        controls: { pose: { position: [0, 0, 1], target: [0, 0, 0], orthographic: false }, place: still },
        surfaces: { strokes: 0, maskCode: () => undefined, setMask: still, forgetMasks: still, ...surfaces },
    };
}

describe('the view of a session that is made again', () => {
    it('goes on with the new names of its surfaces, here and in the link, and forgets those that are missing', () => {
        const [state, view] = [new AppState(), new ViewState()];
        const looks = { s4: { opacity: 0.4 }, s7: { opacity: 0.7 } };
        const url: UrlState = {
            ...{ token: null, session: null, dataset: null },
            state: {
                view: { surface: 's7', looks, masks: { s7: 'linked', s9: 'gone' } },
                rakes: [],
                surfaces: [],
                slices: [],
                lines: [],
            },
        };
        const masks = new Map([
            ['s4', 'offour'],
            ['s7', 'ofseven'],
        ]);
        const surfaces = {
            maskCode: (id: string) => masks.get(id),
            setMask: (id: string, code: string) => masks.set(id, code),
            forgetMasks: () => masks.clear(),
        };
        const scene = sceneWith(surfaces);
        const views = new Views({ state, view, scene, url });
        view.looks.value = new Map(Object.entries(looks).map(([id, look]) => [id, { ...usualLook, ...look }]));
        [state.activeRake.value, state.activeSurface.value] = ['r2', 's7'];

        views.recovered({ rakes: new Map([['r2', 'r1']]), surfaces: new Map([['s7', 's4']]) });
        expect([...view.looks.value]).toEqual([['s4', { ...usualLook, opacity: 0.7 }]]);
        expect([state.activeRake.value, state.activeSurface.value]).toEqual(['r1', 's4']);
        expect(url.state?.view).toEqual({ surface: 's4', looks: { s4: { opacity: 0.7 } }, masks: { s4: 'linked' } });
        expect([...masks]).toEqual([['s4', 'ofseven']]);
    });

    it('shows all of a surface whose painting is too intricate to be taken along', () => {
        const [state, view] = [new AppState(), new ViewState()];
        const masks = new Map<string, string | null>([
            ['s4', null],
            ['s7', 'ofseven'],
        ]);
        const surfaces = {
            maskCode: (id: string) => masks.get(id),
            setMask: (id: string, code: string) => masks.set(id, code),
            forgetMasks: () => masks.clear(),
        };
        const scene = sceneWith(surfaces);
        const url = { token: null, session: null, dataset: null, state: null };
        const views = new Views({ state, view, scene, url });
        const painted = { ...usualLook, opacity: 0.4, painting: true };
        view.looks.value = new Map(['s4', 's7'].map((id) => [id, painted]));
        views.recovered({
            rakes: new Map(),
            surfaces: new Map([
                ['s4', 's1'],
                ['s7', 's4'],
            ]),
        });
        expect([...view.looks.value]).toEqual([
            ['s1', { ...painted, painting: false }],
            ['s4', painted],
        ]);
        expect([...masks]).toEqual([['s4', 'ofseven']]);
    });
});

describe('the look of the body', () => {
    it('is in the view while it is not the usual, and goes with a view that does not have it', () => {
        const [state, view] = [new AppState(), new ViewState()];
        const url = { token: null, session: null, dataset: null, state: null };
        const views = new Views({ state, view, scene: sceneWith({}), url });
        expect(views.current()).not.toHaveProperty('body');
        const coloured = { ...plainBody, texture: true, colourBy: 'field:p', range: [-1, 2] } as const;
        view.body.value = coloured;
        const kept = readPageView(JSON.parse(JSON.stringify(views.current())));
        views.show({ looks: {} });
        expect(view.body.value).toEqual(plainBody);
        views.show(kept);
        expect(view.body.value).toEqual(coloured);
        views.show(readPageView({ looks: {}, bodyTexture: true }));
        expect(view.body.value).toEqual({ ...plainBody, texture: true });
    });
});

describe('the look of slices and streamlines', () => {
    it('is in the view while it is not the usual, without what a stranger could not have chosen', () => {
        const [state, view] = [new AppState(), new ViewState()];
        const url = { token: null, session: null, dataset: null, state: null };
        const views = new Views({ state, view, scene: sceneWith({}), url });
        view.slices.value = { contours: 12, arrows: true };
        view.lines.value = { width: 5 };
        const kept = readPageView(JSON.parse(JSON.stringify(views.current())));
        views.show({ looks: {} });
        expect(views.current()).not.toHaveProperty('slices');
        expect(views.current()).not.toHaveProperty('lines');
        views.show(kept);
        expect([view.slices.value, view.lines.value]).toEqual([{ contours: 12, arrows: true }, { width: 5 }]);
        views.show(readPageView({ looks: {}, slices: { contours: 1e9, arrows: 'yes' }, lines: { width: -3 } }));
        expect([view.slices.value, view.lines.value]).toEqual([{ contours: 0, arrows: false }, { width: 3 }]);
    });
});

describe('what is painted', () => {
    it('is in the view as long as there is room; where there is none all of the surface is shown, and it is noted', () => {
        const [state, view] = [new AppState(), new ViewState()];
        const codes: Record<string, string | null> = {
            s1: 'a'.repeat(790),
            s2: null,
            s3: 'b'.repeat(790),
            s4: 'c'.repeat(90),
            s5: 'd',
        };
        state.surfaces.value = new Map(Object.keys(codes).map((id) => [id, surfaceOf(id)]));
        view.looks.value = new Map(Object.keys(codes).map((id) => [id, { ...usualLook, painting: id !== 's5' }]));
        const surfaces = { maskCode: (id: string) => codes[id] };
        const scene = sceneWith(surfaces);
        const url = { token: null, session: null, dataset: null, state: null };
        const { looks, masks } = new Views({ state, view, scene, url }).current();
        expect(Object.keys(masks ?? {})).toEqual(['s1', 's3']);
        expect(looks).toEqual({ s1: { painting: true }, s2: {}, s3: { painting: true }, s4: {}, s5: {} });
        expect([...view.paintLeftOut.value]).toEqual(['s2', 's4']);
    });
});
