// Runs in a worker of the page state_page.ts: makes of the frames of a whole state what the page's worker makes of them, and says how long
// each stage took.
import type { TimedMeshChange } from '../../../web-client/src/mesh/meshChange.ts';
import { DracoPoints } from '../../../web-client/src/protocol/dracoPoints.ts';
import { MeshDecoder } from '../../../web-client/src/protocol/meshDecoder.ts';
import type { Subscription } from '../../../web-client/src/protocol/messages.ts';
import { DisplayArrays } from '../../../web-client/src/worker/displayArrays.ts';
import { loadDraco } from '../../../web-client/src/worker/draco.ts';
import { addNormals } from '../../../web-client/src/worker/vertexQuantities.ts';

export interface FoldedState {
    state: TimedMeshChange;
    decode: number;
    fold: number;
    arrays: number;
    normals: number;
    handedOver: number;
}

/** Counts the time that Draco takes. */
let decode = 0;
const timed = DracoPoints.prototype.decode;
DracoPoints.prototype.decode = function (...block) {
    const start = performance.now();
    timed.apply(this, block);
    decode += performance.now() - start;
};

const draco = loadDraco();
/** As after an edit: what is there of the surface before is taken over. */
let kept: { decoder: MeshDecoder; display: DisplayArrays } | null = null;

async function foldedState(frames: readonly Uint8Array[], agreed: Subscription): Promise<FoldedState> {
    kept ??= {
        decoder: new MeshDecoder(await draco, agreed.lattice, null),
        display: new DisplayArrays(agreed.lattice, agreed.attributes),
    };
    const { decoder, display } = kept;
    display.show({ attributes: ['speed'], parts: null, trimmed: true });
    decode = 0;
    const start = performance.now();
    const applied = frames.map((frame) => decoder.fold(frame)).at(-1);
    if (applied === undefined) throw new Error('the frames are no whole state');
    const folded = performance.now();
    display.note(applied);
    const change = display.take(applied.mesh);
    const made = performance.now();
    // Once more, alone.
    addNormals(change.positions, change.indices, 0, new Float32Array(3 * change.vertices));
    const normals = performance.now() - made;
    const spent = { decode, fold: folded - start - decode, arrays: made - folded - normals, normals };
    const handedOver = performance.timeOrigin + performance.now();
    return { state: { ...change, time: applied.header.time }, ...spent, handedOver };
}

self.onmessage = ({ data }: MessageEvent<{ frames: readonly Uint8Array[]; agreed: Subscription }>) => {
    void foldedState(data.frames, data.agreed).then((folded) => {
        const { positions, normals, seeds, scalars, indices, cut } = folded.state;
        const arrays = [
            positions,
            normals,
            seeds,
            indices,
            ...scalars.map(({ values }) => values),
            ...(cut === null ? [] : [cut.levels]),
        ];
        self.postMessage(folded, { transfer: arrays.map(({ buffer }) => buffer) });
    });
};
