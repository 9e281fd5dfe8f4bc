// Whole records for tests, of which each says only what it is about.
import type { Statistics } from '../generated/subscription.ts';
import { surfaceDefaults } from '../generated/surface.ts';
import type { RakeRecord, SessionSnapshot, SurfaceRecord } from '../records.ts';

export function sampleRake(rest: Partial<RakeRecord> = {}): RakeRecord {
    const points: RakeRecord['points'] = [
        [0, 0, 0],
        [1, 0, 0],
    ];
    const about = { name: 'inlet', colour: '#336699', author: 'Ada', clipped: false, dragging: false };
    return { rake: 'r1', rev: 3, kind: 'line', points, seeds: 8, ...about, ...rest };
}

export function sampleSurface(rest: Partial<SurfaceRecord> = {}): SurfaceRecord {
    const names = { surface: 's1', rake: 'r1', dataset: 'd', rev: 1, epoch: 1 };
    return { ...surfaceDefaults, ...names, kind: 'stream', from: 0, to: 4, direction: 'forward', separation: 0.2, ...rest };
}

export function sampleStatistics(rest: Partial<Statistics> = {}): Statistics {
    const terminated = { domain: 0, time: 4, obstacle: 0, stagnation: 0, budget: 0 };
    const seconds = { load: 0, advect: 0.2, refine: 0.1, other: 0, total: 0.3 };
    const counts = { quads: 3, vertices: 8, steps: 3, vertexSteps: 24, approximated: 0, peakBytes: 1000, stateSum: 1 };
    const limits = { maxEdge: 0.2, separation: 0.2, requestedSeparation: 0.2, coarsened: false };
    const about = { surface: 's1', epoch: 1, complete: true, kind: 'stream' } as const;
    return { ...about, ...counts, ...limits, terminated, seconds, ...rest };
}

export function emptySnapshot(session: string, name = ''): SessionSnapshot {
    const clock = { time: null, playing: false, speed: 1, loop: false, from: null, to: null };
    return { session, name, rakes: [], surfaces: [], bookmarks: [], annotations: [], clock };
}
