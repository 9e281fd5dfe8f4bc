// The compact code of the cells: which vertices a cell has is expected from the cells around it and from those before it, and
// only whether that is so is coded. protocol/wire/README.md, Cells code. Twin: protocol/wire/cells_code.hpp.
import { cellStride } from './cell.ts';
import { CellModel } from './cellModel.ts';
import { FrameError } from './frameError.ts';
import { OpenSides } from './openSides.ts';
import { RangeDecoder } from './rangeDecoder.ts';
import { forEachGap, type Runs } from './runs.ts';

/** What both ends know when they come to the cells of an update: replaced ones first, then those that are added. */
export interface CellContext {
    vertices: number; // of the state after
    stay: number; // of those, vertices that were there before
    kept: Int32Array; // cells, those to be replaced as they were before
    replaced: Runs;
    near: readonly number[]; // cells by a vertex that has lost something; see KeptCells
}

const mostCellsAByte = 12_000;

/** Of the cells that stay as they are these are looked at: the last ones, where rows grow, and those by a touched vertex. */
const newestKept = 4096;

/** Gives `count` cells. Throws FrameError. */
export function decodeCells(code: Uint8Array, count: number, context: CellContext): Int32Array {
    // A cell that repeats what the one before did costs 0.0007 bits at the least.
    if (count > mostCellsAByte * code.length || (count === 0 && code.length > 0)) {
        throw new FrameError('the cells of a mesh frame are other ones than it announces');
    }
    const cells = new Int32Array(count * cellStride);
    if (count === 0) return cells;
    const { vertices, stay, kept, replaced } = context;
    const decoder = new RangeDecoder(code);
    const model = new CellModel(vertices, stay, sidesOf(context));
    let at = 0;
    for (const { begin, end } of replaced.all) {
        cells.set(kept.subarray(begin * cellStride, end * cellStride), at);
        for (let i = begin; i < end; ++i, at += cellStride) model.read(decoder, cells, at, true);
    }
    for (; at < cells.length; at += cellStride) model.read(decoder, cells, at, false);
    decoder.finish();
    return cells;
}

function sidesOf({ vertices, kept, replaced, near }: CellContext): OpenSides {
    const open = new OpenSides(vertices);
    const count = kept.length / cellStride;
    const newest = Math.max(0, count - newestKept);
    for (const i of near) if (i < newest) joinOutline(open, kept, i * cellStride);
    forEachGap(replaced, count, (begin, end) => {
        for (let i = Math.max(begin, newest); i < end; ++i) joinOutline(open, kept, i * cellStride);
    });
    return open;
}

function joinOutline(open: OpenSides, cells: Int32Array, at: number): void {
    for (let side = 0; side < 4; ++side) {
        const from = cells[at + side]!;
        const mid = cells[at + 4 + side]!;
        const to = cells[at + ((side + 1) & 3)]!;
        if (mid < 0) open.join(from, to);
        else {
            open.join(from, mid);
            open.join(mid, to);
        }
    }
}
