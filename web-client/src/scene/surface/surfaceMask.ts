// What the painter has revealed of a surface, in its own coordinates s and t: stays where it is when the mesh is refined, moves or goes on
// (the surface painter of McLoughlin, Laramee and Zhang, 2009). Links and bookmarks carry it as a short text, as fine as there is room for:
// bits by rows, each as its difference from the row before, in run lengths, in base64url. What comes back may be of strangers.
import { DataTexture, LinearFilter, RedFormat, UnsignedByteType } from 'three';
import type { PickHit } from './pickHit.ts';

/** Neighbouring pixels further apart than this lie on different folds, and nothing between them is meant. */
const farthestTexels = 64;

type Range = readonly [number, number];

/** Pixels round the brush, by rows. */
export interface BrushPrint {
    size: number;
    hits: readonly (PickHit | null)[];
    radiusPx: number;
}

export class SurfaceMask {
    readonly texture: DataTexture;
    /** Where t is at the first row, and how much of it all rows have. */
    tStart: number;
    tLength: number;
    readonly texels: Uint8Array<ArrayBuffer>;
    /** Undefined: changed since it was last worked out. */
    private known: string | null | undefined;

    constructor([low, high]: Range, content: MaskContent | null = null) {
        this.tStart = content?.tStart ?? low;
        this.tLength = content?.tLength ?? Math.max(high - low, 1e-12);
        this.texels = content?.texels ?? new Uint8Array(maskSize * maskSize);
        this.texture = new DataTexture(this.texels, maskSize, maskSize, RedFormat, UnsignedByteType);
        this.texture.minFilter = this.texture.magFilter = LinearFilter;
        this.changed();
    }

    /** For links; null: too intricate for one. */
    get code(): string | null {
        if (this.known === undefined) this.known = encodeMask(this);
        return this.known;
    }

    fill(revealed: boolean): void {
        this.texels.fill(revealed ? 255 : 0);
        this.changed();
    }

    /** Reaches as far in t as the surface does now; what is there stays at its t. */
    cover([low, high]: Range): void {
        while (high > this.tStart + this.tLength * 1.0001) this.double(0);
        while (low < this.tStart - this.tLength * 0.0001) this.double(maskSize / 2);
    }

    /** Reveals (or hides) where the brush touches this surface. */
    stamp(surface: string, { size, hits, radiusPx }: BrushPrint, reveal: boolean): void {
        const centre = (size - 1) / 2;
        const touched = (column: number, row: number): PickHit | null => {
            const hit = column < size && row < size ? (hits[row * size + column] ?? null) : null;
            return hit?.surface === surface && Math.hypot(column - centre, row - centre) <= radiusPx ? hit : null;
        };
        for (let row = 0; row < size; ++row) {
            for (let column = 0; column < size; ++column) {
                const hit = touched(column, row);
                if (hit === null) continue;
                this.fillBetween([hit, touched(column + 1, row), touched(column, row + 1)], reveal ? 255 : 0);
            }
        }
        this.changed();
    }

    dispose(): void {
        this.texture.dispose();
    }

    /** All texels between the first hit and the others, where these are near. */
    private fillBetween([first, ...others]: readonly (PickHit | null)[], value: number): void {
        const [column, row] = [this.columnOf(first!.s), this.rowOf(first!.t)];
        let [left, right, low, high] = [column, column, row, row];
        for (const other of others) {
            if (other === null) continue;
            const [x, y] = [this.columnOf(other.s), this.rowOf(other.t)];
            if (Math.max(Math.abs(x - column), Math.abs(y - row)) > farthestTexels) continue;
            [left, right] = [Math.min(left, x), Math.max(right, x)];
            [low, high] = [Math.min(low, y), Math.max(high, y)];
        }
        for (let y = low; y <= high; ++y) this.texels.fill(value, y * maskSize + left, y * maskSize + right + 1);
    }

    private columnOf(s: number): number {
        return Math.min(maskSize - 1, Math.max(0, Math.floor(s * maskSize)));
    }

    private rowOf(t: number): number {
        return Math.min(maskSize - 1, Math.max(0, Math.floor(((t - this.tStart) / this.tLength) * maskSize)));
    }

    /** Twice as much t; what there was becomes the half that begins at row `to`. */
    private double(to: number): void {
        const former = this.texels.slice();
        this.texels.fill(0);
        for (let row = 0; row < maskSize / 2; ++row) {
            for (let column = 0; column < maskSize; ++column) {
                const [a, b] = [former[2 * row * maskSize + column]!, former[(2 * row + 1) * maskSize + column]!];
                this.texels[(to + row) * maskSize + column] = Math.max(a, b);
            }
        }
        if (to > 0) this.tStart -= this.tLength;
        this.tLength *= 2;
        this.changed();
    }

    private changed(): void {
        this.known = undefined;
        this.texture.needsUpdate = true;
    }
}

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
