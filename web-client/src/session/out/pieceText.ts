// Names what is left of a surface in the picture, as the server names it for files: `?lines=` of a download.
import type { DatasetDescription, SurfaceRecord } from '../../protocol/messages.ts';
import type { SurfaceLook } from '../../state/surfaceLook.ts';
import { pieceLengths } from '../picture/surfaceStyleOf.ts';

/** Returns what the particles of one seed form; empty for surfaces of which each point is a particle of its
 *  own. */
export function seedLinesOf(kind: SurfaceRecord['kind']): '' | 'streamlines' | 'pathlines' | 'streaklines' {
    return ({ stream: 'streamlines', path: 'pathlines', streak: 'streaklines', time: '', level: '' } as const)[kind];
}

/** Null: all of the surface. */
export function pieceText(
    look: Pick<SurfaceLook, 'points' | 'pieces' | 'pieceEvery' | 'pieceWidth'>,
    { kind }: Pick<SurfaceRecord, 'kind'>,
    bounds: DatasetDescription['bounds'] | undefined,
): string | null {
    if (look.points) return 'points';
    const { pieces } = look;
    const along = seedLinesOf(kind);
    if (pieces === 'whole' || (along === '' && pieces !== 'arrows')) return null;
    const names = {
        timelines: 'timelines',
        seedlines: along,
        timeribbons: 'timeribbons',
        seedribbons: along.replace('lines', 'ribbons'),
        arrows: 'arrows',
    };
    const { pieceEvery, pieceWidth } = pieceLengths(look, bounds);
    const width = pieces.endsWith('lines') ? '' : `,width=${pieceWidth}`;
    return `${names[pieces]}:every=${pieceEvery}${width}`;
}
