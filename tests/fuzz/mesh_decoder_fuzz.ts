// The page's mesh decoder under mutations of the golden sequences, their checksums made right again: what it cannot decode it refuses with a
// FrameError, keeps nothing of it, and takes little memory. Runs for --seconds S or --runs N (frames folded) and prints one line, and one every
// million runs.
import { FrameError } from '../../web-client/src/protocol/frameError.ts';
import { MeshDecoder } from '../../web-client/src/protocol/meshDecoder.ts';
import { frameHeaderBytes } from '../../web-client/src/protocol/meshFrame.ts';
import { dracoPoints, golden, goldenFrames } from '../../web-client/src/protocol/testing/golden.ts';
import { seededRandom } from '../../web-client/src/protocol/testing/random.ts';
import { sealed } from '../../web-client/src/protocol/testing/wireWriter.ts';

const names = ['sheet', 'hanging', 'refined', 'chaos', 'empty', 'growing'];
const noVertex = 0xffffffff;
const mostHeap = 512 << 20;

function option(name: string): number {
    const at = process.argv.indexOf(`--${name}`);
    return at < 0 ? Infinity : Number(process.argv[at + 1]);
}

const seconds = option('seconds');
const most = option('runs');
if (!(seconds < Infinity || most < Infinity)) {
    console.error('usage: mesh_decoder_fuzz.ts --seconds S | --runs N [--seed N]');
    process.exit(2);
}
const seed = process.argv.includes('--seed') ? option('seed') : 1;
const random = seededRandom(seed);
const sequences = names.map((name) => ({ name, frames: goldenFrames(name) }));

/// A frame with some bytes changed, cut off or put in twice.
function mutated(frame: Uint8Array): Uint8Array {
    let bytes = frame.slice();
    for (let round = random() % 4; round >= 0; round -= 1) {
        const at = random() % Math.max(1, bytes.length);
        switch (random() % 8) {
            case 0:
                bytes = bytes.slice(0, at);
                break;
            case 1:
                bytes = Uint8Array.from([...bytes.subarray(0, at), ...bytes.subarray(at, at + (random() % 32)), ...bytes.subarray(at)]);
                break;
            case 2: // extreme values where the header has numbers
                new DataView(bytes.buffer).setUint32(Math.min(at % frameHeaderBytes, Math.max(0, bytes.length - 4)), [0, 1, 0x7fffffff, noVertex][random() % 4]!, true);
                break;
            default:
                bytes[at]! ^= 1 << (random() % 8);
        }
        if (bytes.length < 4)
            return bytes;
    }
    return bytes.length < frameHeaderBytes ? bytes : sealed(bytes);
}

function check(decoder: MeshDecoder): void {
    const mesh = decoder.mesh;
    if (mesh === undefined)
        return;
    for (const id of mesh.cells)
        if (id >= mesh.vertices && id >>> 0 !== noVertex)
            throw new Error(`a decoded cell names vertex ${id} of ${mesh.vertices}`);
}

const points = await dracoPoints();
const start = performance.now();
let [runs, refused, slowest] = [0, 0, 0];

function report(): void {
    const [heap, took] = [points.heapBytes >> 20, (performance.now() - start) / 1000];
    console.log(`mesh_decoder.ts: ${runs} runs, ${refused} refused, slowest ${slowest.toFixed(0)} ms, Draco's heap ${heap} MiB, ${took.toFixed(0)} s`);
}

while (runs < most && performance.now() - start < 1000 * seconds) {
    const { name, frames } = sequences[random() % sequences.length]!;
    const decoder = new MeshDecoder(points, golden[name]!.lattice, golden[name]!.attributes);
    for (const frame of frames) {
        const before = performance.now();
        runs += 1;
        try {
            decoder.fold(random() % 3 === 0 ? frame : mutated(frame));
            check(decoder);
        } catch (error) {
            if (!(error instanceof FrameError)) {
                console.error(`broken: ${name}, seed ${seed}, run ${runs}`);
                throw error;
            }
            refused += 1;
        }
        slowest = Math.max(slowest, performance.now() - before);
        if (runs % 1_000_000 === 0)
            report();
    }
    if (points.heapBytes > mostHeap)
        throw new Error(`Draco's heap has grown to ${points.heapBytes} bytes`);
}
report();
