// Holds what the painter has revealed of a surface, in its own coordinates s and t: stays where it is when
// the mesh is refined, moves or goes on. (The surface painter of McLoughlin, Laramee and Zhang, 2009.)
import { DataTexture, LinearFilter, RedFormat, UnsignedByteType } from 'three';
import { encodeMask, type MaskContent, maskSize } from './maskCode.ts';
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
