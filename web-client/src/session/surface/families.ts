// Makes a family of stream surfaces from the page: a scalar that the flow carries, from the chosen rake or
// from the inflow, as a field of the dataset. The chosen isosurface then shows a level set of it.
import type { FamilyMakeParams } from '../../protocol/generated/family.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { LongCall } from '../base/longCall.ts';
import type { Edits } from '../edits/edits.ts';
import type { ClockControl } from '../time/clockControl.ts';

/** A rake, or which coordinate of the inflow. */
export type FamilyChoice = { rake: string } | 'x' | 'y' | 'z';

export interface FamiliesOptions {
    state: Pick<AppState, 'activeSurface' | 'dataset' | 'rakes'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: Pick<Edits, 'changeSurface'>;
    clock: Pick<ClockControl, 'set'>;
    /** Returns the time of the picture. */
    time: () => number;
}

export class Families extends LongCall {
    private readonly options: FamiliesOptions;

    constructor(options: FamiliesOptions) {
        super('family');
        this.options = options;
    }

    async make(choice: FamilyChoice): Promise<void> {
        const { state, worker, edits, clock } = this.options;
        const wanted = this.wanted(choice);
        if (wanted === null) return;
        const isosurface = state.activeSurface.value;
        await this.run(async (workDoneToken, signal) => {
            const { name, steps } = await worker.call('family.make', { ...wanted, workDoneToken }, signal);
            const { time, range, nodes, reached } = steps[0]!;
            if (state.dataset.value!.times.length > 1) clock.set(time);
            // The level of a curve's own surface is 0.
            const level = typeof choice === 'object' ? 0 : Number(((range[0] + range[1]) / 2).toPrecision(4));
            // Another surface may have been chosen meanwhile.
            if (state.activeSurface.value === isosurface) edits.changeSurface({ kind: 'level', field: name, level });
            return `${name}: ${nodes - reached} of ${nodes} nodes have no value.`;
        });
    }

    private wanted(choice: FamilyChoice): FamilyMakeParams | null {
        const { state, time } = this.options;
        const dataset = state.dataset.value;
        if (dataset === null) return null;
        const rake = typeof choice === 'object' ? state.rakes.value.get(choice.rake) : null;
        if (rake === undefined) return null;
        const common = {
            dataset: dataset.dataset,
            name: freeName(dataset.surfaceFields, rake === null ? `${choice as string}_family` : 'rake_family'),
            time: time(),
        };
        if (rake === null) return { ...common, from: 'inflow', scalar: choice as 'x' | 'y' | 'z' };
        const { kind, points } = rake;
        return { ...common, from: 'curve', rakeKind: kind, points: points.map((point) => [...point] as typeof point) };
    }
}

function freeName(taken: readonly string[], name: string): string {
    let free = name;
    for (let i = 2; taken.includes(free); ++i) free = `${name}_${i}`;
    return free;
}
