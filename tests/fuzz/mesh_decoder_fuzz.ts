// The page's mesh decoder under mutations of the golden sequences and of random ones, their checksums made right again: what it cannot decode it
// refuses with a FrameError, keeps nothing of it, and takes little memory and time. Runs for --seconds S or --runs N (frames folded) and prints
// one line, and one every million runs.
import { FrameError } from '../../web-client/src/protocol/bytes.ts';
import type { Lattice } from '../../web-client/src/protocol/lattice.ts';
import { MeshDecoder } from '../../web-client/src/protocol/meshDecoder.ts';
import { frameHeaderBytes } from '../../web-client/src/protocol/meshFrame.ts';
import { dracoPoints, golden, goldenFrames } from '../../web-client/src/protocol/testing/golden.ts';
import { lattice, randomUpdates, ranges, seededRandom } from '../../web-client/src/protocol/testing/randomSurface.ts';
import { sealed } from '../../web-client/src/protocol/testing/wireWriter.ts';

const names = ['sheet', 'hanging', 'refined', 'chaos', 'empty', 'growing'];
const randomSequences = 100;
const updatesOfRandom = 4;
const noVertex = 0xffffffff;
const mostHeap = 512 << 20;
const mostMilliseconds = 1000; // of the processor, for one frame
const framesAnEpoch = 256;

interface Sequence {
    name: string;
    lattice: Lattice;
    attributes: number;
    frames: Uint8Array[];
}

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
Error.stackTraceLimit = 0; // most frames are refused; what is broken says the seed and the run
const goldenSequences: Sequence[] = names.map((name) => {
    const { lattice: agreed, attributes } = golden[name]!;
    return { name, lattice: agreed, attributes, frames: goldenFrames(name) };
});
// Small ones, with every kind of block and of edit.
const smallSequences: Sequence[] = Array.from({ length: randomSequences }, (_, i) => {
    const frames = randomUpdates(1000 * seed + i + 1, updatesOfRandom).flatMap((update) => update.frames);
    return { name: `random ${i}`, lattice, attributes: ranges.length, frames };
});

/** With `count` bytes from `from` on said twice. */
function doubled(bytes: Uint8Array, from: number, count: number): Uint8Array {
    const again = bytes.subarray(from, from + count);
    const longer = new Uint8Array(bytes.length + again.length);
    longer.set(bytes.subarray(0, from));
    longer.set(again, from);
    longer.set(bytes.subarray(from), from + again.length);
    return longer;
}

/** A frame with some bytes changed, cut off or put in twice. */
function mutated(frame: Uint8Array): Uint8Array {
    let bytes: Uint8Array = frame.slice();
    for (let round = random() % 4; round >= 0; --round) {
        const at = random() % Math.max(1, bytes.length);
        switch (random() % 8) {
            case 0:
                bytes = bytes.slice(0, at);
                break;
            case 1:
                bytes = doubled(bytes, at, random() % 32);
                break;
            case 2: // extreme values where the header has numbers
                new DataView(bytes.buffer).setUint32(
                    Math.min(at % frameHeaderBytes, Math.max(0, bytes.length - 4)),
                    [0, 1, 0x7fffffff, noVertex][random() % 4]!,
                    true,
                );
                break;
            default:
                bytes[at]! ^= 1 << (random() % 8);
        }
        if (bytes.length < 4) return bytes;
    }
    return bytes.length < frameHeaderBytes ? bytes : sealed(bytes);
}

function check(decoder: MeshDecoder): void {
    const mesh = decoder.mesh;
    if (mesh === undefined) return;
    for (const id of mesh.cells) {
        if (id >= mesh.vertices && id >>> 0 !== noVertex) {
            throw new Error(`a decoded cell names vertex ${id} of ${mesh.vertices}`);
        }
    }
}

const points = await dracoPoints();
const start = performance.now();
let [runs, refused, slowest] = [0, 0, 0];
let epoch = process.cpuUsage(); // read for every frame it would cost as much as the frame

function report(): void {
    const [heap, took] = [points.heapBytes >> 20, (performance.now() - start) / 1000];
    console.log(
        `mesh_decoder.ts: ${runs} runs, ${refused} refused, slowest ${slowest.toFixed(0)} ms, Draco's heap ${heap} MiB, ${took.toFixed(0)} s`,
    );
}

/** Folds one frame, whole or mutated; false where it was refused. */
function fold(decoder: MeshDecoder, frame: Uint8Array): boolean {
    ++runs;
    try {
        decoder.fold(random() % 2 === 0 ? frame : mutated(frame));
        check(decoder);
        return true;
    } catch (error) {
        if (!(error instanceof FrameError)) throw error;
        if (decoder.mesh !== undefined) throw new Error('something is kept of a mesh that was refused');
        ++refused;
        return false;
    }
}

/** A sequence from its start until a frame is refused; now and then beyond, where only a KEY may be taken. */
function run({ lattice: agreed, attributes, frames }: Sequence): void {
    const decoder = new MeshDecoder(points, agreed, attributes);
    for (const frame of frames) {
        if (runs % framesAnEpoch === 0) epoch = process.cpuUsage();
        const before = performance.now();
        const taken = fold(decoder, frame);
        const took = performance.now() - before;
        if (took > slowest) {
            const { user, system } = process.cpuUsage(epoch);
            slowest = Math.max(slowest, Math.min(took, (user + system) / 1000)); // not what others had the processor for
        }
        if (slowest > mostMilliseconds) throw new Error(`a frame took ${slowest.toFixed(0)} ms`);
        if (runs % 1_000_000 === 0) report();
        if (!taken && random() % 8 !== 0) return;
    }
}

while (runs < most && performance.now() - start < 1000 * seconds) {
    const from = random() % 8 === 0 ? goldenSequences : smallSequences;
    const sequence = from[random() % from.length]!;
    try {
        run(sequence);
    } catch (error) {
        console.error(`broken: ${sequence.name}, seed ${seed}, run ${runs}`);
        throw error;
    }
    if (points.heapBytes > mostHeap) throw new Error(`Draco's heap has grown to ${points.heapBytes} bytes`);
}
report();
