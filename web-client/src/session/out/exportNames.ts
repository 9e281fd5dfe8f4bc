// What files that the page saves are called, and what the server is asked for by name: the time they are of, whether they show something
// coarse, and the pieces of a surface (`?lines=` of a download).
import type { DatasetDescription, SurfaceRecord } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { pieceLengths } from '../picture/surfaceStyleOf.ts';
import { timeWords } from '../picture/writtenNumbers.ts';
import { clampTo } from '../time/timeSteps.ts';

/** Returns the time of the selected surface's mesh, which the server writes as it is at the time of its
 *  clock; empty without a surface. */
export function meshTimeWords(state: AppState, view: Pick<ViewState, 'units'>): string {
    const record = state.surface.value;
    if (record === undefined) return '';
    const words = (time: number): string => `t = ${timeWords(state, view, time)}`;
    if (record.kind === 'stream') return `Of the flow as it is at ${words(record.from)}.`;
    const clock = state.clock.value;
    const time = clock?.time ?? null;
    if (clock?.playing === true) return 'As it is at the time of the clock when you press. The file says which.';
    if (time === null) return `As it is at its end, ${words(record.to)}.`;
    const span = [Math.min(record.from, record.to), Math.max(record.from, record.to)] as const;
    return `As it is at ${words(clampTo(span, time))}, the time of the clock.`;
}

/** Returns a text like "t12.5". */
export function timeInName(time: number): string {
    return `t${Number(time.toPrecision(10))}`;
}

export const coarseCaption = 'Coarse, not the final surface';

/** A surface that is in the picture has not become final. */
export function pictureIsCoarse({ displayed, hiddenSurfaces }: Pick<AppState, 'displayed' | 'hiddenSurfaces'>): boolean {
    const hidden = hiddenSurfaces.value;
    return [...displayed.value.values()].some(
        ({ surface, phase }) => !hidden.has(surface) && (phase === 'coarse' || phase === 'refined'),
    );
}

/** Returns whether there is something of the selected surface that is not final. */
export function meshIsCoarse({ displayed, activeSurface }: Pick<AppState, 'displayed' | 'activeSurface'>): boolean {
    const phase = displayed.value.get(activeSurface.value ?? '')?.phase;
    return phase === 'coarse' || phase === 'refined';
}

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
