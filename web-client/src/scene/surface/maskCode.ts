// Writes what the painter has revealed as a short text for links and bookmarks: as fine as there is room for.
// Bits by rows, each as its difference from the row before, in run lengths, in base64url. What comes back may
// be of strangers.

/** Texels a side of a mask, over s and over its part of t. */
export const maskSize = 512;
/** Characters of a code. */
export const longestCode = 800;

export interface MaskContent {
    /** maskSize by maskSize, rows along t; 255: revealed, 0: not. */
    texels: Uint8Array<ArrayBuffer>;
    tStart: number;
    tLength: number;
}

const sizes = [256, 128, 64] as const;
const headBytes = 17;

/** Null: too intricate for so short a text. */
export function encodeMask(mask: MaskContent): string | null {
    for (const size of sizes) {
        const code = codeOf(mask, size);
        if (code !== null) return code;
    }
    return null;
}

/** Null where it is none; never throws. */
export function decodeMask(text: string): MaskContent | null {
    const bytes = text.length <= longestCode ? bytesOf(text) : null;
    if (bytes === null || bytes.length < headBytes) return null;
    const head = new DataView(bytes.buffer);
    const size = sizes.find((each) => Math.log2(each) === bytes[0]);
    const [tStart, tLength] = [head.getFloat64(1), head.getFloat64(9)];
    if (size === undefined || !Number.isFinite(tStart) || !(tLength > 0 && Number.isFinite(tLength))) return null;
    const bits = bitsOf(bytes.subarray(headBytes), size);
    return bits === null ? null : { texels: enlarged(bits, size), tStart, tLength };
}

function codeOf({ texels, tStart, tLength }: MaskContent, size: number): string | null {
    const bits = reduced(texels, size);
    const bytes: number[] = [];
    let [run, value] = [0, 0];
    for (let i = 0; i < bits.length; ++i) {
        if ((bits[i]! ^ (bits[i - size] ?? 0)) !== value) {
            pushNumber(bytes, run);
            if (4 * (headBytes + bytes.length) > 3 * longestCode) return null;
            [run, value] = [0, 1 - value];
        }
        ++run;
    }
    // The last run is of equal rows, which need not be said, or of unequal ones.
    if (value === 1) pushNumber(bytes, run);
    const head = new DataView(new ArrayBuffer(headBytes));
    head.setUint8(0, Math.log2(size));
    head.setFloat64(1, tStart);
    head.setFloat64(9, tLength);
    const all = String.fromCharCode(...new Uint8Array(head.buffer), ...bytes);
    const code = btoa(all).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
    return code.length <= longestCode ? code : null;
}

function bytesOf(text: string): Uint8Array<ArrayBuffer> | null {
    try {
        return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (each) => each.charCodeAt(0));
    } catch {
        return null;
    }
}

/** Null where runs are longer than there is room for. */
function bitsOf(bytes: Uint8Array, size: number): Uint8Array | null {
    const bits = new Uint8Array(size * size);
    let [at, value, number, shift] = [0, 0, 0, 0];
    for (const byte of bytes) {
        number += (byte & 127) << shift;
        shift += 7;
        if (shift > 21) return null;
        if (byte > 127) continue;
        if (at + number > bits.length) return null;
        bits.fill(value, at, at + number);
        [at, value, number, shift] = [at + number, 1 - value, 0, 0];
    }
    for (let i = size; i < bits.length; ++i) bits[i]! ^= bits[i - size]!;
    return shift === 0 ? bits : null;
}

/** Least significant seven bits first; a byte that is not the last has its highest bit set. */
function pushNumber(bytes: number[], number: number): void {
    let rest = number;
    for (; rest > 127; rest >>= 7) bytes.push(128 | (rest & 127));
    bytes.push(rest);
}

/** Revealed is what is so by half at least. */
function reduced(texels: Uint8Array, size: number): Uint8Array {
    const step = maskSize / size;
    const counts = new Uint16Array(size * size);
    for (let i = 0; i < texels.length; ++i) {
        if (texels[i]! < 128) continue;
        const [row, column] = [Math.floor(i / maskSize), i % maskSize];
        ++counts[Math.floor(row / step) * size + Math.floor(column / step)]!;
    }
    return Uint8Array.from(counts, (count) => (2 * count >= step * step ? 1 : 0));
}

function enlarged(bits: Uint8Array, size: number): Uint8Array<ArrayBuffer> {
    const step = maskSize / size;
    const texels = new Uint8Array(maskSize * maskSize);
    for (let row = 0; row < maskSize; ++row) {
        const from = Math.floor(row / step) * size;
        for (let column = 0; column < maskSize; ++column) {
            texels[row * maskSize + column] = bits[from + Math.floor(column / step)]! * 255;
        }
    }
    return texels;
}
