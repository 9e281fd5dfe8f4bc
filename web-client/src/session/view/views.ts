// The page's view as a value: taken for links and bookmarks, and shown again. Keeps the address of the page
// up to date.
import { batch, effect } from '@preact/signals-core';
import type { CameraControls } from '../../scene/camera/cameraControls.ts';
import type { FrameLoop } from '../../scene/frameLoop.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { SurfaceLayer } from '../../scene/surface/surfaceLayer.ts';
import type { AppState } from '../../state/appState.ts';
import { decodeBody, encodeBody, plainBody } from '../../state/bodyLook.ts';
import {
    decodeVisibility,
    encodeVisibility,
    noClip,
    renamedClip,
    type PageView,
    renamedView,
    renamedVisibility,
} from '../../state/pageView.ts';
import { decodeLines, encodeLines, plainLines } from '../../state/lineLook.ts';
import { decodeSlices, encodeSlices, plainSlices } from '../../state/sliceLook.ts';
import { decodeLook, encodeLook, type SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { encodeLinkState, showFragment, type UrlState, writeFragment } from './urlState.ts';
import type { Recovered } from './sessionRecovery.ts';

/** Browsers refuse more than 100 changes of the address in 30 s. */
const addressRestMs = 500;
/** Characters of all masks together: bookmarks have 4 KiB, and links should pass through chats. */
const maxMaskChars = 1600;

export interface ViewsOptions {
    state: AppState;
    view: ViewState;
    scene: Pick<FlowScene, 'onDraw'> & {
        controls: Pick<CameraControls, 'pose' | 'place'>;
        loop: Pick<FrameLoop, 'request'>;
        surfaces: Pick<SurfaceLayer, 'maskCode' | 'setMask' | 'forgetMasks' | 'strokes'>;
    };
    url: UrlState;
}

export class Views {
    private readonly options: ViewsOptions;
    private pending: ReturnType<typeof setTimeout> | null = null;
    private drawnPose = '';
    private restored = false;
    /** The session that is in the address. */
    private written: string | null = null;

    constructor(options: ViewsOptions) {
        this.options = options;
        const { state, view, scene } = options;
        scene.onDraw(() => {
            const pose = JSON.stringify([scene.controls.pose, scene.surfaces.strokes]);
            if (pose !== this.drawnPose) this.changed();
            this.drawnPose = pose;
        });
        effect(() => {
            // Whatever of these changes, the address does.
            void [state.session.value, state.rakes.value, state.surfaces.value, state.activeSurface.value];
            void [state.slices.value, state.lines.value];
            void [view.looks.value, view.clip.value, view.body.value, view.slices.value, view.lines.value, view.visibility.value];
            this.changed();
        });
    }

    current(): PageView {
        const { state, view, scene } = this.options;
        const surface = state.activeSurface.value;
        const [clip, known] = [view.clip.value, state.surfaces.value];
        const masks = this.masks();
        const left = view.paintLeftOut.value;
        const shown = encodeVisibility(view.visibility.value);
        const looks = [...view.looks.value]
            .filter(([id]) => known.has(id))
            .map(([id, look]) => {
                // All of the surface rather than nothing.
                return [id, encodeLook(left.has(id) ? { ...look, painting: false } : look)];
            });
        return {
            camera: scene.controls.pose,
            ...(surface === null ? {} : { surface }),
            looks: Object.fromEntries(looks) as Record<string, Partial<SurfaceLook>>,
            ...(clip === noClip ? {} : { clip }),
            ...(view.body.value === plainBody ? {} : { body: encodeBody(view.body.value) }),
            ...(view.slices.value === plainSlices ? {} : { slices: encodeSlices(view.slices.value) }),
            ...(view.lines.value === plainLines ? {} : { lines: encodeLines(view.lines.value) }),
            ...(shown === undefined ? {} : { shown }),
            ...(masks.length === 0 ? {} : { masks: Object.fromEntries(masks) }),
        };
    }

    show({ camera, surface, looks, clip, body, slices, lines, masks = {}, shown }: PageView): void {
        const { state, view, scene } = this.options;
        if (camera !== undefined) {
            view.orthographic.value = camera.orthographic;
            scene.controls.place(camera);
            scene.loop.request();
        }
        if (looks !== undefined) {
            view.looks.value = new Map(Object.entries(looks).map(([id, look]) => [id, decodeLook(look)]));
            view.clip.value = clip ?? noClip;
            view.body.value = body === undefined ? plainBody : decodeBody(body);
            view.slices.value = slices === undefined ? plainSlices : decodeSlices(slices);
            view.lines.value = lines === undefined ? plainLines : decodeLines(lines);
            view.visibility.value = decodeVisibility(shown);
        }
        for (const [id, code] of Object.entries(masks)) scene.surfaces.setMask(id, code);
        if (surface !== undefined && state.surfaces.value.has(surface)) state.activeSurface.value = surface;
    }

    /** The view of the link that opened the page; once, when there is something to look at. */
    restore(): void {
        const { state } = this.options.url;
        if (this.restored) return;
        this.restored = true;
        if (state !== null) this.show(state.view);
    }

    /** Renames the records of the view: it goes on with them. */
    recovered({ rakes, surfaces }: Pick<Recovered, 'rakes' | 'surfaces'>): void {
        const { state, view, url, scene } = this.options;
        const renamed = <Value>(each: Iterable<[string, Value]>): [string, Value][] =>
            [...each].flatMap(([id, value]): [string, Value][] => {
                const now = surfaces.get(id);
                return now === undefined ? [] : [[now, value]];
            });
        const masks = [...surfaces.keys()].flatMap((id): [string, string][] => {
            const code = scene.surfaces.maskCode(id);
            return typeof code === 'string' ? [[id, code]] : [];
        });
        const looks = [...view.looks.value].map(([id, look]): [string, SurfaceLook] => {
            // All of the surface rather than nothing.
            return [id, scene.surfaces.maskCode(id) === null ? { ...look, painting: false } : look];
        });
        // A surface that is made later may bear the name of one that was painted.
        scene.surfaces.forgetMasks();
        for (const [id, code] of renamed(masks)) scene.surfaces.setMask(id, code);
        batch(() => {
            view.looks.value = new Map(renamed(looks));
            view.visibility.value = renamedVisibility(view.visibility.value, rakes, surfaces);
            view.clip.value = renamedClip(view.clip.value, surfaces);
            state.activeRake.value = rakes.get(state.activeRake.value ?? '') ?? null;
            state.activeSurface.value = surfaces.get(state.activeSurface.value ?? '') ?? null;
        });
        if (url.state !== null) url.state.view = renamedView(url.state.view, surfaces, rakes);
    }

    /** The address of this page as it is now. */
    link(): string {
        const { state, url } = this.options;
        const all = <Record>({ value }: { value: ReadonlyMap<string, Record> }): Record[] => [...value.values()];
        const made = { rakes: all(state.rakes), surfaces: all(state.surfaces) };
        const encoded = encodeLinkState({ view: this.current(), ...made, slices: all(state.slices), lines: all(state.lines) });
        const address = new URL(location.href);
        address.hash = writeFragment(state.session.value, url.dataset, encoded);
        return address.href;
    }

    /** Returns what is painted of the surfaces; those for which there is no room are noted. */
    private masks(): [string, string][] {
        const { state, view, scene } = this.options;
        const leftOut = new Set<string>();
        const masks: [string, string][] = [];
        let room = maxMaskChars;
        for (const [id, look] of view.looks.value) {
            if (!look.painting || !state.surfaces.value.has(id)) continue;
            const code = scene.surfaces.maskCode(id);
            if (code === undefined) continue;
            if (code === null || code.length > room) leftOut.add(id);
            else {
                room -= code.length;
                masks.push([id, code]);
            }
        }
        const before = view.paintLeftOut.value;
        if (leftOut.size !== before.size || [...leftOut].some((id) => !before.has(id))) view.paintLeftOut.value = leftOut;
        return masks;
    }

    private changed(): void {
        const { state, url } = this.options;
        if (url.beside === true) return;
        if (state.session.value !== this.written) {
            // At once: a user who reloads the page must come back to the session.
            this.written = state.session.value;
            const former = url.state === null ? null : encodeLinkState(url.state);
            if (!this.restored) showFragment(writeFragment(this.written, url.dataset, former));
        }
        this.pending ??= setTimeout(() => {
            this.pending = null;
            if (this.written !== null && this.restored) showFragment(new URL(this.link()).hash);
        }, addressRestMs);
    }
}
