// Values of things in the picture as the server has them: of each thing one request at a time, coarse while it changes and fine once it
// stands still. What came meanwhile is asked for next, the newest alone; a fine request that is out of date is cancelled, a coarse one is
// nearly here and shown, so that what is dragged never waits for its last place.
import { effect, untracked } from '@preact/signals-core';
import { faultOf, requestWords } from '../../connection/ownServer.ts';
import type { AppState } from '../../state/appState.ts';
import { toldLate } from '../base/lateWaits.ts';

/** How finely values are asked for. Both the same: they are asked for once. */
export interface Detail {
    readonly coarse: number;
    readonly full: number;
    /** Told how long a coarse one took, from asking to having. */
    learn: (ms: number) => void;
}

export interface NewestValuesOptions<W, V> {
    fetch: (path: string, init: RequestInit) => Promise<Response>;
    path: (wish: W, detail: number) => string;
    /** Throws where the bytes are none. */
    read: (bytes: ArrayBuffer) => V;
    detail: Detail;
    arrived: (id: string, values: V, wish: W) => void;
    /** Why there are none for what is wanted; null: there are. */
    told: (id: string, fault: string | null) => void;
    /** Of one that the server has not answered for long, and once it has. */
    late?: ((id: string, late: boolean) => void) | undefined;
    /** Told when `unfinished` may be another. */
    changed?: () => void;
    now?: () => number;
}

interface Thing<W> {
    wish: W;
    key: string;
    asked: { abort: AbortController; key: string; detail: number } | null;
    /** Of what is shown, or could not be had. */
    answered: { key: string; detail: number };
    rest: ReturnType<typeof setTimeout> | undefined;
}

/** So long it stands still before it is fine. */
const restMs = 150;

export class NewestValues<W, V> {
    private readonly options: NewestValuesOptions<W, V>;
    private readonly things = new Map<string, Thing<W>>();

    constructor(options: NewestValuesOptions<W, V>) {
        this.options = options;
    }

    want(id: string, wish: W): void {
        const key = JSON.stringify(wish);
        const thing = this.things.get(id) ?? { wish, key: '', asked: null, answered: { key: '', detail: 0 }, rest: undefined };
        this.things.set(id, thing);
        if (thing.key === key) return;
        Object.assign(thing, { wish, key });
        clearTimeout(thing.rest);
        if (thing.asked !== null && thing.asked.detail > this.options.detail.coarse) thing.asked.abort.abort();
        this.next(id, thing);
        this.options.changed?.();
    }

    remove(id: string): void {
        const thing = this.things.get(id);
        clearTimeout(thing?.rest);
        thing?.asked?.abort.abort();
        this.things.delete(id);
        this.options.changed?.();
    }

    /** Something is not there, or not as fine as it is to be. */
    get unfinished(): boolean {
        const { full } = this.options.detail;
        return [...this.things.values()].some(({ key, answered }) => answered.key !== key || answered.detail < full);
    }

    /** The screen has changed: what stands still may have to be finer. */
    refresh(): void {
        for (const [id, thing] of this.things) this.next(id, thing);
    }

    /** Again, also of what could not be had: the data or the connection are others. */
    again(): void {
        for (const [id, thing] of this.things) {
            thing.answered = { key: '', detail: 0 };
            this.next(id, thing);
        }
    }

    /** What has not been answered is not waited for any more, and asked for again. */
    retry(id: string): void {
        this.things.get(id)?.asked?.abort.abort();
    }

    private next(id: string, thing: Thing<W>): void {
        if (thing.asked !== null) return;
        const { key, answered } = thing;
        const { detail } = this.options;
        if (answered.key !== key) void this.ask(id, thing, detail.coarse);
        else if (answered.detail < detail.full) {
            clearTimeout(thing.rest);
            thing.rest = setTimeout(() => {
                if (thing.asked === null && this.things.get(id) === thing) void this.ask(id, thing, detail.full);
            }, restMs);
        }
    }

    private async ask(id: string, thing: Thing<W>, detail: number): Promise<void> {
        const { path, read, arrived, told, now = () => performance.now() } = this.options;
        const { wish, key } = thing;
        const asked = { abort: new AbortController(), key, detail };
        thing.asked = asked;
        const begun = now();
        let fault: string | null = null;
        let values: V | null = null;
        try {
            const answer = this.load(path(wish, detail), asked.abort.signal);
            values = read(await toldLate(answer, (isLate) => this.options.late?.(id, isLate)));
            if (detail === this.options.detail.coarse) this.options.detail.learn(now() - begun);
        } catch (error) {
            fault = requestWords(error);
        }
        thing.asked = null;
        if (this.things.get(id) !== thing) return;
        // What was cancelled was not answered.
        if (!asked.abort.signal.aborted) {
            thing.answered = { key, detail: values === null ? Number.POSITIVE_INFINITY : detail };
            if (key === thing.key) told(id, fault);
        }
        // After that: values that are there may have something of their own to say.
        if (values !== null) arrived(id, values, wish);
        this.next(id, thing);
        this.options.changed?.();
    }

    private async load(path: string, signal: AbortSignal): Promise<ArrayBuffer> {
        const reply = await this.options.fetch(path, { signal });
        if (!reply.ok) throw await faultOf(reply);
        return reply.arrayBuffer();
    }
}

/** Calls back whenever data of the session are others, or the server is there again: what could not be had may be there now. */
export function onOtherData(
    state: Pick<AppState, 'datasetEntry' | 'datasets' | 'slices' | 'stage' | 'wantedDatasets'>,
    again: () => void,
): void {
    const known = new Map<string, string>();
    let heard = false;
    effect(() => {
        const { datasetEntry, datasets, slices, stage, wantedDatasets } = state;
        const entries = [...(datasetEntry.value === null ? [] : [datasetEntry.value]), ...datasets.value];
        const versions = new Map(entries.map(({ dataset, values, steps }) => [dataset, `${values} ${steps.ready}`]));
        const subtracted = [...slices.value.values()].flatMap(({ minus }) => minus ?? []);
        let others = false;
        for (const id of [...wantedDatasets.value, ...subtracted]) {
            const version = versions.get(id) ?? '';
            others ||= (known.get(id) ?? version) !== version;
            known.set(id, version);
        }
        const hears = stage.value === 'running';
        const back = hears && !heard;
        heard = hears;
        if (back || (hears && others)) untracked(again);
    });
}
