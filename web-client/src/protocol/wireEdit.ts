// The topology of an update: which vertices and cells go, come and change, as runs and a cells code.
// protocol/wire/README.md, Topology. Twin: protocol/wire/wire_edit.hpp.
import { ByteReader } from './bytes.ts';
import { cellStride } from './cell.ts';
import { decodeCells } from './cellsCode.ts';
import { FrameError } from './frameError.ts';
import { type EditedRuns, keepCells } from './keptCells.ts';
import type { Run, Runs } from './runs.ts';
import type { WireMesh } from './wireMesh.ts';

export interface TopologyEdit extends EditedRuns {
    addedVertices: number;
    movedVertices: Runs; // of those that stay
    addedCells: number;
    cellsCode: Uint8Array; // of the replaced, then of the added ones
}

export interface MeshSize {
    vertices: number;
    cells: number;
}

function readRuns(reader: ByteReader, over: number): Runs {
    const all: Run[] = [];
    let at = 0;
    let count = 0;
    for (let left = reader.varint(); left > 0; --left) {
        const begin = at + reader.varint();
        const end = begin + reader.varint();
        if (begin === end || end > over) {
            throw new FrameError('the topology of a mesh update names vertices or cells that are not there');
        }
        all.push({ begin, end });
        count += end - begin;
        at = end;
    }
    return { all, count };
}

/** Throws FrameError unless the edit leads from `before` to `after`. Allocates O(after) at most. */
export function readEdit(bytes: Uint8Array, before: MeshSize, after: MeshSize): TopologyEdit {
    const reader = new ByteReader(bytes);
    const removedVertices = readRuns(reader, before.vertices);
    const addedVertices = reader.varint();
    const verticesStay = before.vertices - removedVertices.count;
    const movedVertices = readRuns(reader, verticesStay);
    const removedCells = readRuns(reader, before.cells);
    const cellsStay = before.cells - removedCells.count;
    const replacedCells = readRuns(reader, cellsStay);
    const addedCells = reader.varint();
    if (verticesStay + addedVertices !== after.vertices || cellsStay + addedCells !== after.cells) {
        throw new FrameError('a mesh update leads to other numbers of vertices and cells than it announces');
    }
    const cellsCode = reader.rest();
    return { removedVertices, addedVertices, movedVertices, removedCells, replacedCells, addedCells, cellsCode };
}

/**
 * Gives the cells that are new: the replaced, then the added ones. Throws FrameError when they do not fit; the mesh is then unusable.
 * Cost: O(state) where cells go, come or change.
 */
export function applyEdit(mesh: WireMesh, edit: TopologyEdit): Int32Array {
    const { removedVertices, addedVertices, removedCells, replacedCells, addedCells } = edit;
    const verticesBefore = mesh.vertices;
    const stay = verticesBefore - removedVertices.count;
    mesh.beginVertices(removedVertices, stay + addedVertices);
    if (removedVertices.count + addedVertices + removedCells.count + replacedCells.count + addedCells === 0) {
        if (edit.cellsCode.length > 0) throw new FrameError('a mesh update has cells that it does not announce');
        return new Int32Array(0);
    }
    const kept = keepCells(mesh, edit, verticesBefore);
    const context = { vertices: mesh.vertices, stay, kept: mesh.cells, replaced: replacedCells, near: kept.near };
    const cells = decodeCells(edit.cellsCode, replacedCells.count + addedCells, context);
    const keptCells = mesh.cellCount;
    let next = 0;
    for (const { begin, end } of replacedCells.all) {
        const length = (end - begin) * cellStride;
        mesh.cells.set(cells.subarray(next, next + length), begin * cellStride);
        next += length;
    }
    mesh.appendCells(cells.subarray(next));
    const onlyAdded = removedVertices.count + removedCells.count + replacedCells.count === 0;
    mesh.cellsChanged(kept, replacedCells, keptCells, onlyAdded);
    return cells;
}
