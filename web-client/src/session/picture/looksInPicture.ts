// The looks on their way to the picture: as styles to the scene, and as what is needed to the worker, with the number of pixels that a unit
// of length has where the camera looks, which curved cells are cut by. Surfaces that this page hides have no subscription.
import { computed, effect, type Signal } from '@preact/signals-core';
import type { CameraControls } from '../../scene/camera/cameraControls.ts';
import type { FrameLoop } from '../../scene/frameLoop.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { SurfaceLayer } from '../../scene/surface/surfaceLayer.ts';
import { type AppState, speedRangeOf } from '../../state/appState.ts';
import { planeNumbers, showsSurface, type SlicePlane } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { clipBounds } from './picturedBounds.ts';
import { attributesOf, automaticRanges, joinedRanges, styleOf } from './surfaceStyleOf.ts';

export interface LooksOptions {
    state: AppState;
    view: ViewState;
    scene: Pick<FlowScene, 'setClip'> & {
        loop: Pick<FrameLoop, 'request' | 'requestNext' | 'beforeFrame'>;
        surfaces: Pick<SurfaceLayer, 'setStyle' | 'spanOf' | 'moveTexture'>;
    };
    worker: Pick<WorkerClient, 'show'>;
    /** Returns where a slice lies as it is drawn. */
    slicePlane: (id: string) => SlicePlane | undefined;
}

export function showLooks({ state, view, scene, worker, slicePlane }: LooksOptions): void {
    const sent = new Map<string, string>();
    effect(() => {
        // One that is shown again is new to the scene.
        void state.hiddenSurfaces.value;
        const fixed = view.fixedRanges.value;
        const ranges = {
            automatic: fixed ?? joinedRanges(automaticRanges(state, view), view.rangesBeside.value),
            fixed: fixed !== null,
        };
        for (const [id, record] of state.surfaces.value) {
            const rake = state.rakes.value.get(record.rake ?? '');
            const outcome = state.outcomes.value.get(id);
            const dataset = state.described(record.dataset);
            const facts = { record, rake, outcome, dataset, speedRange: speedRangeOf(dataset), ...ranges };
            scene.surfaces.setStyle(id, styleOf({ look: view.lookOf(id), ...facts }));
        }
        scene.loop.request();
    });
    effect(() => {
        // A worker that has taken the place of another knows nothing of this.
        if (state.stage.value !== 'running') sent.clear();
        const listed = view.partsListed.value ? state.activeSurface.value : null;
        // One that comes back is new to the worker.
        for (const id of sent.keys()) {
            if (!state.surfaces.value.has(id) || state.hiddenSurfaces.value.has(id)) sent.delete(id);
        }
        for (const [id, record] of state.surfaces.value) {
            if (state.hiddenSurfaces.value.has(id)) continue;
            const look = view.lookOf(id);
            const parts = look.hiddenParts.length > 0 || listed === id ? { hidden: look.hiddenParts } : null;
            const closed = state.rakes.value.get(record.rake ?? '')?.kind === 'circle';
            const units = look.pieces === 'whole' ? {} : { units: closed ? ('closed' as const) : ('open' as const) };
            const fixed = look.smoke > 0 && record.refine === 'off' ? { unresolved: true as const } : {};
            const curved = look.curved ? { curved: view.pixelsPerLength.value } : {};
            const wish = {
                attributes: attributesOf(look, record.fields),
                parts,
                trimmed: look.trimmed,
                ...units,
                ...fixed,
                ...curved,
            };
            const text = JSON.stringify(wish);
            if (sent.get(id) === text) continue;
            sent.set(id, text);
            worker.show(id, wish);
        }
    });
    const box = computed(() => clipBounds(state));
    effect(() => {
        const bounds = box.value;
        if (bounds === null) return;
        const clip = view.clip.value;
        scene.setClip(planeNumbers(clip, bounds, slicePlane(clip.slice?.id ?? '') ?? null), clip.body);
    });
    flowTexture({ state, scene });
}

const secondsAcross = 14;

/** In a field that stands still the flow texture moves by itself while that is switched on, but not for those
 *  who want no motion. */
function flowTexture({ state, scene }: Pick<LooksOptions, 'state' | 'scene'>): void {
    const calm = matchMedia('(prefers-reduced-motion: reduce)');
    let before: number | null = null;
    scene.loop.beforeFrame(() => {
        const moving = [...state.surfaces.value.keys()].filter((id) => {
            const style = scene.surfaces.spanOf(id)?.style;
            return style?.texture === true && style.textureMoves === 'byItself';
        });
        const now = performance.now();
        if (moving.length === 0 || calm.matches) {
            before = null;
            return;
        }
        const spans = moving.map((id) => scene.surfaces.spanOf(id)?.t ?? ([0, 0] as const)).map(([low, high]) => high - low);
        const step = Math.min(0.1, (now - (before ?? now)) / 1000);
        before = now;
        scene.surfaces.moveTexture((step * Math.max(0, ...spans.filter(Number.isFinite))) / secondsAcross);
        scene.loop.request();
        scene.loop.requestNext();
    });
    calm.addEventListener('change', scene.loop.request);
}

const restMs = 300;

/** In powers of two: what has been cut is good for some zooming. */
export function measurePixels(
    controls: Pick<CameraControls, 'onMove' | 'pose' | 'fov'>,
    { dataset }: Pick<AppState, 'dataset'>,
    pixels: Signal<number>,
): void {
    let rest: ReturnType<typeof setTimeout> | undefined;
    const measure = (): void => {
        const { position, target } = controls.pose;
        const away = Math.hypot(...position.map((x, i) => x - target[i]!));
        const seen = 2 * Math.tan((controls.fov * Math.PI) / 360) * away;
        const now = 2 ** Math.ceil(Math.log2((innerHeight * devicePixelRatio) / seen));
        if (Number.isFinite(now)) pixels.value = now;
    };
    const moved = (): void => {
        clearTimeout(rest);
        rest = setTimeout(measure, restMs);
    };
    controls.onMove(moved);
    effect(() => {
        void dataset.value;
        moved();
    });
}

/** For as long as the page lives. */
export function hideSurfaces(state: AppState, view: Pick<ViewState, 'visibility'>): void {
    effect(() => {
        const visibility = view.visibility.value;
        const chosen = state.activeRake.value;
        const hidden = [...state.surfaces.value.values()].filter((each) => !showsSurface(visibility, each, chosen));
        const before = state.hiddenSurfaces.peek();
        if (hidden.length === before.size && hidden.every(({ surface }) => before.has(surface))) return;
        state.hiddenSurfaces.value = new Set(hidden.map(({ surface }) => surface));
    });
}
