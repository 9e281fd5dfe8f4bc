// Streamlines as the server sends them: protocol/wire/FORMAT.md, Lines file. Twin: protocol/wire/lines_file.hpp.
import type { Vec3 } from './vec3.ts';

const headerBytes = 88;
const magic = 0x0154_5357; // W S T 1

/** Why ends of lines are where they are. */
export interface LineEnds {
    limit: number;
    domain: number;
    wall: number;
    rest: number;
    /** As many points, or steps, as a line may have. */
    cut: number;
}

export interface LinesFile {
    /** Line i has the points from offsets[i] to offsets[i + 1]. */
    offsets: Uint32Array<ArrayBuffer>;
    /** xyz of each, from `origin`. */
    points: Float32Array<ArrayBuffer>;
    /** Of the field at each point; not a number where it has none. */
    values: Float32Array<ArrayBuffer>;
    origin: Vec3;
    seeds: number;
    /** Of them in bodies or outside of the domain: they have no line. */
    outside: number;
    ends: LineEnds;
    /** Simulation time of the lines. */
    time: number;
}

/** Throws where the bytes are none. */
export function readLinesFile(bytes: ArrayBuffer): LinesFile {
    const wrong = (): Error => new Error('The server sent lines that this page cannot read.');
    const view = new DataView(bytes);
    if (bytes.byteLength < headerBytes || view.getUint32(0, true) !== magic) throw wrong();
    const whole = (at: number): number => view.getUint32(at, true);
    const number = (at: number): number => view.getFloat64(at, true);
    const [lines, points] = [whole(4), whole(8)];
    if (bytes.byteLength !== headerBytes + 4 * (2 * lines + 1) + 16 * points) throw wrong();
    const offsets = new Uint32Array(bytes, headerBytes, lines + 1);
    if (offsets[0] !== 0 || offsets[lines] !== points || offsets.some((each, i) => i > 0 && each < offsets[i - 1]!)) {
        throw wrong();
    }
    const at = headerBytes + 4 * (2 * lines + 1);
    return {
        offsets,
        points: new Float32Array(bytes, at, 3 * points),
        values: new Float32Array(bytes, at + 12 * points, points),
        origin: [number(64), number(72), number(80)],
        ...{ seeds: whole(12), outside: whole(16), time: number(40) },
        ends: { limit: whole(20), domain: whole(24), wall: whole(28), rest: whole(32), cut: whole(36) },
    };
}
