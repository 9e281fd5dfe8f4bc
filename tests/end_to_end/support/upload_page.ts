// Runs in a page: feeds the scene's surfaces with states as they come from the worker, and measures what that costs the main
// thread until the frame is submitted. The GPU finishes each frame before the next is measured.
import { PerspectiveCamera, Scene, WebGLRenderer } from 'three';
import { SurfaceLayer } from '../../../web-client/src/scene/surface/surfaceLayer.ts';
import type { TimedMeshChange } from '../../../web-client/src/mesh/meshChange.ts';

/** Medians, in milliseconds. */
export interface UploadCosts {
    move100kMs: number;
    add10kMs: number;
    add10kTo500kQuadsMs: number;
    nothingNewMs: number;
}

declare global {
    interface Window {
        uploadCosts?: () => Promise<UploadCosts>;
    }
}

const columns = 250;
const rounds = 15;

/** Rows of a wavy sheet from one row to another, as a state brings them. */
function sheet(fromRow: number, toRow: number, moved: number): TimedMeshChange {
    const count = (toRow - fromRow) * columns;
    const [positions, normals, seeds] = [new Float32Array(3 * count), new Float32Array(3 * count), new Float32Array(2 * count)];
    const values = new Float32Array(count);
    for (let i = 0; i < count; ++i) {
        const [row, column] = [fromRow + Math.floor(i / columns), i % columns];
        positions.set([column / columns, row / 1000, 0.05 * Math.sin(row / 9 + column / 7 + moved)], 3 * i);
        normals.set([0, 0, 1], 3 * i);
        seeds.set([column / columns, row], 2 * i);
        values[i] = column;
    }
    const firstCellRow = Math.max(0, fromRow - 1);
    const quads = (toRow - 1 - firstCellRow) * (columns - 1);
    const indices = new Uint32Array(6 * quads);
    for (let i = 0; i < quads; ++i) {
        const at = (firstCellRow + Math.floor(i / (columns - 1))) * columns + (i % (columns - 1));
        indices.set([at, at + 1, at + columns, at + 1, at + columns + 1, at + columns], 6 * i);
    }
    const fromVertex = fromRow * columns;
    return {
        time: 0,
        vertices: toRow * columns,
        triangles: 2 * (toRow - 1) * (columns - 1),
        ...{
            fromVertex,
            positions,
            fromNormal: fromVertex,
            normals,
            fromSeed: fromVertex,
            seeds,
            tFrom: 0,
        },
        scalars: [{ name: 'speed', fromVertex, values }],
        fromIndex: 6 * firstCellRow * (columns - 1),
        indices,
        parts: null,
        units: null,
        unresolved: null,
        cut: null,
    };
}

/** All vertices move; cells, s and t stay. */
function moved(rows: number, by: number): TimedMeshChange {
    const change = sheet(0, rows, by);
    return {
        ...change,
        fromSeed: rows * columns,
        seeds: new Float32Array(0),
        fromIndex: change.indices.length,
        indices: new Uint32Array(0),
    };
}

class Bench {
    private readonly layer = new SurfaceLayer();
    private readonly scene = new Scene();
    private readonly camera = new PerspectiveCamera(40, 1, 0.01, 10);
    private readonly renderer = new WebGLRenderer();

    constructor() {
        this.layer.attach(this.scene);
        this.renderer.setSize(320, 200);
        this.camera.position.set(0.5, 0.3, 2);
    }

    take(change: TimedMeshChange | null): number {
        const start = performance.now();
        if (change !== null) this.layer.set('s', change);
        this.renderer.render(this.scene, this.camera);
        const spent = performance.now() - start;
        const gl = this.renderer.getContext();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        return spent;
    }

    dispose(): void {
        this.layer.remove('s');
        this.renderer.dispose();
    }
}

function median(values: number[]): number {
    values.sort((a, b) => a - b);
    return Math.round((values[values.length >> 1] ?? Number.NaN) * 100) / 100;
}

/** Of states that are made before they are measured. */
async function measure(first: TimedMeshChange, next: (round: number) => TimedMeshChange | null): Promise<number> {
    const bench = new Bench();
    bench.take(first);
    const spent: number[] = [];
    for (let round = 0; round < rounds; ++round) {
        const change = next(round);
        await new Promise((resolve) => setTimeout(resolve, 20));
        spent.push(bench.take(change));
    }
    bench.dispose();
    return median(spent);
}

window.uploadCosts = async () => ({
    move100kMs: await measure(sheet(0, 400, 0), (round) => moved(400, round)),
    add10kMs: await measure(sheet(0, 400, 0), (round) => sheet(400 + 40 * round, 440 + 40 * round, 0)),
    add10kTo500kQuadsMs: await measure(sheet(0, 2010, 0), (round) => sheet(2010 + 40 * round, 2050 + 40 * round, 0)),
    nothingNewMs: await measure(sheet(0, 2010, 0), () => null),
});
