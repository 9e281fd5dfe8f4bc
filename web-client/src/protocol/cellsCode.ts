// The compact code of the cells: a cell that continues a strip between two columns of consecutive
// vertices costs no byte of its own but lengthens a run; protocol/README.md has the byte map.
// Twin: protocol/cells_code.hpp.
import { ByteReader, unzigzag } from './bytes.ts';
import { FrameError } from './frameError.ts';

/// A cell is eight ids: corners 0-3, then the mids of sides 0-3, noVertex where there is none. (In the
/// server's unsigned numbers that is 0xffffffff.)
export const cellStride = 8;
export const noVertex = -1;

// The header byte: bits 0-3 which mids exist, then:
const continues = 0x10; // corners 0 and 1 are corners 3 and 2 of the cell before
const leftPredicted = 0x20; // corner 3 follows its column
const rightPredicted = 0x40; // corner 2 follows its column
const runOfPlain = 0xf0; // all three, no mids; followed by how many

/// Ids along a column: usually consecutive, or one row's length apart.
class Column {
    stride = 1;
    private lastDifference = 1;

    /// One odd step, as round an inserted vertex, must not spoil the stride for the steps after it.
    saw(from: number, to: number): void {
        const difference = (to - from) | 0;
        if (difference === this.lastDifference)
            this.stride = difference;
        this.lastDifference = difference;
    }
}

class CellsReader {
    private readonly left = new Column();
    private readonly right = new Column();
    private nextCorner0 = 0;
    private nextCorner1 = 0;
    private stripCorner0 = 0;
    private stripCorner1 = 0;
    private crossMid = 0;
    private readonly code: ByteReader;
    private readonly vertices: number;

    constructor(code: ByteReader, vertices: number) {
        this.code = code;
        this.vertices = vertices;
    }

    cell(header: number, cells: Int32Array, at: number): void {
        if ((header & continues) !== 0) {
            cells[at] = this.checked(this.nextCorner0);
            cells[at + 1] = this.checked(this.nextCorner1);
        } else {
            const width = this.stripCorner1 - this.stripCorner0;
            this.stripCorner0 = cells[at] = this.id(this.stripCorner1);
            this.stripCorner1 = cells[at + 1] = this.id(this.stripCorner0 + width);
        }
        this.nextCorner0 = cells[at + 3] = this.column(this.left, cells, at, 0, 7, header & 8, header & leftPredicted);
        this.nextCorner1 = cells[at + 2] = this.column(this.right, cells, at, 1, 5, header & 2, header & rightPredicted);
        cells[at + 4] = (header & 1) !== 0 ? this.cross() : noVertex;
        cells[at + 6] = (header & 4) !== 0 ? this.cross() : noVertex;
    }

    private checked(id: number): number {
        if (id >= this.vertices)
            throw new FrameError('a cell of a mesh frame uses a vertex that was not sent');
        return id;
    }

    private id(predicted: number): number {
        return this.checked((predicted + unzigzag(this.code.varint())) >>> 0);
    }

    private cross(): number {
        this.crossMid = this.id(this.crossMid);
        return this.crossMid;
    }

    /// Walks one side of the cell from its young corner over the mid, if any, to its old corner.
    private column(
        column: Column,
        cells: Int32Array,
        at: number,
        young: number,
        mid: number,
        hasMid: number,
        isPredicted: number,
    ): number {
        let from = cells[at + young]!;
        cells[at + mid] = noVertex;
        if (hasMid !== 0) {
            const to = this.id(from + column.stride);
            column.saw(from, to);
            cells[at + mid] = from = to;
        }
        const expected = from + column.stride;
        const to = isPredicted !== 0 ? this.checked(expected >>> 0) : this.id(expected);
        column.saw(from, to);
        return to;
    }
}

/// Fills `cells` with cells whose vertices are below `vertices`. Throws FrameError; `cells` is then unspecified.
export function decodeCells(bytes: Uint8Array, vertices: number, cells: Int32Array): void {
    const code = new ByteReader(bytes);
    const reader = new CellsReader(code, vertices);
    let at = 0;
    let left = cells.length / cellStride;
    while (left > 0) {
        const header = code.byte();
        const isRun = (header & 0x80) !== 0;
        const length = isRun ? code.varint() : 1;
        if (length === 0 || length > left || (isRun && header !== runOfPlain))
            throw new FrameError('the cells of a mesh frame hold an impossible run');
        for (let i = 0; i < length; i += 1, at += cellStride)
            reader.cell(header, cells, at);
        left -= length;
    }
    if (!code.atEnd)
        throw new FrameError('the cells of a mesh frame go on after the last');
}
