// Runs in a worker of the browser: decodes updates as the page's worker does and reports how long each took.
import { keepDracoSmall, loadDraco } from '../../../web-client/src/worker/draco.ts';
import { DisplayArrays } from '../../../web-client/src/worker/displayArrays.ts';
import { MeshDecoder } from '../../../web-client/src/protocol/meshDecoder.ts';
import { readFrame } from '../../../web-client/src/protocol/meshFrame.ts';

/** Of one DELTA: vertices that moved or came, and milliseconds. */
export interface DecodedUpdate {
    vertices: number;
    decodeMs: number;
    /** From the state to the arrays of the GPU: positions, scalars, triangles, normals. */
    arraysMs: number;
}

const lattice = (bits: number) => ({ origin: [0, 0, 0] as [number, number, number], step: 2 ** -bits, bits });

/** Arrays of positions and one scalar are part of decoding: floats are what was asked for. */
async function measure(frames: Uint8Array[], rounds: number): Promise<DecodedUpdate[]> {
    const draco = await loadDraco();
    const { latticeBits, attributeCount } = readFrame(frames[0]!).header;
    const measured: DecodedUpdate[] = [];
    for (let round = 0; round < rounds; ++round) {
        const decoder = new MeshDecoder(draco, lattice(latticeBits), attributeCount);
        // The page draws the first attribute; s and t come with it.
        const names = ['speed', 's', 't', ...Array.from({ length: attributeCount }, (_, i) => `${i}`)];
        const display = new DisplayArrays(lattice(latticeBits), names.slice(0, attributeCount));
        display.show({ attributes: ['speed'], parts: null, trimmed: true });
        let start = performance.now();
        for (const frame of frames) {
            const applied = decoder.fold(frame);
            if (applied === undefined) continue;
            const { header, edit, mesh } = applied;
            display.note(applied);
            const decoded = performance.now();
            display.take(mesh);
            const end = performance.now();
            const vertices = edit.movedVertices.count + edit.addedVertices;
            if (!header.key) measured.push({ vertices, decodeMs: decoded - start, arraysMs: end - decoded });
            keepDracoSmall(draco);
            start = performance.now();
        }
    }
    return measured;
}

self.onmessage = ({ data }: MessageEvent<{ frames: Uint8Array[]; rounds: number }>) => {
    measure(data.frames, data.rounds).then(
        (updates) => self.postMessage({ updates }),
        (error: unknown) => self.postMessage({ error: String(error) }),
    );
};
