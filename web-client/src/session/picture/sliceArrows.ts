// The arrows of slices: three components of the velocity at few places, asked for as values of slices are, while this page shows them.
import { signal } from '@preact/signals-core';
import type { OwnServer } from '../../connection/ownServer.ts';
import { readSliceFile, type SliceRaster } from '../../protocol/sliceFile.ts';
import { planeArrows, type SliceArrowLayer } from '../../scene/slices/sliceArrows.ts';
import { NewestValues } from './newestValues.ts';
import { pathOf, type SliceWish } from './sliceValues.ts';

export interface SliceArrowsOptions {
    layer: SliceArrowLayer;
    fetch: OwnServer['fetch'];
    requestFrame: () => void;
    changed: () => void;
}

const components = ['velocity_x', 'velocity_y', 'velocity_z'] as const;
/** Along the longer side of a slice. */
const arrowsAlong = 36;

type Components = [SliceRaster, SliceRaster, SliceRaster];

export class SliceArrows {
    /** By slice, the speed in the plane that the longest arrow stands for. */
    readonly longest = signal<ReadonlyMap<string, number>>(new Map());
    private readonly options: SliceArrowsOptions;
    private readonly values: NewestValues<Omit<SliceWish, 'field'>, Components>;

    constructor(options: SliceArrowsOptions) {
        this.options = options;
        this.values = new NewestValues({
            fetch: (paths, init) => this.fetchAll(paths.split('\n'), init),
            path: (wish, detail) => components.map((field) => pathOf({ ...wish, field }, detail)).join('\n'),
            read: readComponents,
            detail: { coarse: arrowsAlong, full: arrowsAlong, learn: () => undefined },
            arrived: (id, rasters) => this.draw(id, rasters),
            // The slice itself says why it has no values.
            told: (id, fault) => fault !== null && this.forget(id),
            changed: options.changed,
        });
    }

    get unfinished(): boolean {
        return this.values.unfinished;
    }

    want(id: string, { dataset, origin, normal, time }: SliceWish): void {
        this.values.want(id, { dataset, origin, normal, time });
    }

    again(): void {
        this.values.again();
    }

    remove(id: string): void {
        this.values.remove(id);
        this.forget(id);
    }

    private draw(id: string, rasters: Components): void {
        const arrows = planeArrows(rasters);
        this.options.layer.set(id, arrows);
        this.longest.value = new Map(this.longest.peek()).set(id, arrows.longest);
        this.options.requestFrame();
    }

    private forget(id: string): void {
        this.options.layer.remove(id);
        const longest = new Map(this.longest.peek());
        if (longest.delete(id)) this.longest.value = longest;
        this.options.requestFrame();
    }

    /** The files one after the other, or the first refusal. */
    private async fetchAll(paths: readonly string[], init: RequestInit): Promise<Response> {
        const replies = await Promise.all(paths.map((path) => this.options.fetch(path, init)));
        const refused = replies.find(({ ok }) => !ok);
        return refused ?? new Response(new Blob(await Promise.all(replies.map((reply) => reply.blob()))));
    }
}

/** The files of one plane are equally long. */
function readComponents(bytes: ArrayBuffer): Components {
    const length = bytes.byteLength / components.length;
    return components.map((_, i) => readSliceFile(bytes.slice(i * length, (i + 1) * length))) as Components;
}
