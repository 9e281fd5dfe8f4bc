// Whole records for unit tests: a test names what it is about, everything else is as in a small flow.
import type { DatasetDescription, FieldDescription, RakeRecord, ResultOf, SurfaceRecord } from '../protocol/messages.ts';
import { sampleRake, sampleSurface } from '../protocol/testing/sampleRecords.ts';
import type { DisplayedSurface } from '../state/appState.ts';

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
