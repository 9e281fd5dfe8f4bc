// Whole records for unit tests: a test names what it is about, everything else is as in a small flow.
import type { Statistics } from '../protocol/generated/subscription.ts';
import { surfaceDefaults } from '../protocol/generated/surface.ts';
import type {
    DatasetDescription,
    FieldDescription,
    RakeRecord,
    ResultOf,
    SessionSnapshot,
    SurfaceRecord,
} from '../protocol/messages.ts';
import type { DisplayedSurface } from '../state/appState.ts';

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
    return { session, name, rakes: [], surfaces: [], slices: [], lines: [], bookmarks: [], annotations: [], clock };
}

export function datasetOf(change: Partial<DatasetDescription> = {}): DatasetDescription {
    return {
        ...{ dataset: 'flow', name: 'flow', reader: 'store', grid: 'uniform', points: 1000, cells: 729, steady: false },
        bounds: [0, 1, 0, 1, 0, 1],
        times: [0],
        fields: [],
        surfaceFields: [],
        ...{ velocity: 'U', why: 'the only vector', obstacle: false, bytesPerStep: 12_000, finestSpacing: 0.1, smooth: true },
        lattice: { origin: [0, 0, 0], step: 2 ** -16, bits: 16 },
        ...change,
    };
}

/** Returns a suggestion as the server makes one for a flow along x that is known from 0 to 10. */
export function suggestionOf(): ResultOf<'dataset.suggest'> {
    const points: ResultOf<'dataset.suggest'>['rake']['points'] = [
        [0.2, 0.5, 0.1],
        [0.2, 0.5, 0.9],
    ];
    return {
        rake: { kind: 'line', points, seeds: 32 },
        surfaces: [
            { kind: 'stream', from: 10, to: 14, separation: 0.1 },
            { kind: 'path', from: 6, to: 10, separation: 0.05 },
            { kind: 'streak', from: 6, to: 10, separation: 0.05 },
            { kind: 'time', from: 8, to: 10, separation: 0.05, sweep: [0, 0.2, 0] },
        ],
        why: 'The rake is ahead of a body.',
    };
}

export function fieldOf(name: string, change: Partial<FieldDescription> = {}): FieldDescription {
    return { name, components: 1, source: 'point', range: [0, 1], ...change };
}

export function rakeOf(rake: string, change: Partial<RakeRecord> = {}): RakeRecord {
    const points: RakeRecord['points'] = [
        [0, 0, 0],
        [0, 0, 1],
    ];
    return sampleRake({ rake, rev: 1, name: rake, points, ...change });
}

export function surfaceOf(surface: string, change: Partial<SurfaceRecord> = {}): SurfaceRecord {
    return sampleSurface({ surface, dataset: 'flow', ...change });
}

export function displayedOf(surface: string, change: Partial<DisplayedSurface> = {}): DisplayedSurface {
    return {
        ...{
            surface,
            epoch: 1,
            vertices: 4,
            cells: 1,
            triangles: 2,
            stateSum: 1,
            phase: 'final',
            time: 0,
            keys: 1,
            deltas: 0,
            withheld: [],
            curved: false,
        },
        ...change,
    };
}
