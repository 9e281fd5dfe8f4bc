// The cells that an update leaves, in the numbers vertices have after it: what both ends know before the new cells are there.
// Twin: protocol/wire/kept_cells.hpp; unlike there, the state's own cells are changed in place.
import { cellStride, noVertex } from './cell.ts';
import { FrameError } from './frameError.ts';
import { forEachGap, numbersAfter, type Runs } from './runs.ts';
import type { WireMesh } from './wireMesh.ts';

export interface KeptCells {
    now: Int32Array | undefined; // the new number of each old vertex; none where all stay
    touched: Uint8Array; // of each vertex that stays: not all its cells stay as they are
    near: number[]; // cells that are not replaced and have a touched vertex, ascending
}

/** Marks the vertices of cells first .. last - 1; ids that are gone are none. */
function touch(touched: Uint8Array, cells: Int32Array, first: number, last: number): void {
    for (let at = first * cellStride; at < last * cellStride; ++at) if (cells[at]! >= 0) touched[cells[at]!] = 1;
}

/**
 * Removes cells from the mesh and renumbers what stays. Vertices of removed and replaced cells, and of cells that lose a
 * mid, are touched. Throws FrameError when a cell that stays and is not replaced has lost a corner.
 */
export function keepCells(mesh: WireMesh, edit: EditedRuns, verticesBefore: number): KeptCells {
    const { removedVertices, removedCells, replacedCells } = edit;
    const now = removedVertices.count > 0 ? numbersAfter(removedVertices, verticesBefore) : undefined;
    const touched = new Uint8Array(verticesBefore - removedVertices.count);
    const before = mesh.cells;
    for (const { begin, end } of removedCells.all) {
        if (now !== undefined) renumber(before, begin, end, now, touched);
        touch(touched, before, begin, end);
    }
    mesh.removeCells(removedCells);
    const kept = mesh.cells;
    const whole = now === undefined || renumber(kept, 0, mesh.cellCount, now, touched);
    for (const { begin, end } of replacedCells.all) touch(touched, kept, begin, end);
    if (!whole) {
        forEachGap(replacedCells, mesh.cellCount, (begin, end) => {
            checkCorners(kept, begin, end);
        });
    }
    return { now, touched, near: cellsNear(kept, replacedCells, touched) };
}

export interface EditedRuns {
    removedVertices: Runs; // of the old ones
    removedCells: Runs; // of the old ones
    replacedCells: Runs; // of those that stay
}

function cellsNear(cells: Int32Array, replaced: Runs, touched: Uint8Array): number[] {
    const near: number[] = [];
    forEachGap(replaced, cells.length / cellStride, (begin, end) => {
        for (let i = begin; i < end; ++i) if (isTouched(cells, i * cellStride, touched)) near.push(i);
    });
    return near;
}

function isTouched(cells: Int32Array, at: number, touched: Uint8Array): boolean {
    if (touched[cells[at]!]! | touched[cells[at + 1]!]! | touched[cells[at + 2]!]! | touched[cells[at + 3]!]!) return true;
    if ((cells[at + 4]! & cells[at + 5]! & cells[at + 6]! & cells[at + 7]!) === noVertex) return false;
    for (let mid = at + 4; mid < at + cellStride; ++mid) if (cells[mid]! >= 0 && touched[cells[mid]!] !== 0) return true;
    return false;
}

/** Whether cells first .. last - 1 keep all their corners. Of one that loses a vertex the others are touched. */
function renumber(cells: Int32Array, first: number, last: number, now: Int32Array, touched: Uint8Array): boolean {
    let signs = 0;
    for (let cell = first * cellStride; cell < last * cellStride; cell += cellStride) {
        const c0 = (cells[cell] = now[cells[cell]!]!);
        const c1 = (cells[cell + 1] = now[cells[cell + 1]!]!);
        const c2 = (cells[cell + 2] = now[cells[cell + 2]!]!);
        const c3 = (cells[cell + 3] = now[cells[cell + 3]!]!);
        let lost = c0 | c1 | c2 | c3;
        signs |= lost;
        // Few cells have mids: noVertex has all bits set, no id has.
        if ((cells[cell + 4]! & cells[cell + 5]! & cells[cell + 6]! & cells[cell + 7]!) !== noVertex) {
            for (let mid = cell + 4; mid < cell + cellStride; ++mid) if (cells[mid]! >= 0) lost |= cells[mid] = now[cells[mid]!]!;
        }
        if (lost < 0) touch(touched, cells, cell / cellStride, cell / cellStride + 1);
    }
    return signs >= 0;
}

function checkCorners(cells: Int32Array, first: number, last: number): void {
    for (let at = first * cellStride; at < last * cellStride; at += cellStride) {
        if (cells[at]! < 0 || cells[at + 1]! < 0 || cells[at + 2]! < 0 || cells[at + 3]! < 0) {
            throw new FrameError('a cell that stays in a mesh update has lost a corner');
        }
    }
}
