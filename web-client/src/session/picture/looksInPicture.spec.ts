import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { AppState } from '../../state/appState.ts';
import type { ShowWish } from '../../worker/workerMessages.ts';
import { ViewState } from '../../state/viewState.ts';
import { surfaceOf } from '../../testing/records.ts';
import { showLooks } from './looksInPicture.ts';

function bench() {
    const [state, view] = [new AppState(), new ViewState()];
    state.stage.value = 'running';
    const shown: unknown[] = [];
    const scene = {
        loop: { request: () => undefined, requestNext: () => undefined, beforeFrame: () => undefined },
        surfaces: { setStyle: () => undefined, spanOf: () => null, moveTexture: () => undefined },
        setClip: () => undefined,
    };
    const worker = { show: (id: string, { parts }: ShowWish) => shown.push([id, parts]) };
    showLooks({ state, view, scene, worker });
    const has = (...ids: string[]): void => {
        state.surfaces.value = new Map(ids.map((id) => [id, surfaceOf(id)]));
    };
    return { state, view, shown, has };
}

describe('the looks on their way to the worker', () => {
    beforeEach(() => {
        vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: () => undefined }));
    });

    afterEach(() => vi.unstubAllGlobals());

    it('are told again for a surface that was deleted and has come back', () => {
        const { view, shown, has } = bench();
        view.changeLook('s1', { hiddenParts: [[0.5, 1]] });
        has('s1');
        has();
        has('s1');
        const hidden = ['s1', { hidden: [[0.5, 1]] }];
        expect(shown).toEqual([hidden, hidden]);
    });

    it('ask for the parts of the selected surface while they are listed, whichever that is', () => {
        const { state, view, shown, has } = bench();
        has('s1', 's2');
        state.activeSurface.value = 's1';
        shown.length = 0;
        view.partsListed.value = true;
        state.activeSurface.value = 's2';
        const listed = { hidden: [] };
        expect(shown).toEqual([
            ['s1', listed],
            ['s1', null],
            ['s2', listed],
        ]);
    });
});
