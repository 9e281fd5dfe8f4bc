// The state of the picture in words: what is coarse or old must not pass for the result.
import type { SurfacePhase } from '../../state/appState.ts';

export const phaseWords: Record<SurfacePhase, string> = {
    waiting: 'Waiting for the server …',
    ended: 'No longer connected',
    gone: 'Not in a session',
    hidden: 'Hidden',
    none: 'Computing the first surface …',
    updating: 'Updating …',
    coarse: 'Coarse, refining …',
    live: 'Playing',
    final: 'Final',
    coarsened: 'Coarser than asked for',
    empty: 'Nothing to see',
    stopped: 'Stopped before it was final',
    error: 'Not computed',
};

export function countWords(count: number): string {
    return count.toLocaleString('en').replaceAll(',', '\u202f');
}
