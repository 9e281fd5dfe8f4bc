// Which parts of the boundary are seen, by the names that the files give them: walls of the body, unless they are hidden; what lies in a
// side of the domain, and inlets and outlets, only where they are asked for.
import type { DatasetDescription } from '../protocol/messages.ts';
import type { BodyLook } from './bodyLook.ts';

export type Patch = NonNullable<DatasetDescription['patches']>[number];

type Described = Pick<DatasetDescription, 'obstacle' | 'patches'> | null;

/** As it is kept: patches of several kinds may share a name. */
export function patchId({ name, kind }: Patch): string {
    return kind === 'wall' ? name : `${name} (${kind})`;
}

export function showsPatch({ patches }: Pick<BodyLook, 'patches'>, patch: Patch): boolean {
    return (patch.kind === 'wall') !== patches.includes(patchId(patch));
}

/** There is something that the body's settings can show. */
export function hasBoundary(dataset: Described): boolean {
    return dataset !== null && (dataset.obstacle || (dataset.patches ?? []).length > 0);
}

/** What is no part of the body is fetched only then. */
export function showsBeyondBody(dataset: Described, look: Pick<BodyLook, 'patches'>): boolean {
    return (dataset?.patches ?? []).some((patch) => patch.kind !== 'wall' && showsPatch(look, patch));
}

/** From one cell to before another. */
export type CellSpan = readonly [number, number];

/** Where each patch is among the cells. @param all  what is no part of the body is there, too */
export function patchSpans(dataset: Described, all: boolean): Map<Patch, CellSpan> {
    const spans = new Map<Patch, CellSpan>();
    let at = 0;
    for (const patch of (dataset?.patches ?? []).filter(({ kind }) => all || kind === 'wall')) {
        spans.set(patch, [at, at + patch.triangles]);
        at += patch.triangles;
    }
    return spans;
}

/**
 * Cells of the body that are not seen. What closes it at the sides of the domain comes last, and goes with any of its walls.
 * @param all  what is no part of the body is in the picture, too
 */
export function hiddenCells(dataset: Described, look: Pick<BodyLook, 'patches'>, all: boolean): CellSpan[] {
    const hidden: CellSpan[] = [];
    let at = 0;
    let closed = true;
    for (const [patch, span] of patchSpans(dataset, all)) {
        if (!showsPatch(look, patch)) hidden.push(span);
        closed &&= patch.kind !== 'wall' || showsPatch(look, patch);
        at = span[1];
    }
    return closed ? hidden : [...hidden, [at, Infinity]];
}
