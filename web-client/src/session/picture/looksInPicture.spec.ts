import { batch } from '@preact/signals-core';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { SurfaceStyle } from '../../scene/surface/surfaceStyle.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { datasetOf, surfaceOf } from '../../testing/records.ts';
import type { ShowWish } from '../../worker/workerMessages.ts';
import { showLooks } from './looksInPicture.ts';

function bench() {
    const [state, view] = [new AppState(), new ViewState()];
    state.stage.value = 'running';
    const shown: unknown[] = [];
    const clips: (readonly number[])[] = [];
    const styles = new Map<string, SurfaceStyle>();
    const whole: [number, number] = [0, 5];
    const texture = { moved: 0, frame: (): void => undefined };
    const scene = {
        loop: {
            request: () => undefined,
            requestNext: () => undefined,
            beforeFrame: (frame: () => void) => void (texture.frame = frame),
        },
        surfaces: {
            setStyle: (id: string, style: SurfaceStyle) => void styles.set(id, style),
            spanOf: (id: string) => ({ colours: whole, t: whole, s: whole, age: whole, style: styles.get(id)!, lacks: '' }),
            moveTexture: () => ++texture.moved,
        },
        setClip: (planes: readonly (readonly number[])[]) => void clips.push(planes[0]!),
    };
    const worker = { show: (id: string, { parts }: ShowWish) => shown.push([id, parts]) };
    showLooks({ state, view, scene, worker, slicePlane: () => undefined });
    const has = (...ids: string[]): void => {
        state.surfaces.value = new Map(ids.map((id) => [id, surfaceOf(id)]));
    };
    return { state, view, shown, clips, has, texture };
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

describe('planes that cut', () => {
    beforeEach(() => {
        vi.stubGlobal('matchMedia', () => ({ matches: false, addEventListener: () => undefined }));
    });

    afterEach(() => vi.unstubAllGlobals());

    it('stay where they are while further data come, are worked on and go, and while surfaces are edited', () => {
        const { state, view, clips } = bench();
        const [flow, other] = [
            datasetOf({ bounds: [0, 2, 0, 1, 0, 1] }),
            datasetOf({ dataset: 'other', bounds: [0, 8, 0, 1, 0, 1] }),
        ];
        state.dataset.value = flow;
        state.surfaces.value = new Map([
            ['s1', surfaceOf('s1')],
            ['s2', surfaceOf('s2', { dataset: 'other' })],
        ]);
        const plane = { on: true, at: 0.5, flipped: false };
        view.clip.value = { ...view.clip.value, planes: [plane, plane, plane] };
        const told = clips.length;
        expect(clips.at(-1)).toEqual([1, 0, 0, 1]);
        state.otherDatasets.value = new Map([['other', other]]);
        batch(() => {
            state.dataset.value = other;
            state.otherDatasets.value = new Map([['flow', flow]]);
        });
        state.surfaces.value = new Map([['s1', surfaceOf('s1', { epoch: 2 })]]);
        expect(clips.slice(told)).toEqual([]);
        view.clip.value = { ...view.clip.value, planes: [{ ...plane, at: 3 }, plane, plane] };
        expect(clips.at(-1), 'in the other data').toEqual([1, 0, 0, 6]);
    });
});

describe('the flow texture of a field that stands still', () => {
    it('moves with every frame while that is on, and not for people who want no motion', () => {
        const calm = { matches: false, addEventListener: () => undefined };
        vi.stubGlobal('matchMedia', () => calm);
        const { state, view, texture } = bench();
        const fields = ['velocity_x', 'velocity_y', 'velocity_z'];
        state.surfaces.value = new Map([['s1', surfaceOf('s1', { kind: 'stream', fields })]]);
        const frames = (): number => {
            const before = texture.moved;
            for (let i = 0; i < 3; ++i) texture.frame();
            return texture.moved - before;
        };
        view.changeLook('s1', { texture: true });
        expect(frames()).toBe(0);
        view.changeLook('s1', { animated: true });
        expect(frames()).toBe(3);
        calm.matches = true;
        expect(frames()).toBe(0);
        calm.matches = false;
        expect(frames()).toBe(3);
        view.changeLook('s1', { animated: false });
        expect(frames()).toBe(0);
        vi.unstubAllGlobals();
    });
});
