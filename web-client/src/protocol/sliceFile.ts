// A slice's raster as the server sends it: protocol/wire/FORMAT.md, Slice file. Twin: protocol/wire/slice_file.hpp.
import type { Vec3 } from './vec3.ts';

export const noSliceValue = 65535;
export const sliceCodes = 65534;
const headerBytes = 112;
const magic = 0x014c_5357; // W S L 1
const mostSamples = 2 ** 24;

export interface SliceRaster {
    columns: number;
    rows: number;
    /** Samples in the domain and outside bodies, with or without a value. */
    inFlow: number;
    /** A corner of the rectangle, and its two sides from there. */
    corner: Vec3;
    across: Vec3;
    up: Vec3;
    /** Simulation time of the values. */
    time: number;
    /** Of code 0 and of code `sliceCodes`. */
    range: [number, number];
    /** Row by row from the corner, along `across` first. */
    codes: Uint16Array<ArrayBuffer>;
}

/** Throws where the bytes are none. */
export function readSliceFile(bytes: ArrayBuffer): SliceRaster {
    const wrong = (): Error => new Error('The server sent a slice that this page cannot read.');
    const view = new DataView(bytes);
    if (bytes.byteLength < headerBytes || view.getUint32(0, true) !== magic) throw wrong();
    const [columns, rows, inFlow] = [4, 8, 12].map((at) => view.getUint32(at, true)) as [number, number, number];
    const samples = columns * rows;
    if (samples === 0 || samples > mostSamples || bytes.byteLength !== headerBytes + 2 * samples) throw wrong();
    const number = (at: number): number => view.getFloat64(at, true);
    const vector = (at: number): Vec3 => [number(at), number(at + 8), number(at + 16)];
    return {
        ...{ columns, rows, inFlow, corner: vector(16), across: vector(40), up: vector(64), time: number(88) },
        range: [number(96), number(104)],
        codes: new Uint16Array(bytes, headerBytes, samples),
    };
}

/** Over the part of the plane that has values: its area, and the mean of them; null: none has. */
export function sliceNumbers({ codes, range: [low, high], across, up }: SliceRaster): { area: number; mean: number } | null {
    let [known, sum] = [0, 0];
    for (const code of codes) {
        if (code === noSliceValue) continue;
        sum += code;
        ++known;
    }
    if (known === 0) return null;
    const whole = Math.hypot(...across) * Math.hypot(...up);
    return { area: (whole * known) / codes.length, mean: low + ((high - low) * (sum / known)) / sliceCodes };
}

/** The values between which all but one per cent at each end lie; null: there are none. */
export function usualRange({ codes, range: [low, high] }: SliceRaster): [number, number] | null {
    const counts = new Uint32Array(sliceCodes + 1);
    let known = 0;
    for (const code of codes) {
        if (code === noSliceValue) continue;
        counts[code] = counts[code]! + 1;
        ++known;
    }
    if (known === 0) return null;
    const left = Math.floor(known / 100);
    const end = (from: number, step: 1 | -1): number => {
        let passed = 0;
        for (let code = from; ; code += step) {
            passed += counts[code]!;
            if (passed > left) return low + ((high - low) * code) / sliceCodes;
        }
    };
    return [end(0, 1), end(sliceCodes, -1)];
}
