// The camera that no user has moved yet goes near to the first surface of a dataset and its rake, which may
// be a small part of the domain.
import { effect, untracked } from '@preact/signals-core';
import type { Vec3 } from '../../protocol/messages.ts';
import type { CameraControls } from '../../scene/camera/cameraControls.ts';
import type { Bounds } from '../../scene/domain/domainAxes.ts';
import type { SurfaceLayer } from '../../scene/surface/surfaceLayer.ts';
import type { AppState } from '../../state/appState.ts';
import { picturedBounds } from './picturedBounds.ts';

export interface InitialViewOptions {
    state: Pick<
        AppState,
        | 'activeSurface'
        | 'dataset'
        | 'displayed'
        | 'editsPending'
        | 'otherDatasets'
        | 'phase'
        | 'pictured'
        | 'rakePoints'
        | 'surface'
    >;
    controls: Pick<CameraControls, 'offer'>;
    surfaces: Pick<SurfaceLayer, 'boxOf'>;
    /** Returns whether a handle is held. */
    dragging: () => boolean;
}

/** At what is there first, and once more when that has become final; then at one of another kind, which is
 *  elsewhere or of another size. What else is edited does not move the camera. */
export function frameFirstSurface({ state, controls, surfaces, dragging }: InitialViewOptions): void {
    let done = '';
    /** Of what was final last. */
    let last = { surface: '', kind: '', epoch: 0 };
    const offer = (surface: string): boolean => {
        // Of several datasets the picture shows all.
        const whole = state.otherDatasets.value.size > 0 ? picturedBounds(state) : null;
        const box = whole ?? around(surfaces.boxOf(surface), state.rakePoints.value);
        return box === null || controls.offer(box);
    };
    effect(() => {
        if (state.phase.value !== 'final' && state.phase.value !== 'coarsened') return;
        const [surface, kind] = [state.activeSurface.value ?? '', state.surface.value?.kind ?? ''];
        const epoch = state.displayed.value.get(surface)?.epoch ?? 0;
        const isOther = surface === last.surface && kind !== last.kind;
        // The record says its kind before the first picture of it is here.
        if (isOther && epoch === last.epoch) return;
        if (isOther && !dragging()) untracked(() => offer(surface));
        last = { surface, kind, epoch };
    });
    effect(() => {
        const dataset = state.dataset.value?.dataset ?? '';
        const surface = state.activeSurface.value ?? '';
        const displayed = state.displayed.value.get(surface);
        const edited = state.editsPending.value;
        if (displayed === undefined || done === dataset) return;
        untracked(() => {
            if (edited || dragging()) done = dataset;
            else {
                if (!offer(surface)) done = dataset;
                if (displayed.phase === 'final') done = dataset;
            }
        });
    });
}

/** Null: there is nothing of the surface to see. */
export function around(surface: Bounds | null, rake: readonly Vec3[]): Bounds | null {
    if (surface === null) return null;
    const box = [...surface] as [number, number, number, number, number, number];
    for (const point of rake) {
        for (let k = 0; k < 3; ++k) {
            box[2 * k] = Math.min(box[2 * k]!, point[k]!);
            box[2 * k + 1] = Math.max(box[2 * k + 1]!, point[k]!);
        }
    }
    return box;
}
