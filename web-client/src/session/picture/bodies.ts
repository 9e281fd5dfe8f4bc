// Bodies as the server has them, by dataset: fetched once, however many of its things are chosen one after the other.
import type { BodyMesh } from '../../mesh/meshChange.ts';
import type { DatasetDescription } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { gridOf } from '../base/gridOf.ts';
import { type LateWaits, waitsSaid } from '../base/lateWaits.ts';

export class Bodies {
    private readonly state: Pick<AppState, 'datasets' | 'notices'>;
    private readonly worker: Pick<WorkerClient, 'obstacle'>;
    private readonly known = new Map<string, { key: string; mesh: Promise<BodyMesh | null> }>();
    private readonly waits: LateWaits;

    constructor(state: Pick<AppState, 'datasets' | 'notices'>, worker: Pick<WorkerClient, 'obstacle'>) {
        this.state = state;
        this.waits = waitsSaid(state.notices, 'the body');
        this.worker = worker;
    }

    /** Null: there is none. @param allPatches also those that are no part of the body */
    of({ dataset, lattice }: DatasetDescription, allPatches: boolean): Promise<BodyMesh | null> {
        const grid = gridOf(this.state.datasets.value.find((each) => each.dataset === dataset)?.values);
        const key = JSON.stringify([grid, allPatches]);
        const known = this.known.get(dataset);
        if (known?.key === key) return known.mesh;
        const mesh = this.waits.until(() => this.worker.obstacle(dataset, lattice, allPatches));
        this.known.set(dataset, { key, mesh });
        // What could not be had may be there the next time.
        mesh.catch(() => {
            if (this.known.get(dataset)?.mesh === mesh) this.known.delete(dataset);
        });
        return mesh;
    }
}
