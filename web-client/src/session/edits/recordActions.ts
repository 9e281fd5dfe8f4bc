// Makes, copies and deletes rakes and surfaces: buttons, one call or a few each.
import type { ParamsOf, RakeRecord, ResultOf, SurfaceSetting, Twin } from '../../protocol/messages.ts';
import { type RakeShape, translated } from '../../scene/rake/rakeShape.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { besideRake, freeLevel, freeRake } from './defaults.ts';
import { announceFailure } from '../base/calls.ts';
import type { Gestures } from './gestures.ts';
import { surfacesOf } from './selection.ts';
import type { UndoHistory } from './undoHistory.ts';

type Edit = 'rake.set' | 'rake.delete' | 'surface.set' | 'surface.twin' | 'surface.delete';
type CallOne = <M extends Edit>(method: M, params: ParamsOf<M>) => Promise<ResultOf<M>>;
type Choose = (what: { rake: string } | { surface: string }) => void;

/** What names an act of the user's, and what counts it. */
interface Acts {
    gestures: Gestures;
    history: UndoHistory;
}

export class RecordActions {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;
    private readonly acts: Acts;
    /** Called with what has been made, whose record may still be on its way. */
    private readonly choose: Choose;

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>, acts: Acts, choose: Choose) {
        this.state = state;
        this.worker = worker;
        this.acts = acts;
        this.choose = choose;
    }

    /** Returns whether it was made, with a surface or without. @param drawn  left out: beside the others */
    async newRake(drawn?: RakeShape): Promise<boolean> {
        let made = false;
        await this.attempt('new rake', async (call) => {
            const { rakes, dataset } = this.state;
            if (dataset.value === null) return;
            const { rake: first } = this.suggestion ?? (await this.suggested());
            const others = [...rakes.value.values()].map(({ points }) => points);
            const shape: RakeShape =
                drawn !== undefined
                    ? drawn
                    : others.length === 0
                      ? { kind: first.kind, points: first.points }
                      : { kind: 'line', points: freeRake(dataset.value.bounds, first.points, others) };
            // As near to each other as those of the first.
            const seeds = others.length === 0 ? first.seeds : Math.max(2, Math.ceil(first.seeds / 2));
            const rake = await this.make(call, shape, { seeds, name: this.freeName('Rake') });
            made = true;
            await call('surface.set', await this.likeActive(rake));
            this.choose({ rake });
        });
        return made;
    }

    /** A rake with a surface in other data, as the server suggests them; what is added next is of those, too. */
    addDataset(dataset: string): Promise<void> {
        return this.attempt('other dataset', async (call) => {
            const { rake: first, surfaces } = await this.worker.call('dataset.suggest', { dataset });
            const rake = await this.make(call, first, { seeds: first.seeds, name: this.freeName('Rake') });
            const { surface } = await call('surface.set', { rake, dataset, ...surfaces[0]! });
            this.choose({ surface });
        });
    }

    /** A little beside the first, with surfaces like its own. */
    duplicate(id: string): Promise<void> {
        return this.attempt('duplicate', async (call) => {
            const { rakes, surfaces, dataset } = this.state;
            const record = rakes.value.get(id);
            if (record === undefined || dataset.value === null) return;
            const { kind, points, seeds, name } = record;
            const shape = translated({ kind, points }, besideRake(dataset.value.bounds, points));
            const rake = await this.make(call, shape, { seeds, name: this.freeName(`${name} copy`) });
            for (const surface of surfacesOf(this.state, id)) {
                const { surface: _surface, rev: _rev, epoch: _epoch, ...setting } = surfaces.value.get(surface)!;
                await call('surface.set', { ...setting, rake });
            }
            this.choose({ rake });
        });
    }

    deleteRake(rake: string): Promise<void> {
        return this.attempt('delete', async (call) => {
            await call('rake.delete', { rake });
        });
    }

    addSurface(rake: string): Promise<void> {
        return this.attempt('add surface', async (call) => {
            const { surface } = await call('surface.set', await this.likeActive(rake));
            this.choose({ surface });
        });
    }

    /** Of a field that no other is of, if there is one. */
    newIsosurface(): Promise<void> {
        return this.attempt('new isosurface', async (call) => {
            const { dataset, surfaces, times } = this.state;
            if (dataset.value === null) return;
            const used = new Set([...surfaces.value.values()].map(({ field }) => field));
            const level = freeLevel(dataset.value, used);
            const [from, to] = [times.value[0] ?? 0, times.value.at(-1) ?? 0];
            const setting = { dataset: dataset.value.dataset, kind: 'level' as const, from, to, ...level };
            const { surface } = await call('surface.set', setting);
            this.choose({ surface });
        });
    }

    deleteSurface(surface: string): Promise<void> {
        return this.attempt('delete surface', async (call) => {
            await call('surface.delete', { surface });
        });
    }

    private async make(call: CallOne, shape: RakeShape, rest: Pick<RakeRecord, 'seeds' | 'name'>): Promise<string> {
        const points = shape.points.map((point) => [...point] as [number, number, number]);
        // The server gives it a colour that few others have.
        const { rake } = await call('rake.set', { kind: shape.kind, points, ...rest });
        return rake;
    }

    /** A surface with the settings of the one the panel shows, or those that the server suggests. */
    private async likeActive(rake: string): Promise<SurfaceSetting> {
        const { surface, dataset: shown } = this.state;
        const like = surface.value;
        if (like?.rake !== undefined && like.kind !== 'time' && like.dataset === shown.value?.dataset) {
            const { surface: _surface, rev: _rev, epoch: _epoch, ...setting } = like;
            return { ...setting, rake };
        }
        const { surfaces } = this.suggestion ?? (await this.suggested());
        return { rake, dataset: shown.value!.dataset, ...surfaces[0]! };
    }

    /** @param twin undefined: with nothing from now on */
    compare(surface: string, twin: Twin | undefined): Promise<void> {
        return this.attempt(`surface ${surface}`, async (call) => {
            await call('surface.twin', twin === undefined ? { surface } : { surface, twin });
        });
    }

    private get suggestion(): ResultOf<'dataset.suggest'> | null {
        const { suggestion, dataset } = this.state;
        return suggestion.value?.dataset === dataset.value?.dataset ? suggestion.value : null;
    }

    private suggested(): Promise<ResultOf<'dataset.suggest'>> {
        return this.worker.call('dataset.suggest', { dataset: this.state.dataset.value!.dataset });
    }

    private freeName(stem: string): string {
        const taken = new Set([...this.state.rakes.value.values()].map(({ name }) => name));
        if (stem !== 'Rake' && !taken.has(stem)) return stem;
        for (let i = stem === 'Rake' ? 1 : 2; ; ++i) if (!taken.has(`${stem} ${i}`)) return `${stem} ${i}`;
    }

    /** However many calls it takes, it is one step of undo. */
    private async attempt(what: string, action: (call: CallOne) => Promise<void>): Promise<void> {
        const gesture = this.acts.gestures.begin();
        try {
            await action(async (method, params) => {
                const result = await this.worker.call(method, { ...params, gesture });
                this.acts.history.noted(gesture);
                return result;
            });
            this.state.problems.solved(what);
        } catch (error) {
            announceFailure(this.state, what, error);
        }
    }
}
