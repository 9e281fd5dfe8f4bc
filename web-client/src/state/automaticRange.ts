// Says what colours stand for where no user has said it, by what they show.
import type { SurfaceRecord, ValueRange } from '../protocol/messages.ts';
import type { SurfaceLook } from './surfaceLook.ts';

/** Is the range of one field, on some surfaces. */
export interface AutomaticRange extends Omit<ValueRange, 'attribute'> {
    surfaces: number;
}

/** By meaningOf(). */
export type AutomaticRanges = ReadonlyMap<string, AutomaticRange>;

/** Surfaces whose colours mean the same have the same name here. Across a patch age is not what it is
 *  elsewhere. */
export function meaningOf({ colourBy }: SurfaceLook, { kind }: Pick<SurfaceRecord, 'kind'>): string {
    return colourBy === 'age' && kind === 'time' ? 'patch' : colourBy;
}
