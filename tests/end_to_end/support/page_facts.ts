// `window.wakesurf` in pages of tests: facts about what is on the screen, read from the parts of the page that users get. It reads;
// the only things it sets are the camera's place and what figures are to show.
import type { BrowserContext } from 'playwright-core';
import type { Vec3 } from '../../../web-client/src/protocol/messages.ts';
import type { ScreenPoint, ScreenSize } from '../../../web-client/src/scene/base/view.ts';
import type { BodyVertex } from '../../../web-client/src/scene/surface/drawnBody.ts';
import type { PickGrid, PickHit } from '../../../web-client/src/scene/surface/pickHit.ts';
import type { SurfaceVertex } from '../../../web-client/src/scene/surface/surfaceMesh.ts';
import type { Handle } from '../../../web-client/src/scene/rake/rakeHandles.ts';
import type { DrawnRake } from '../../../web-client/src/scene/rake/rakeLayer.ts';
import type { ScriptedPage } from '../../../web-client/src/session/out/scriptedPicture.ts';
import type { DisplayedSurface } from '../../../web-client/src/state/appState.ts';
import type { LatencySample } from '../../../web-client/src/state/latency.ts';

export interface PageFacts extends Omit<ScriptedPage, 'parts'> {
    readonly framesDrawn: number;
    /** Pixels of the last picture for one of CSS, along one side. */
    readonly pixelRatio: number;
    /** Pictures that the last one is the mean of, and whether it gets no better. */
    readonly samples: number;
    readonly isAtRest: boolean;
    readonly connection: string;
    readonly stage: string;
    readonly session: string | null;
    readonly phase: string;
    readonly requestedEpoch: number;
    readonly displayed: DisplayedSurface | null;
    /** All surfaces that are on the screen. */
    readonly allDisplayed: DisplayedSurface[];
    readonly rakePoints: Vec3[];
    readonly rakes: readonly DrawnRake[];
    readonly bounds: readonly number[] | null;
    readonly speedRange: [number, number];
    readonly latencySamples: LatencySample[];
    /** From changes of slices by this page to their pictures, in milliseconds. */
    readonly sliceLags: number[];
    readonly roundTripMs: number | null;
    /** From the start of the page to the first frame that shows the domain. */
    readonly firstPictureMs: number | null;
    readonly camera: { position: Vec3; target: Vec3 };
    setCamera(position: Vec3, target: Vec3, orthographic?: boolean): void;
    /** Position in the window, in CSS pixels; null behind the camera. */
    project(point: Vec3): ScreenPoint | null;
    handleOnScreen(handle: Handle): ScreenPoint | null;
    /** The tip of the arrow along an axis; null where there is none. */
    arrowOnScreen(axis: 0 | 1 | 2): ScreenPoint | null;
    /** Every n-th vertex of the surface shown, with its scalar. */
    vertices(every: number): SurfaceVertex[];
    /** Every n-th vertex of the body, with the velocity off it where its texture is shown. */
    bodyVertices(every: number): BodyVertex[];
    /** What is seen at a position in the window. */
    pick(at: ScreenPoint): PickHit | null;
    /** What is seen round a position in the window, by pixels. */
    pickGrid(at: ScreenPoint, radiusPx: number): PickGrid;
    /** What the painter has left of a surface, as links have it; null where nothing is painted, or too much. */
    maskOf(surface: string): string | null;
    /** How the last picture shows what can be seen through. */
    readonly transparency: 'none' | 'blended' | 'exact';
    /** Draws and returns RGB at positions in the window; exact: with everything transparent in its order. */
    pixelsAt(points: ScreenPoint[], exact?: boolean): [number, number, number][];
    /** RGBA of a figure as it would be saved, with tiles of this many pixels a side. */
    figure(size: ScreenSize, tileSide: number): Uint8ClampedArray;
    loseContext(): void;
    restoreContext(): void;
}

declare global {
    interface Window {
        wakesurf?: PageFacts;
        /** Of the right half of a comparison. */
        wakesurfBeside?: PageFacts;
    }
}

/** Runs in the page, and therefore uses nothing of this file. */
function factsOf(scripted: ScriptedPage): PageFacts {
    const { state, scene, slices, latency, canvas, figure } = scripted.parts;
    const active = (): string => state.activeSurface.value ?? '';
    const displayed = (): DisplayedSurface | undefined => state.displayed.value.get(active());
    const requested = (): number => state.requestedEpochs.value.get(active()) ?? 0;
    const inWindow = (at: ScreenPoint | null): ScreenPoint | null => {
        const box = canvas.getBoundingClientRect();
        return at === null ? null : { x: at.x + box.left, y: at.y + box.top };
    };
    let contextLoss: WEBGL_lose_context | null = null;
    return {
        get framesDrawn() {
            return scene.framesDrawn;
        },
        get pixelRatio() {
            return scene.pixelRatio;
        },
        get samples() {
            return scene.samples;
        },
        get isAtRest() {
            return scene.isAtRest;
        },
        get connection() {
            return state.connection.value.state;
        },
        get stage() {
            return state.stage.value;
        },
        get session() {
            return state.session.value;
        },
        get phase() {
            return state.phase.value;
        },
        get requestedEpoch() {
            return requested();
        },
        get displayed() {
            return displayed() ?? null;
        },
        get allDisplayed() {
            return [...state.displayed.value.values()];
        },
        get rakePoints() {
            return scene.rakes.shape.points.map((point) => [...point] as Vec3);
        },
        get rakes() {
            return scene.rakes.drawn;
        },
        get bounds() {
            return state.dataset.value?.bounds ?? null;
        },
        get speedRange() {
            return state.speedRange.value;
        },
        get latencySamples() {
            return [...latency.samples];
        },
        get sliceLags() {
            return [...(slices.value?.slices.lags ?? [])];
        },
        get roundTripMs() {
            return state.roundTripMs.value;
        },
        get firstPictureMs() {
            return scene.firstPictureMs;
        },
        get camera() {
            const position = scene.controls.pose.position;
            return { position, target: scene.controls.target };
        },
        setCamera: (position, target, orthographic = false) => scene.controls.place({ position, target, orthographic }),
        project: (point) => inWindow(scene.project(point)),
        handleOnScreen: (handle) => inWindow(scene.project(scene.rakes.positionOf(handle, scene.view()))),
        arrowOnScreen: (axis) => {
            const arrow = scene.aim.arrows(scene.view()).find((each) => each.axis === axis);
            return arrow === undefined ? null : inWindow(scene.project(arrow.tip));
        },
        vertices: (every) => {
            const count = displayed()?.vertices ?? 0;
            const found: SurfaceVertex[] = [];
            for (let i = 0; i < count; i += every) {
                const vertex = scene.surfaces.vertexOf(active(), i);
                if (vertex !== null) found.push(vertex);
            }
            return found;
        },
        bodyVertices: (every) => scene.body.vertices(every),
        pick: ({ x, y }) => {
            const box = canvas.getBoundingClientRect();
            return scene.pick({ x: x - box.left, y: y - box.top });
        },
        pickGrid: ({ x, y }, radiusPx) => {
            const box = canvas.getBoundingClientRect();
            const grid = scene.pickGrid({ x: x - box.left, y: y - box.top }, radiusPx, {});
            return { ...grid, corner: { x: grid.corner.x + box.left, y: grid.corner.y + box.top } };
        },
        maskOf: (surface) => scene.surfaces.maskCode(surface) ?? null,
        get transparency() {
            return scene.transparency;
        },
        pixelsAt: (points, exact = false) => {
            const { width, height, pixels } = scene.readPixels(exact);
            const box = canvas.getBoundingClientRect();
            return points.map(({ x, y }) => {
                const column = Math.floor(((x - box.left) / box.width) * width);
                const row = height - 1 - Math.floor(((y - box.top) / box.height) * height);
                const at = 4 * (row * width + column);
                return [pixels[at] ?? 0, pixels[at + 1] ?? 0, pixels[at + 2] ?? 0];
            });
        },
        figure: ({ width, height }, tileSide) => {
            const drawn = figure.draw({ width, height }, 'Caption', undefined, tileSide);
            return drawn.getContext('2d')!.getImageData(0, 0, width, height).data;
        },
        unfinished: (time) => scripted.unfinished(time),
        picture: (setting) => scripted.picture(setting),
        get barLeftOut() {
            return scripted.barLeftOut;
        },
        loseContext: () => {
            contextLoss = scene.renderer.getContext().getExtension('WEBGL_lose_context');
            contextLoss?.loseContext();
        },
        restoreContext: () => contextLoss?.restoreContext(),
    };
}

/** Puts the facts in the place of what the page shows to programs, as soon as it is there. */
export async function showFacts(context: BrowserContext): Promise<void> {
    await context.addInitScript(`for (const name of ['wakesurf', 'wakesurfBeside']) {
        let facts;
        Object.defineProperty(window, name, { get: () => facts, set: (page) => (facts = (${factsOf.toString()})(page)) });
    }`);
}
