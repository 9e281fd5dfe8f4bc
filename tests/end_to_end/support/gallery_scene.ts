// The scenes of docs/site/gallery.json, and a page that shows one: its records are made by calls, its look and camera come by the link.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { noClip, type PageView } from '../../../web-client/src/state/pageView.ts';
import { encodeLinkState } from '../../../web-client/src/session/view/urlState.ts';
import type { BodyLook } from '../../../web-client/src/state/bodyLook.ts';
import type { SliceLook } from '../../../web-client/src/state/sliceLook.ts';
import type { SurfaceLook } from '../../../web-client/src/state/surfaceLook.ts';
import type { Vec3 } from '../../../web-client/src/protocol/messages.ts';
import { finalSurface } from './browser_page.ts';
import { projectRoot } from './project_root.ts';
import type { ServerProcess } from './server_process.ts';

export interface Scene {
    name: string;
    title: string;
    data: string;
    /** As surface.set takes it; rakes are their points. */
    surface: { kind: string; rake: Vec3[]; rake2?: Vec3[]; seeds?: number; to: number } & Record<string, unknown>;
    /** Made first, as family.make takes it, for the surface to be a level set of. */
    family?: Record<string, unknown>;
    look: Partial<SurfaceLook>;
    camera: { position: Vec3; target: Vec3 };
    /** The rake is in the picture, and the box of the domain with its numbers. */
    rake?: boolean;
    /** The flow along the body is shown on it. */
    body?: Partial<BodyLook>;
    axes?: boolean;
    /** As the page in the dark has it; else on white. */
    dark?: boolean;
    /** As slice.set and lines.set take them. */
    slices?: Record<string, unknown>[];
    lines?: Record<string, unknown>[];
    sliceLook?: Partial<SliceLook>;
    /** Surfaces are cut at the first slice, on the side of its normal. */
    cut?: boolean;
    size?: [number, number];
}

export interface FilmScene extends Scene {
    size: [number, number];
    from: number;
    until: number;
    frames: number;
    framesPerSecond: number;
}

export function readGallery(): { scenes: Scene[]; film: FilmScene } {
    return JSON.parse(readFileSync(join(projectRoot, 'docs/site/gallery.json'), 'utf8')) as { scenes: Scene[]; film: FilmScene };
}

/** As the server names the dataset of a path or a flow. */
export function datasetOf({ data }: Scene): string {
    return data.startsWith('flow:') ? data.slice('flow:'.length) : data.replace(/^.*\/|\.\w+$/g, '');
}

/** As an argument of `wakesurf serve`, from any folder. */
export function sourceOf({ data }: Scene): string {
    return data.startsWith('flow:') ? data : join(projectRoot, data);
}

/** Makes a session that has the scene, and returns a link to it as it is seen. */
export async function linkTo(server: ServerProcess, scene: Scene): Promise<string> {
    const { session } = (await server.call('session.create', { name: scene.title })) as { session: string };
    const { rake: points, rake2: second, seeds = 32, ...parameters } = scene.surface;
    const rakeOf = async (line: Vec3[]): Promise<string> => {
        const kind = line.length === 2 ? 'line' : 'polyline';
        return String((await server.call('rake.set', { session, kind, points: line, seeds, colour: '#d1495b' }))['rake']);
    };
    const rake = await rakeOf(points);
    const more = second === undefined ? {} : { rake2: await rakeOf(second) };
    const dataset = datasetOf(scene);
    if (scene.family !== undefined) await server.call('family.make', { dataset, ...scene.family });
    const { surface } = await server.call('surface.set', { session, rake, dataset, ...more, ...parameters });
    await server.call('surface.wait', { session, surface, timeoutMs: 120_000 });
    const slices: string[] = [];
    for (const slice of scene.slices ?? []) {
        slices.push(String((await server.call('slice.set', { session, dataset, ...slice }))['slice']));
    }
    for (const lines of scene.lines ?? []) await server.call('lines.set', { session, dataset, ...lines });
    const view: PageView = {
        camera: { ...scene.camera, orthographic: false },
        surface: String(surface),
        looks: { [String(surface)]: scene.look },
        ...(scene.cut === true ? { clip: { ...noClip, slice: { id: slices[0]!, flipped: false } } } : {}),
        ...(scene.body === undefined ? {} : { body: scene.body }),
        ...(scene.sliceLook === undefined ? {} : { slices: scene.sliceLook }),
    };
    const state = encodeLinkState({ view, rakes: [], surfaces: [] });
    return `${server.link}&session=${session}&dataset=${encodeURIComponent(dataset)}&state=${state}`;
}

/** Waits until the page shows the scene's surface at its finest, in its colours, and the picture gets no better. */
export async function settled(page: Page): Promise<void> {
    await finalSurface(page);
    await page.evaluate(async () => {
        const hook = window.wakesurf!;
        // What was chosen just now is drawn in the next frames.
        for (let still = 0, drawn = -1; still < 6; drawn = hook.framesDrawn) {
            await new Promise(requestAnimationFrame);
            still = hook.framesDrawn === drawn && hook.isAtRest && hook.unfinished(null) === '' ? still + 1 : 0;
        }
    });
}
