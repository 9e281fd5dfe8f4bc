// The dataset that is worked on: waits for its import, puts its domain and body into the picture, follows its growth. Another of the picture
// may take its place (otherDatasets.ts).
import { batch, computed, effect } from '@preact/signals-core';
import { type DatasetDescription, type DatasetEntry, errorWords, type HeldChange } from '../protocol/messages.ts';
import type { FlowScene } from '../scene/scene.ts';
import { type AppState, withEntry } from '../state/appState.ts';
import { showsBeyondBody } from '../state/bodyPatches.ts';
import type { ViewState } from '../state/viewState.ts';
import type { WorkerClient } from '../worker/workerClient.ts';
import type { ImportWait } from './importWait.ts';
import { gridOf } from './base/gridOf.ts';
import type { Bodies } from './picture/bodies.ts';
import { StepsHeld } from './time/cachedSteps.ts';

const importPollMs = 1000;

export interface OpenDatasetOptions {
    state: AppState;
    view: Pick<ViewState, 'body'>;
    scene: Pick<FlowScene, 'setDomain'> & { body: Pick<FlowScene['body'], 'set' | 'remove'> };
    worker: Pick<WorkerClient, 'call'>;
    bodies: Pick<Bodies, 'of'>;
    imports: Pick<ImportWait, 'begin' | 'left'>;
}

export class OpenDataset {
    private readonly options: OpenDatasetOptions;
    private readonly stepsHeld: StepsHeld;
    /** What the values of the data that are shown are told from others by. */
    private values: string | undefined;
    private readonly allPatches = computed(() => {
        const { state, view } = this.options;
        return showsBeyondBody(state.dataset.value, view.body.value);
    });

    constructor(options: OpenDatasetOptions) {
        this.options = options;
        this.stepsHeld = new StepsHeld(options.state, options.worker);
        let before = false;
        effect(() => {
            const all = this.allPatches.value;
            const shown = options.state.dataset.peek();
            if (all !== before && shown !== null) void this.loadObstacle(shown);
            before = all;
        });
    }

    /** Until some of its time-steps can be used, and as long as its user wants to wait; null when `gone`.
     *  @param id null: the first one */
    async wait(id: string | null, gone: () => boolean): Promise<DatasetEntry | null> {
        const { worker, state, imports } = this.options;
        while (!gone()) {
            const { datasets } = await worker.call('dataset.list', {});
            state.datasets.value = datasets;
            const entry = id === null ? datasets[0] : datasets.find(({ dataset }) => dataset === id);
            if (entry === undefined) throw new Error(noDataset(id));
            state.datasetEntry.value = entry;
            // Until a user says which field the velocity is.
            const unclear = velocitiesOf(entry).length > 0;
            if (entry.state === 'failed' && !unclear) throw new Error(importFailed(entry));
            const usable = entry.state === 'ready' || entry.steps.ready > 0;
            // What a user has stopped stays so where there is something to see.
            const wanted = entry.state === 'importing' || (entry.state === 'stopped' && !usable);
            if (wanted && !imports.left.value) void imports.begin(entry.dataset);
            const leaving = imports.left.value && entry.state === 'importing' && state.stage.value === 'importing';
            if (usable && !leaving) return entry;
            state.stage.value = 'importing';
            await new Promise((resolve) => setTimeout(resolve, importPollMs));
        }
        return null;
    }

    async describe(dataset: string): Promise<void> {
        const { worker, state } = this.options;
        const values = state.datasetEntry.value?.values;
        const description = await worker.call('dataset.describe', { dataset });
        if (state.datasetEntry.value?.dataset !== dataset) {
            // Another is worked on since.
            const { otherDatasets } = state;
            if (otherDatasets.value.has(dataset)) otherDatasets.value = withEntry(otherDatasets.value, dataset, description);
            return;
        }
        const before = this.values;
        const another = this.workOn(description, values);
        if (!sameValues(before, values)) state.suggestion.value = null;
        if (another || gridOf(before) !== gridOf(values)) this.draw(description, state.otherDatasets.value.size > 0);
    }

    /** Works on another dataset of the picture from now on; the camera stays. */
    turnTo(description: DatasetDescription): void {
        const { datasets, datasetEntry } = this.options.state;
        batch(() => {
            datasetEntry.value = datasets.value.find((each) => each.dataset === description.dataset) ?? null;
            this.workOn(description, datasetEntry.value?.values);
        });
        this.draw(description, true);
    }

    /** Returns whether it is another than before, which stays in the picture if the session has something of it. */
    private workOn(description: DatasetDescription, values: string | undefined): boolean {
        const { state } = this.options;
        const { dataset } = description;
        const before = state.dataset.value;
        const another = before?.dataset !== dataset;
        const others = new Map(state.otherDatasets.value);
        const stays = before !== null && another && state.wantedDatasets.value.has(before.dataset);
        if (stays) others.set(before.dataset, before);
        const changed = others.delete(dataset) || stays;
        batch(() => {
            if (changed) state.otherDatasets.value = others;
            state.dataset.value = description;
        });
        this.values = values;
        void this.stepsHeld.load(dataset);
        return another;
    }

    /** @param stays the camera is left where it is */
    private draw(description: DatasetDescription, stays: boolean): void {
        const { scene } = this.options;
        scene.setDomain(description.bounds, stays);
        // With the values of another, which must not be painted on this one.
        scene.body.remove();
        void this.loadObstacle(description);
    }

    private async loadObstacle(description: DatasetDescription): Promise<void> {
        const { dataset } = description;
        const allPatches = this.allPatches.peek();
        if (!description.obstacle && !allPatches) return this.options.scene.body.remove();
        try {
            const geometry = await this.options.bodies.of(description, allPatches);
            const stillShown = this.options.state.dataset.value?.dataset === dataset;
            if (!stillShown || allPatches !== this.allPatches.peek()) return;
            if (geometry === null) return this.options.scene.body.remove();
            this.options.state.allPatchesShown.value = allPatches;
            this.options.scene.body.set(geometry);
        } catch (error) {
            this.options.state.notices.tell('body', error);
        }
    }

    patched(entry: DatasetEntry): void {
        const { state } = this.options;
        const { dataset } = entry;
        state.datasets.value = state.datasets.value.map((each) => (each.dataset === dataset ? entry : each));
        if (state.datasetEntry.value?.dataset !== dataset) return;
        state.datasetEntry.value = entry;
        // The range of the velocity is known in full only now.
        if (entry.state === 'ready' || entry.state === 'incomplete') void this.describe(dataset).catch(() => undefined);
    }

    stepsPatched(dataset: string, changes: readonly HeldChange[]): void {
        this.stepsHeld.patched(dataset, changes);
    }
}

/** A word each for the grid, the first time-step and all of them: "0-... 1-... 16-...". A longer series
 *  begins with the same. */
function sameValues(before: string | undefined, now: string | undefined): boolean {
    const [grid, first, all] = (before ?? '').split(' ');
    const [gridNow, firstNow, allNow] = (now ?? '').split(' ');
    const count = (word: string | undefined) => word?.split('-')[0];
    return grid === gridNow && first === firstNow && (count(all) !== count(allNow) || all === allNow);
}

/** Returns what the velocity of a dataset could be, which is not clear from its files. */
export function velocitiesOf({ state, velocities }: DatasetEntry): readonly string[] {
    return state === 'failed' ? (velocities ?? []) : [];
}

function noDataset(id: string | null): string {
    return id === null
        ? 'The server has no dataset. Start it with one: wakesurf serve DATASET.'
        : 'The server does not have the dataset of this link. Choose another in the panel.';
}

function importFailed(entry: DatasetEntry): string {
    const why = entry.error === undefined ? '' : ` ${errorWords(entry.error)}`;
    return `${entry.name} could not be imported.${why}`;
}
