// The golden frames that the C++ tests write and read, too: protocol/wire/fixtures.
import draco3d from 'draco3d';
import { readFileSync } from 'node:fs';
import { DracoPoints } from '../dracoPoints.ts';
import type { Lattice } from '../lattice.ts';

export interface GoldenVertex {
    node: number[];
    change: number[];
    codes: number[];
    position: number[];
    attributes: number[];
}

/** What the C++ decoder made of the frames: of each whole update in turn, and of the last. */
export interface Golden {
    frames: number;
    lattice: Lattice;
    surface: number;
    epoch: number;
    seqs: number[];
    stateSums: number[];
    changeSums: number[];
    phase: number;
    lossless: boolean;
    time: number;
    attributes: number;
    vertices: number;
    cells: number;
    firstVertex?: GoldenVertex;
    lastVertex?: GoldenVertex;
    firstCell?: number[];
    lastCell?: number[];
}

function fixture(name: string): URL {
    return new URL(`../../../../protocol/wire/fixtures/${name}`, import.meta.url);
}

export const golden = JSON.parse(readFileSync(fixture('golden.json'), 'utf8')) as Record<string, Golden>;

/** The frames of one golden file, each of which stands behind its length as u32. */
export function goldenFrames(name: string): Uint8Array[] {
    const bytes = Uint8Array.from(readFileSync(fixture(`${name}.bin`)));
    const view = new DataView(bytes.buffer);
    const frames: Uint8Array[] = [];
    for (let at = 0; at < bytes.length;) {
        const end = at + 4 + view.getUint32(at, true);
        frames.push(bytes.slice(at + 4, end));
        at = end;
    }
    return frames;
}

export async function dracoPoints(): Promise<DracoPoints> {
    return new DracoPoints(await draco3d.createDecoderModule({}));
}
