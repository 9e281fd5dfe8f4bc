import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { CameraControls } from '../../scene/camera/cameraControls.ts';
import { type Bounds, centreOf } from '../../scene/domain/domainAxes.ts';
import { AppState } from '../../state/appState.ts';
import { datasetOf, displayedOf, surfaceOf } from '../../testing/records.ts';
import { around, frameFirstSurface } from './initialView.ts';

const domain: Bounds = [-10, 10, -10, 10, -10, 10];
const small: Bounds = [4, 5, 4, 5, 4, 6];

function bench() {
    const controls = new CameraControls({ requestFrame: () => undefined, onHold: () => undefined, onTurn: () => undefined });
    const state = new AppState();
    const held = { now: false };
    let box: Bounds | null = small;
    frameFirstSurface({ state, controls, surfaces: { boxOf: () => box }, dragging: () => held.now });
    controls.setBounds(domain);
    state.dataset.value = datasetOf({ times: [0, 1] });
    state.activeSurface.value = 's';
    const show = (phase: 'coarse' | 'final', of: Bounds | null = small): void => {
        box = of;
        state.displayed.value = new Map([['s', { ...displayedOf('s'), phase }]]);
    };
    const rake = (points: Vec3[]): void => void (state.rakeShape.value = { kind: 'line', points });
    return { controls, state, held, show, rake };
}

const rounded = ({ controls }: Pick<ReturnType<typeof bench>, 'controls'>): number[] =>
    controls.pose.target.map((x) => Math.round(x * 1e6) / 1e6);

describe('the first look', () => {
    it('is at the surface and its rake, not at the whole domain', () => {
        const { controls, show, rake } = bench();
        const far = Math.hypot(...controls.pose.position);
        rake([
            [3, 4, 4],
            [3, 5, 4],
        ]);
        show('coarse');
        expect(rounded({ controls })).toEqual([4, 4.5, 5]);
        const near = Math.hypot(...controls.pose.position.map((x, k) => x - controls.pose.target[k]!));
        expect(near).toBeLessThan(far / 5);
    });

    it('follows the surface until it is final, and no longer', () => {
        const { controls, show } = bench();
        show('coarse');
        show('final', [0, 5, 0, 5, 0, 6]);
        expect(rounded({ controls })).toEqual([2.5, 2.5, 3]);
        show('final', small);
        expect(rounded({ controls })).toEqual([2.5, 2.5, 3]);
    });

    it('leaves the camera where someone has put it, and does not move it while they edit', () => {
        for (const act of [
            ({ controls }: ReturnType<typeof bench>) => controls.turn(0.1, 0),
            ({ controls }: ReturnType<typeof bench>) => controls.show('oblique'),
            ({ state }: ReturnType<typeof bench>) => void (state.editsPending.value = true),
            ({ held }: ReturnType<typeof bench>) => void (held.now = true),
        ]) {
            const page = bench();
            page.show('coarse', domain);
            act(page);
            const { pose } = page.controls;
            page.show('final');
            expect(page.controls.pose).toEqual(pose);
        }
    });

    it('is taken again at a surface whose kind was changed, when that is final, unless someone has put the camera elsewhere', () => {
        for (const moved of [false, true]) {
            const { controls, state, show } = bench();
            let box: Bounds = [0, 5, 0, 5, 0, 6];
            const change = (kind: 'stream' | 'streak'): void => {
                state.surfaces.value = new Map([['s', surfaceOf('s', { kind })]]);
            };
            const arrives = (epoch: number): void => {
                show('final', box);
                state.displayed.value = new Map([['s', displayedOf('s', { epoch, phase: 'final', cells: 4 })]]);
            };
            state.stage.value = 'running';
            change('stream');
            arrives(1);
            if (moved) controls.turn(0.1, 0);
            const before = rounded({ controls });
            box = small;
            arrives(2);
            expect(rounded({ controls })).toEqual(before);
            change('streak');
            expect(rounded({ controls })).toEqual(before);
            arrives(3);
            expect(rounded({ controls })).toEqual(moved ? before : [4.5, 4.5, 5]);
        }
    });

    it('stays at the domain where there is nothing to see', () => {
        const { controls, show } = bench();
        const before = controls.pose;
        show('final', null);
        expect(controls.pose).toEqual(before);
        expect(around(null, [[0, 0, 0]])).toBeNull();
        expect(centreOf(domain)).toEqual(before.target);
    });
});
