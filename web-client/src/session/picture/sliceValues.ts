// The values of slices: coarse ones with as many samples as come in time, fine ones with as many as the screen has.
import type { Vec3 } from '../../protocol/messages.ts';
import { readSliceFile, type SliceRaster } from '../../protocol/sliceFile.ts';
import type { MinusWish } from './sliceMinus.ts';
import { type Detail, NewestValues, type NewestValuesOptions } from './newestValues.ts';

export interface SliceWish {
    dataset: string;
    origin: Vec3;
    normal: Vec3;
    field: string;
    /** Null: the data have one time. */
    time: number | null;
    minus?: MinusWish | null;
}

export interface SliceValuesOptions extends Omit<NewestValuesOptions<SliceWish, SliceRaster>, 'path' | 'read' | 'detail'> {
    /** Samples of a slice as fine as the screen. */
    fullSamples: () => number;
}

/** A coarse one is to take so long, from asking to having. */
const coarseMs = 40;
const leastSamples = 64;
const mostSamples = 2048;

export class SliceValues extends NewestValues<SliceWish, SliceRaster> {
    constructor(options: SliceValuesOptions) {
        super({ ...options, path: pathOf, read: readSliceFile, detail: new Samples(options.fullSamples) });
    }
}

/** Along the longer side. */
class Samples implements Detail {
    private readonly ofScreen: () => number;
    /** Learnt from how long they take. */
    private learnt = 192;

    constructor(ofScreen: () => number) {
        this.ofScreen = ofScreen;
    }

    get coarse(): number {
        return Math.min(Math.round(this.learnt), this.full);
    }

    get full(): number {
        return Math.max(leastSamples, Math.min(mostSamples, Math.ceil(this.ofScreen())));
    }

    /** The time goes with the number of samples, the square of those along a side. */
    learn(ms: number): void {
        const factor = Math.sqrt(coarseMs / Math.max(ms, 1));
        this.learnt = Math.max(leastSamples, Math.min(mostSamples, this.learnt * Math.max(0.5, Math.min(1.25, factor))));
    }
}

export function pathOf({ dataset, origin, normal, field, time, minus = null }: SliceWish, samples: number): string {
    const query = new URLSearchParams({ plane: `${origin.join(',')}:${normal.join(',')}`, field, samples: String(samples) });
    if (time !== null) query.set('time', String(time));
    if (minus !== null) query.set('minus', minus.dataset);
    if (minus !== null && minus.time !== null) query.set('minusTime', String(minus.time));
    return `api/v1/datasets/${encodeURIComponent(dataset)}/slice.bin?${query.toString()}`;
}
