// A flow in which everything about a surface is known in closed form: along x with speed 1, and away from the plane z = 3.5, so
// that what is released at z0 is at z = 3.5 + (z0 - 3.5) exp(spread t), and areas grow by exp(spread t). Sheets of it at one y
// stay there: flat, and all of one colour for a camera without perspective.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Page } from 'playwright-core';
import { encodeLinkState } from '../../../web-client/src/session/view/urlState.ts';
import type { PageView } from '../../../web-client/src/state/pageView.ts';
import type { SurfaceLook } from '../../../web-client/src/state/surfaceLook.ts';
import type { Vec3 } from '../../../web-client/src/protocol/messages.ts';
import { ServerProcess, temporaryFolder } from './server_process.ts';

export const spread = 0.1;
export const middle = 3.5;
/** Of the page's dark surroundings. */
export const ground = [11, 16, 24] as const;

const points = Array.from({ length: 512 }, (_, i) => `1 0 ${(spread * (Math.floor(i / 64) - middle)).toFixed(6)}`);
const flow = `<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian">
<ImageData WholeExtent="0 7 0 7 0 7" Origin="0 0 0" Spacing="1 1 1"><Piece Extent="0 7 0 7 0 7"><PointData>
<DataArray type="Float32" Name="U" NumberOfComponents="3" format="ascii">${points.join(' ')}</DataArray>
</PointData></Piece></ImageData></VTKFile>`;

export interface Sheet {
    /** Of the rake: two of a line, three of a circle, more of a polyline. */
    points: Vec3[];
    /** How far in x it goes. */
    length: number;
    look: Partial<SurfaceLook>;
    fields?: string[];
}

/** A line across the middle of the flow. */
export function acrossAt(y: number): Vec3[] {
    return [
        [0.5, y, 2],
        [0.5, y, 5],
    ];
}

/** From which side of the sheets the camera looks, along y. */
export type Side = 'before' | 'behind';

/** Straight at the sheets, or turned from there by so many degrees to the right. */
function eyeAt(side: Side, turned = 0): { position: Vec3; target: Vec3 } {
    const [away, angle] = [side === 'before' ? -12 : 12, (turned * Math.PI) / 180];
    const position: Vec3 = [3.5 + Math.abs(away) * Math.sin(angle), middle + away * Math.cos(angle), middle];
    return { position, target: [3.5, middle, middle] };
}

/** Looks at the sheets from elsewhere, without perspective. */
export async function lookFrom(page: Page, side: Side, turned = 0): Promise<void> {
    await page.evaluate(({ position, target }) => window.wakesurf!.setCamera(position, target, true), eyeAt(side, turned));
}

export class FlatSheets {
    readonly server: ServerProcess;
    private readonly remove: () => void;

    private constructor(server: ServerProcess, remove: () => void) {
        this.server = server;
        this.remove = remove;
    }

    static async start(): Promise<FlatSheets> {
        const folder = temporaryFolder();
        const data = join(folder.path, 'fan.vti');
        writeFileSync(data, flow);
        const sheets = new FlatSheets(await ServerProcess.start({ store: folder.path, data }), folder.remove);
        await sheets.server.imported();
        return sheets;
    }

    async stop(): Promise<void> {
        await this.server.stop();
        this.remove();
    }

    /** A session with these sheets; their names by place in the list. */
    async session(sheets: readonly Sheet[]): Promise<{ session: string; surfaces: string[] }> {
        const { session } = (await this.server.call('session.create', {})) as { session: string };
        const { datasets } = (await this.server.call('dataset.list', {})) as { datasets: { dataset: string }[] };
        const surfaces: string[] = [];
        for (const { points: line, length, fields = [] } of sheets) {
            const kind = line.length === 2 ? 'line' : line.length === 3 ? 'circle' : 'polyline';
            const { rake } = await this.server.call('rake.set', { session, kind, seeds: 12, name: 'Sheet', points: line });
            const { surface } = await this.server.call('surface.set', {
                ...{ session, rake, dataset: datasets[0]!.dataset, kind: 'stream', separation: 0.3, from: 0, to: length },
                ...(fields.length === 0 ? {} : { fields }),
            });
            surfaces.push(String(surface));
        }
        return { session, surfaces };
    }

    /** To the sheets as they are seen straight from that side. */
    link(session: string, side: Side, looks: Record<string, Partial<SurfaceLook>>, view: PageView = {}): string {
        const camera = { ...eyeAt(side), orthographic: true };
        const link = new URL(this.server.link);
        const state = encodeLinkState({ view: { camera, looks, ...view }, rakes: [], surfaces: [] });
        link.hash = `session=${session}&token=${this.server.token}&state=${state}`;
        return link.href;
    }
}

/** Waits until so many surfaces are drawn at their finest, each with all that its look needs. */
export async function finalSheets(page: Page, count: number): Promise<void> {
    // Frames may come before the worker knows the looks. A sheet of smoke is final then, and drawn for one state more as if the server
    // did not measure its stretching: one or two steps of 255 beside what it is a moment later.
    const isFinal = (wanted: number): boolean =>
        window.wakesurf?.allDisplayed.length === wanted && window.wakesurf.unfinished(null) === '';
    await page.waitForFunction(isFinal, count, { timeout: 60_000 });
}
