// A page whose server answers when the test lets it, for tests of edits.
import { Edits } from '../session/edits/edits.ts';
import { AppState } from '../state/appState.ts';
import { LatencyLog } from '../state/latency.ts';
import type { RakeRecord, Vec3 } from '../protocol/messages.ts';
import { answering } from './answering.ts';
import { settled } from './fakeClock.ts';
import { rakeOf, surfaceOf } from './records.ts';

export type Call = [method: string, params: Record<string, unknown>];

export class Bench {
    state = new AppState();
    calls: Call[] = [];
    waiting: { resolve: (result: unknown) => void; reject: (error: Error) => void }[] = [];
    held = false;
    edits: Edits;

    constructor() {
        const worker = answering((...call) => {
            this.calls.push([call[0], call[1]]);
            return new Promise((resolve, reject) => this.waiting.push({ resolve, reject }));
        });
        const options = { state: this.state, worker, latency: new LatencyLog(), requestFrame: () => undefined };
        this.edits = new Edits({ ...options, dragging: () => this.held });
        this.state.capabilities.value = ['lease'];
        this.records([rakeOf('r1'), rakeOf('r2')], [surfaceOf('s1', { rake: 'r1' }), surfaceOf('s2', { rake: 'r2' })]);
    }

    records(rakes: RakeRecord[], surfaces = [...this.state.surfaces.value.values()]): void {
        this.state.rakes.value = new Map(rakes.map((each) => [each.rake, each]));
        this.state.surfaces.value = new Map(surfaces.map((each) => [each.surface, each]));
        this.edits.recordsChanged();
    }

    drag(x: number, dragging = true): void {
        this.held = dragging;
        const shape = {
            kind: 'line',
            points: [
                [x, 0, 0],
                [0, 0, 1],
            ] as Vec3[],
        } as const;
        this.edits.moveRake({ shape, dragging, movedAt: 1000 + x });
    }

    async answer(rev = 2, rest: object = {}): Promise<void> {
        this.waiting.shift()?.resolve({ rake: 'r1', rev, clipped: false, points: [], surfaces: [], skipped: [], ...rest });
        for (let i = 0; i < 6; ++i) await settled();
    }

    async refuse(error: Error): Promise<void> {
        this.waiting.shift()?.reject(error);
        for (let i = 0; i < 6; ++i) await settled();
    }

    /** Returns what the problems that are told are about. */
    get told(): string[] {
        return [...this.state.problems.all.value.keys()];
    }

    get sent(): unknown[] {
        return this.calls.map(([, params]) => (params['points'] as Vec3[] | undefined)?.[0]?.[0] ?? params);
    }
}
