// The values of slices as the server has them: of each slice one request at a time, coarse while it changes and as fine as the screen once
// it stands still. What came meanwhile is asked for next, the newest alone; a fine request that is out of date is cancelled, a coarse one is
// nearly here and shown, so that a plane that is dragged never waits for its last place.
import { faultOf, requestWords } from '../../connection/ownServer.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import { readSliceFile, type SliceRaster } from '../../protocol/sliceFile.ts';

export interface SliceWish {
    dataset: string;
    origin: Vec3;
    normal: Vec3;
    field: string;
    /** Null: the data have one time. */
    time: number | null;
}

export interface SliceValuesOptions {
    fetch: (path: string, init: RequestInit) => Promise<Response>;
    /** Samples of a slice as fine as the screen. */
    fullSamples: () => number;
    arrived: (id: string, raster: SliceRaster, wish: SliceWish) => void;
    /** Why there are none for what is wanted; null: there are. */
    told: (id: string, fault: string | null) => void;
    /** Told when `unfinished` may be another. */
    changed?: () => void;
    now?: () => number;
}

interface Slice {
    wish: SliceWish;
    key: string;
    asked: { abort: AbortController; key: string; samples: number } | null;
    /** Of what is shown, or could not be had. */
    answered: { key: string; samples: number };
    rest: ReturnType<typeof setTimeout> | undefined;
}

/** So long it stands still before it is fine. */
const restMs = 150;
/** A coarse one is to take so long, from asking to having. */
const coarseMs = 40;
const leastSamples = 64;
const mostSamples = 2048;

export class SliceValues {
    private readonly options: SliceValuesOptions;
    private readonly slices = new Map<string, Slice>();
    /** Of coarse ones: learnt from how long they take. */
    private coarse = 192;

    constructor(options: SliceValuesOptions) {
        this.options = options;
    }

    want(id: string, wish: SliceWish): void {
        const key = JSON.stringify(wish);
        const slice = this.slices.get(id) ?? { wish, key: '', asked: null, answered: { key: '', samples: 0 }, rest: undefined };
        this.slices.set(id, slice);
        if (slice.key === key) return;
        Object.assign(slice, { wish, key });
        clearTimeout(slice.rest);
        if (slice.asked !== null && slice.asked.samples > this.coarseSamples) slice.asked.abort.abort();
        this.next(id, slice);
        this.options.changed?.();
    }

    remove(id: string): void {
        const slice = this.slices.get(id);
        clearTimeout(slice?.rest);
        slice?.asked?.abort.abort();
        this.slices.delete(id);
        this.options.changed?.();
    }

    /** A slice is not there, or not as fine as the screen. */
    get unfinished(): boolean {
        return [...this.slices.values()].some(({ key, answered }) => answered.key !== key || answered.samples < this.fullSamples);
    }

    /** The screen has changed: slices that stand still may have to be finer. */
    refresh(): void {
        for (const [id, slice] of this.slices) this.next(id, slice);
    }

    /** Again, also of what could not be had: the data or the connection are others. */
    again(): void {
        for (const [id, slice] of this.slices) {
            slice.answered = { key: '', samples: 0 };
            this.next(id, slice);
        }
    }

    private get coarseSamples(): number {
        return Math.min(Math.round(this.coarse), this.fullSamples);
    }

    private get fullSamples(): number {
        return Math.max(leastSamples, Math.min(mostSamples, Math.ceil(this.options.fullSamples())));
    }

    private next(id: string, slice: Slice): void {
        if (slice.asked !== null) return;
        const { key, answered } = slice;
        if (answered.key !== key) void this.ask(id, slice, this.coarseSamples);
        else if (answered.samples < this.fullSamples) {
            clearTimeout(slice.rest);
            slice.rest = setTimeout(() => {
                if (slice.asked === null && this.slices.get(id) === slice) void this.ask(id, slice, this.fullSamples);
            }, restMs);
        }
    }

    private async ask(id: string, slice: Slice, samples: number): Promise<void> {
        const { fetch, arrived, told, now = () => performance.now() } = this.options;
        const { wish, key } = slice;
        const asked = { abort: new AbortController(), key, samples };
        slice.asked = asked;
        const begun = now();
        let fault: string | null = null;
        let raster: SliceRaster | null = null;
        try {
            const reply = await fetch(pathOf(wish, samples), { signal: asked.abort.signal });
            if (!reply.ok) throw await faultOf(reply);
            raster = readSliceFile(await reply.arrayBuffer());
            if (samples === this.coarseSamples) this.learn(now() - begun);
        } catch (error) {
            fault = requestWords(error);
        }
        slice.asked = null;
        if (this.slices.get(id) !== slice) return;
        if (raster !== null) arrived(id, raster, wish);
        // What was cancelled was not answered.
        if (!asked.abort.signal.aborted) {
            slice.answered = { key, samples: raster === null ? mostSamples : samples };
            if (key === slice.key) told(id, fault);
        }
        this.next(id, slice);
        this.options.changed?.();
    }

    /** The time goes with the number of samples, the square of those along a side. */
    private learn(ms: number): void {
        const factor = Math.sqrt(coarseMs / Math.max(ms, 1));
        this.coarse = Math.max(leastSamples, Math.min(mostSamples, this.coarse * Math.max(0.5, Math.min(1.25, factor))));
    }
}

export function pathOf({ dataset, origin, normal, field, time }: SliceWish, samples: number): string {
    const query = new URLSearchParams({ plane: `${origin.join(',')}:${normal.join(',')}`, field, samples: String(samples) });
    if (time !== null) query.set('time', String(time));
    return `api/v1/datasets/${encodeURIComponent(dataset)}/slice.bin?${query.toString()}`;
}
