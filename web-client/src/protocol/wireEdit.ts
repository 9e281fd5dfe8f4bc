// The topology of an update: which vertices and cells go, come and change. protocol/wire/FORMAT.md, Topology.
// Twin: protocol/wire/wire_edit.hpp.
import { FrameError, type Numbers, numbersAfter, readRuns, type Runs, unzigzag } from './bytes.ts';
import { cellStride, noVertex, type WireMesh } from './wireMesh.ts';
import { type FrameHeader, maxBlockVertices } from './meshFrame.ts';

export interface TopologyEdit {
    removedVertices: Runs; // of the old ones
    addedVertices: number;
    movedVertices: Runs; // of those that stay
    removedCells: Runs; // of the old ones
    replacedCells: Runs; // of those that stay
    cells: Int32Array; // those that are new: the replaced, then the added ones
}

/**
 * Reads the topology of an update that leads to a mesh of the size that its header says, and makes the mesh
 * so. Throws FrameError; the mesh is then unusable. Cost: O(state) where cells go, come or change. Allocates
 * O(numbers + state) at most.
 */
export function applyEdit(mesh: WireMesh, numbers: Numbers, after: FrameHeader): TopologyEdit {
    const verticesBefore = mesh.vertices;
    const removedVertices = readRuns(numbers, verticesBefore);
    const addedVertices = numbers.next();
    const stay = verticesBefore - removedVertices.count;
    const movedVertices = readRuns(numbers, stay);
    const removedCells = readRuns(numbers, mesh.cellCount);
    const cellsStay = mesh.cellCount - removedCells.count;
    const replacedCells = readRuns(numbers, cellsStay);
    const addedCells = numbers.next();
    if (stay + addedVertices !== after.vertices || cellsStay + addedCells !== after.cells) {
        throw new FrameError('a mesh update leads to other numbers of vertices and cells than it announces');
    }
    if (movedVertices.count + addedVertices > maxBlockVertices * after.frameCount) {
        throw new FrameError('a mesh update announces more vertices than its frames may hold');
    }
    mesh.beginVertices(removedVertices, after.vertices);
    mesh.removeCells(removedCells);
    if (removedVertices.count > 0) renumber(mesh.cells, numbersAfter(removedVertices, verticesBefore));
    const cells = readCells(numbers, replacedOf(mesh.cells, replacedCells), addedCells, stay, after.vertices);
    const edit = { removedVertices, addedVertices, movedVertices, removedCells, replacedCells, cells };
    if (removedVertices.count + addedVertices + removedCells.count + cells.length === 0) return edit;
    let next = 0;
    for (const { begin, end } of replacedCells.all) {
        const length = (end - begin) * cellStride;
        mesh.cells.set(cells.subarray(next, next + length), begin * cellStride);
        next += length;
    }
    if (removedVertices.count > 0) checkCorners(mesh.cells);
    mesh.appendCells(cells.subarray(next));
    mesh.cellsChanged(removedVertices.count + removedCells.count + replacedCells.count === 0 ? cellsStay : 0);
    return edit;
}

function replacedOf(cells: Int32Array, replaced: Runs): Int32Array {
    const old = new Int32Array(replaced.count * cellStride);
    let at = 0;
    for (const { begin, end } of replaced.all) {
        old.set(cells.subarray(begin * cellStride, end * cellStride), at);
        at += (end - begin) * cellStride;
    }
    return old;
}

/** In place; a vertex that has gone is none. */
function renumber(cells: Int32Array, now: Int32Array): void {
    for (let at = 0; at < cells.length; ++at) if (cells[at]! >= 0) cells[at] = now[cells[at]!]!;
}

function checkCorners(cells: Int32Array): void {
    for (let at = 0; at < cells.length; at += cellStride) {
        if ((cells[at]! | cells[at + 1]! | cells[at + 2]! | cells[at + 3]!) < 0) {
            throw new FrameError('a cell that stays in a mesh update has lost a corner');
        }
    }
}

/** Gives for each slot the one of the same cell that a new vertex is near; corners 0 and 1 have that of the
 *  cell before. */
const near = [0, 1, 1, 0, 0, 1, 2, 3];

/** Slot by slot, each vertex as the difference from the one it replaces, or else from one that it is near. */
function readCells(numbers: Numbers, old: Int32Array, added: number, stay: number, vertices: number): Int32Array {
    const count = old.length / cellStride + added;
    const mids = numbers.take(count);
    const cells = new Int32Array(count * cellStride).fill(noVertex);
    for (let slot = 0; slot < cellStride; ++slot) {
        let before = stay;
        for (let i = 0, cell = 0; i < count; ++i, cell += cellStride) {
            if (slot >= 4 && ((mids[i]! >> (slot - 4)) & 1) === 0) continue;
            const replaced = cell < old.length ? old[cell + slot]! : noVertex;
            const base = replaced >= 0 ? replaced : slot < 2 ? before : cells[cell + near[slot]!]!;
            const vertex = (base + unzigzag(numbers.next())) | 0;
            if (vertex < 0 || vertex >= vertices) throw new FrameError('a cell of a mesh update has a vertex that is not there');
            cells[cell + slot] = vertex;
            if (replaced < 0) before = vertex;
        }
    }
    return cells;
}
