// Whole records for unit tests: a test names what it is about, everything else is as in a small flow.
import type { DatasetDescription, FieldDescription, RakeRecord, SurfaceRecord } from '../protocol/messages.ts';
import type { DisplayedSurface } from '../state/appState.ts';

export function datasetOf(change: Partial<DatasetDescription> = {}): DatasetDescription {
    return {
        ...{ dataset: 'flow', name: 'flow', reader: 'store', grid: 'uniform', points: 1000, cells: 729, steady: false },
        bounds: [0, 1, 0, 1, 0, 1],
        times: [0],
        fields: [],
        ...{ velocity: 'U', why: 'the only vector', obstacle: false, bytesPerStep: 12_000, finestSpacing: 0.1 },
        lattice: { origin: [0, 0, 0], step: 2 ** -16, bits: 16 },
        ...change,
    };
}

export function fieldOf(name: string, change: Partial<FieldDescription> = {}): FieldDescription {
    return { name, components: 1, source: 'point', range: [0, 1], ...change };
}

export function rakeOf(rake: string, change: Partial<RakeRecord> = {}): RakeRecord {
    return {
        ...{ rake, rev: 1, kind: 'line', seeds: 8, name: rake, clipped: false, dragging: false },
        points: [
            [0, 0, 0],
            [0, 0, 1],
        ],
        ...change,
    };
}

export function surfaceOf(surface: string, change: Partial<SurfaceRecord> = {}): SurfaceRecord {
    return {
        ...{ surface, rev: 1, epoch: 1, rake: 'r1', kind: 'stream', dataset: 'flow', from: 0, to: 4, direction: 'forward' },
        ...{ separation: 0.2, accuracy: 'balanced', merge: 0.35, angle: 20, maxQuads: 1_000_000, fields: [] },
        ...change,
    };
}

export function displayedOf(surface: string, change: Partial<DisplayedSurface> = {}): DisplayedSurface {
    return {
        ...{ surface, epoch: 1, vertices: 4, cells: 1, triangles: 2, stateCrc: 1, phase: 'final', time: 0, keys: 1, deltas: 0 },
        ...change,
    };
}
