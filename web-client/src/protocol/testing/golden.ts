// The golden frames that the C++ tests write and read, too: protocol/fixtures.
import draco3d from 'draco3d';
import { readFileSync } from 'node:fs';
import { DracoPoints } from '../dracoPoints.ts';
import type { Lattice } from '../lattice.ts';

export interface GoldenVertex {
    node: number[];
    position: number[];
    attributes: number[];
}

export interface Golden {
    frames: number;
    lattice: Lattice;
    attributes: string[];
    surface: number;
    epoch: number;
    seq: number;
    complete: boolean;
    final: boolean;
    vertices: number;
    cells: number;
    stateCrc: number;
    positionCrc: number;
    attributeCrc: number;
    firstVertex?: GoldenVertex;
    lastVertex?: GoldenVertex;
    firstCell?: number[];
    lastCell?: number[];
}

function fixture(name: string): URL {
    return new URL(`../../../../protocol/fixtures/${name}`, import.meta.url);
}

export const golden = JSON.parse(readFileSync(fixture('golden.json'), 'utf8')) as Record<string, Golden>;

/// The frames of one golden file, each of which stands behind its length as u32.
export function goldenFrames(name: string): Uint8Array[] {
    const bytes = Uint8Array.from(readFileSync(fixture(`${name}.bin`)));
    const view = new DataView(bytes.buffer);
    const frames: Uint8Array[] = [];
    for (let at = 0; at < bytes.length; ) {
        const end = at + 4 + view.getUint32(at, true);
        frames.push(bytes.slice(at + 4, end));
        at = end;
    }
    return frames;
}

export async function dracoPoints(): Promise<DracoPoints> {
    return new DracoPoints(await draco3d.createDecoderModule({}));
}
