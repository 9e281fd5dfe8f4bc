// Runs in a page: takes whole states of a surface as the worker hands them on, and measures what each stage costs.
import { PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import type { TimedMeshChange } from '../../../web-client/src/mesh/meshChange.ts';
import type { Subscription } from '../../../web-client/src/protocol/messages.ts';
import { SurfaceLayer } from '../../../web-client/src/scene/surface/surfaceLayer.ts';
import type { FoldedState } from './state_worker.ts';

/** Milliseconds from one round to the next; bytes of the whole state. */
export interface StateCosts {
    decode: number[];
    fold: number[];
    arrays: number[];
    normals: number[];
    /** From the worker to the page. */
    handOver: number[];
    /** Into the buffers, which are submitted. */
    upload: number[];
    draw: number[];
    uploadedBytes: number;
}

declare global {
    interface Window {
        stateCosts?: (frames: readonly string[], agreed: Subscription, rounds: number) => Promise<StateCosts>;
    }
}

class Screen {
    private readonly layer = new SurfaceLayer();
    private readonly scene = new Scene();
    private readonly camera = new PerspectiveCamera(40, innerWidth / innerHeight, 0.01, 1000);
    /** As the page has it without graphics hardware. */
    private readonly renderer = new WebGLRenderer({ antialias: false });

    constructor() {
        this.layer.attach(this.scene);
        this.renderer.setSize(innerWidth, innerHeight);
    }

    /** All of the surface is in the picture. */
    lookAt(state: TimedMeshChange): void {
        this.layer.set('s', state);
        const [x0, x1, y0, y1, z0, z1] = this.layer.boxOf('s')!;
        const middle = new Vector3(x0 + x1, y0 + y1, z0 + z1).multiplyScalar(0.5);
        const far = 1.5 * Math.hypot(x1 - x0, y1 - y0, z1 - z0);
        this.camera.position.copy(middle).addScalar(far / Math.sqrt(3));
        this.camera.lookAt(middle);
        this.show();
    }

    show(state?: TimedMeshChange): { upload: number; draw: number } {
        const start = performance.now();
        if (state !== undefined) this.layer.set('s', state);
        this.renderer.render(this.scene, this.camera);
        const submitted = performance.now();
        const gl = this.renderer.getContext();
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        return { upload: submitted - start, draw: performance.now() - submitted };
    }
}

function bytesOf({ positions, normals, seeds, indices, scalars, cut }: TimedMeshChange): number {
    const arrays = [
        positions,
        normals,
        seeds,
        indices,
        ...scalars.map(({ values }) => values),
        ...(cut === null ? [] : [cut.levels]),
    ];
    return arrays.reduce((sum, { byteLength }) => sum + byteLength, 0);
}

window.stateCosts = async (coded, agreed, rounds) => {
    const frames = coded.map((text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
    const worker = new Worker(new URL('./state_worker.ts', import.meta.url), { type: 'module' });
    const folded = (): Promise<FoldedState> =>
        new Promise((resolve, reject) => {
            worker.onmessage = ({ data }: MessageEvent<FoldedState>) => {
                resolve({ ...data, handedOver: performance.timeOrigin + performance.now() - data.handedOver });
            };
            worker.onerror = ({ message }) => reject(new Error(message));
            worker.postMessage({ frames, agreed });
        });
    const screen = new Screen();
    const costs: StateCosts = {
        decode: [],
        fold: [],
        arrays: [],
        normals: [],
        handOver: [],
        upload: [],
        draw: [],
        uploadedBytes: 0,
    };
    screen.lookAt((await folded()).state);
    for (let round = 0; round < rounds; ++round) {
        const { state, decode, fold, arrays, normals, handedOver } = await folded();
        const { upload, draw } = screen.show(state);
        const spent = { decode, fold, arrays, normals, handOver: handedOver, upload, draw };
        for (const [stage, ms] of Object.entries(spent)) costs[stage as keyof typeof spent].push(ms);
        costs.uploadedBytes = bytesOf(state);
    }
    worker.terminate();
    return costs;
};
