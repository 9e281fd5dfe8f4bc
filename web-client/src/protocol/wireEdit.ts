// The topology of an update: which vertices and cells go, come and change, as runs and a cells code.
// protocol/README.md, Topology. Twin: protocol/wire_edit.hpp.
import { ByteReader } from './bytes.ts';
import { cellStride, decodeCells, noVertex } from './cellsCode.ts';
import { FrameError } from './frameError.ts';
import type { WireMesh } from './wireMesh.ts';

/// Things begin .. end - 1 of a list.
export interface Run {
    begin: number;
    end: number;
}

/// Disjoint and ascending; `count` things in all.
export interface Runs {
    all: readonly Run[];
    count: number;
}

export interface TopologyEdit {
    removedVertices: Runs; // of the old ones
    addedVertices: number;
    movedVertices: Runs; // of those that stay
    removedCells: Runs; // of the old ones
    replacedCells: Runs; // of those that stay
    cells: Int32Array; // the replaced, then the added ones
}

export interface MeshSize {
    vertices: number;
    cells: number;
}

function readRuns(reader: ByteReader, over: number): Runs {
    const all: Run[] = [];
    let at = 0;
    let count = 0;
    for (let left = reader.varint(); left > 0; left -= 1) {
        const begin = at + reader.varint();
        const end = begin + reader.varint();
        if (begin === end || end > over)
            throw new FrameError('the topology of a mesh update names vertices or cells that are not there');
        all.push({ begin, end });
        count += end - begin;
        at = end;
    }
    return { all, count };
}

/// Throws FrameError unless the edit leads from `before` to `after`. Allocates O(after) at most.
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
    if (verticesStay + addedVertices !== after.vertices || cellsStay + addedCells !== after.cells)
        throw new FrameError('a mesh update leads to other numbers of vertices and cells than it announces');
    const cells = new Int32Array((replacedCells.count + addedCells) * cellStride);
    decodeCells(reader.rest(), after.vertices, cells);
    return { removedVertices, addedVertices, movedVertices, removedCells, replacedCells, cells };
}

/// Throws FrameError when a cell that stays has lost a corner; the mesh is then unusable.
/// Cost: O(what is added), and O(state) where cells go or change.
export function applyEdit(mesh: WireMesh, edit: TopologyEdit): void {
    const { removedVertices, addedVertices, removedCells, replacedCells, cells } = edit;
    const verticesBefore = mesh.vertices;
    const cellsBefore = mesh.cellCount;
    mesh.beginVertices(removedVertices, verticesBefore - removedVertices.count + addedVertices);
    mesh.removeCells(removedCells);
    const complete = removedVertices.count === 0 || renumber(mesh.cells, removedVertices, verticesBefore);
    let next = 0;
    for (const { begin, end } of replacedCells.all) {
        const length = (end - begin) * cellStride;
        mesh.cells.set(cells.subarray(next, next + length), begin * cellStride);
        next += length;
    }
    if (!complete)
        checkCorners(mesh.cells);
    mesh.appendCells(cells.subarray(next));
    const onlyAdded = removedVertices.count + removedCells.count + replacedCells.count === 0;
    if (!onlyAdded)
        mesh.cellsChanged(0, 0);
    else if (cells.length > 0 || addedVertices > 0)
        mesh.cellsChanged(verticesBefore, cellsBefore);
}

/// A cell's removed mid is freed; a removed corner becomes noVertex as well, which only a replacement cures: then false.
function renumber(cells: Int32Array, removed: Runs, vertices: number): boolean {
    const now = new Int32Array(vertices);
    let at = 0;
    let next = 0;
    for (const { begin, end } of removed.all) {
        while (at < begin)
            now[at++] = next++;
        now.fill(noVertex, begin, end);
        at = end;
    }
    while (at < vertices)
        now[at++] = next++;
    let signs = 0;
    for (let cell = 0; cell < cells.length; cell += cellStride) {
        const c0 = (cells[cell] = now[cells[cell]!]!);
        const c1 = (cells[cell + 1] = now[cells[cell + 1]!]!);
        const c2 = (cells[cell + 2] = now[cells[cell + 2]!]!);
        const c3 = (cells[cell + 3] = now[cells[cell + 3]!]!);
        signs |= c0 | c1 | c2 | c3;
        // Few cells have mids: noVertex has all bits set, no id has.
        if ((cells[cell + 4]! & cells[cell + 5]! & cells[cell + 6]! & cells[cell + 7]!) === noVertex)
            continue;
        for (let mid = cell + 4; mid < cell + cellStride; mid += 1)
            if (cells[mid]! >= 0)
                cells[mid] = now[cells[mid]!]!;
    }
    return signs >= 0;
}

function checkCorners(cells: Int32Array): void {
    for (let at = 0; at < cells.length; at += cellStride)
        if (cells[at]! < 0 || cells[at + 1]! < 0 || cells[at + 2]! < 0 || cells[at + 3]! < 0)
            throw new FrameError('a cell that stays in a mesh update has lost a corner');
}
