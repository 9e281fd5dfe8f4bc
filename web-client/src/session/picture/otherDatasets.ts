// A session may show things of several datasets. The one of what is chosen is worked on: panels, the marks of the time line and the colours
// of the body are its. Of the others there are outline and body as well, and everything is at the same time, as far as each has it. What is
// not drawn is said.
import { computed, effect, untracked } from '@preact/signals-core';
import type { BodyMesh } from '../../mesh/meshChange.ts';
import type { DatasetDescription, DatasetEntry } from '../../protocol/messages.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { hiddenCells } from '../../state/bodyPatches.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Bodies } from './bodies.ts';

export interface OtherDatasetsOptions {
    state: AppState;
    view: Pick<ViewState, 'body' | 'chosenThing'>;
    scene: Pick<FlowScene, 'setOtherDomains'> & { body: Pick<FlowScene['body'], 'setOthers'> };
    worker: Pick<WorkerClient, 'call'>;
    bodies: Pick<Bodies, 'of'>;
    /** Works on another from now on. */
    turnTo: (description: DatasetDescription) => void;
}

const about = 'other data';

export class OtherDatasets {
    private readonly options: OtherDatasetsOptions;
    /** What was asked for last, by dataset. */
    private readonly asked = new Map<string, string>();
    private readonly asking = new Set<string>();
    private readonly meshes = new Map<string, BodyMesh>();

    constructor(options: OtherDatasetsOptions) {
        this.options = options;
        const { state } = options;
        effect(() => {
            if (state.stage.value !== 'running') return;
            const wanted = state.wantedDatasets.value;
            const versions = new Map(
                state.datasets.value.map(({ dataset, values, steps }) => [dataset, `${values} ${steps.ready}`]),
            );
            untracked(() => this.follow(wanted, versions));
        });
        effect(() => {
            const chosen = this.chosen.value;
            const other = state.otherDatasets.value.get(chosen);
            if (other !== undefined && state.stage.value === 'running') untracked(() => options.turnTo(other));
        });
        effect(() => {
            options.scene.setOtherDomains([...state.otherDatasets.value.values()].map(({ bounds }) => bounds));
        });
        effect(() => {
            const others = [...state.otherDatasets.value.values()].filter(({ obstacle }) => obstacle);
            void options.view.body.value;
            untracked(() => this.showBodies());
            for (const each of others) untracked(() => void this.loadBody(each));
        });
        effect(() => {
            if (this.words.value === '') state.notices.solved(about);
            else state.notices.say(about, this.words.value);
        });
    }

    /** The dataset of what is chosen; empty: it has none. */
    private readonly chosen = computed((): string => {
        const { state, view } = this.options;
        const thing = view.chosenThing.value;
        if (thing !== null) return (state.slices.value.get(thing) ?? state.lines.value.get(thing))?.dataset ?? '';
        return state.surface.value?.dataset ?? '';
    });

    private readonly words = computed((): string => {
        const { state, view } = this.options;
        const { dataset, otherDatasets } = state;
        const shown = dataset.value;
        if (shown === null || state.stage.value !== 'running') return '';
        const missing = [...state.wantedDatasets.value].filter((id) => state.described(id) === null);
        const bodies = [...otherDatasets.value.values()].filter(({ obstacle }) => obstacle).map(({ name }) => isolated(name));
        const { colourBy, texture } = view.body.value;
        const painted = (colourBy !== 'constant' || texture) && bodies.length > 0;
        const units = [...otherDatasets.value.values()].filter(
            ({ lengthUnit }) => lengthUnit !== undefined && shown.lengthUnit !== undefined && lengthUnit !== shown.lengthUnit,
        );
        return [
            ...missing.map((id) => {
                const why = this.entryOf(id)?.steps.ready === 0 ? 'it is not imported' : 'the server does not describe it';
                return `Of ${this.nameOf(id)} only surfaces are drawn: ${why}.`;
            }),
            painted
                ? `Colours and flow on the body are those of ${isolated(shown.name)}: the body of ${bodies.join(', ')} is grey.`
                : '',
            ...units.map(
                ({ name, lengthUnit }) =>
                    `${isolated(name)} is in ${lengthUnit}, ${isolated(shown.name)} in ${shown.lengthUnit}: both are drawn as their numbers say.`,
            ),
        ]
            .filter((each) => each !== '')
            .join(' ');
    });

    private entryOf(id: string): DatasetEntry | undefined {
        return this.options.state.datasets.value.find(({ dataset }) => dataset === id);
    }

    private nameOf(id: string): string {
        return isolated(this.entryOf(id)?.name ?? id);
    }

    private follow(wanted: ReadonlySet<string>, versions: ReadonlyMap<string, string>): void {
        const { state } = this.options;
        const kept = new Map(
            [...state.otherDatasets.value].filter(([id]) => wanted.has(id) && id !== state.dataset.value?.dataset),
        );
        if (kept.size < state.otherDatasets.value.size) state.otherDatasets.value = kept;
        for (const id of [...this.asked.keys()].filter((each) => !wanted.has(each))) this.asked.delete(id);
        for (const id of wanted) {
            const version = versions.get(id) ?? '';
            if (id === state.dataset.value?.dataset) continue;
            if (this.asked.get(id) === version && (state.described(id) !== null || this.asking.has(id))) continue;
            this.asked.set(id, version);
            this.asking.add(id);
            void this.describe(id).finally(() => this.asking.delete(id));
        }
    }

    private async describe(id: string): Promise<void> {
        const { state, worker } = this.options;
        try {
            const description = await worker.call('dataset.describe', { dataset: id });
            if (!state.wantedDatasets.value.has(id) || state.dataset.value?.dataset === id) return;
            state.otherDatasets.value = new Map(state.otherDatasets.value).set(id, description);
        } catch {
            // The words say that it is missing.
        }
    }

    private async loadBody(description: DatasetDescription): Promise<void> {
        const { state, bodies } = this.options;
        try {
            const mesh = await bodies.of(description, false);
            if (mesh === null || this.meshes.get(description.dataset) === mesh) return;
            this.meshes.set(description.dataset, mesh);
            this.showBodies();
        } catch (error) {
            state.notices.tell('body', error);
        }
    }

    private showBodies(): void {
        const { state, view, scene } = this.options;
        const others = state.otherDatasets.peek();
        for (const id of [...this.meshes.keys()].filter((each) => !others.has(each))) this.meshes.delete(id);
        scene.body.setOthers(
            [...this.meshes].map(([id, mesh]) => ({ mesh, hidden: hiddenCells(others.get(id)!, view.body.peek(), false) })),
        );
    }
}
