// The steps of an animation, decoded one after the other. To go back, states are kept now and then, and the steps between are
// decoded once more.
import type { MeshChange } from '../mesh/meshChange.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { MeshDecoder } from '../protocol/meshDecoder.ts';
import { type FrameHeader, readFrame } from '../protocol/meshFrame.ts';
import { WireMesh } from '../protocol/wireMesh.ts';
import { DisplayArrays } from '../worker/displayArrays.ts';
import type { ShowWish } from '../worker/workerMessages.ts';
import type { AnimationFile } from './animationFile.ts';

/** Of states that are kept. Each takes some 70 bytes a vertex. */
const mostKept = 24;

const nothing = { all: [], count: 0 };
const noEdit = {
    ...{ removedVertices: nothing, addedVertices: 0, movedVertices: nothing },
    ...{ removedCells: nothing, replacedCells: nothing, cells: new Int32Array(0) },
};

interface KeptState {
    header: FrameHeader;
    ranges: WireMesh['ranges'];
    vertices: number;
    positions: Int32Array;
    changes: Int32Array;
    codes: Uint16Array[];
    cells: Int32Array;
}

export class AnimationSteps {
    /** How many there are. */
    readonly count: number;
    private readonly frames: readonly Uint8Array[][];
    private readonly decoder: MeshDecoder;
    private readonly display: DisplayArrays;
    private readonly kept = new Map<number, KeptState>();
    private readonly keepEvery: number;
    private at = -1;

    constructor({ description, frames }: AnimationFile, draco: DracoPoints) {
        this.frames = byUpdate(frames);
        this.count = this.frames.length;
        if (this.count !== description.times.length) throw new Error('This file is not whole: it has fewer steps than it says.');
        this.keepEvery = Math.ceil(this.count / mostKept);
        this.decoder = new MeshDecoder(draco, description.lattice, description.attributes.length);
        this.display = new DisplayArrays(description.lattice, description.attributes);
    }

    /** The step that is decoded; -1: none. */
    get current(): number {
        return this.at;
    }

    /** How many steps have to be decoded before this one is there. */
    awayFrom(step: number): number {
        return step - this.startFor(step);
    }

    /** Goes one step towards this one. Returns whether it is there. Throws FrameError. */
    approach(step: number): boolean {
        const start = this.startFor(step);
        if (start !== this.at) this.restore(start);
        if (this.at < step) this.decodeNext();
        return this.at === step;
    }

    /** What has changed since the last call. */
    take(wish: ShowWish): MeshChange & { time: number } {
        const { mesh, newest } = this.decoder;
        if (mesh === undefined || newest === undefined) throw new Error('no step has been decoded');
        this.display.show(wish);
        return { ...this.display.take(mesh), time: newest.time };
    }

    /** From where a step is reached soonest. */
    private startFor(step: number): number {
        const before = [...this.kept.keys(), -1].filter((each) => each <= step);
        const nearest = Math.max(...before);
        return this.at <= step && this.at >= nearest ? this.at : nearest;
    }

    private decodeNext(): void {
        const next = this.at + 1;
        for (const frame of this.frames[next]!) {
            const applied = this.decoder.fold(frame);
            if (applied !== undefined) this.display.note(applied);
        }
        this.at = next;
        if (next % this.keepEvery === 0 && !this.kept.has(next)) this.kept.set(next, this.keep());
    }

    private keep(): KeptState {
        const { mesh, newest: header } = this.decoder;
        if (mesh === undefined || header === undefined) throw new Error('a step is not whole');
        const { vertices, ranges, position, codes, cells } = mesh;
        return {
            ...{ header, ranges, vertices },
            positions: position.values.slice(0, 3 * vertices),
            changes: position.change.slice(0, 3 * vertices),
            codes: codes.map(({ values }) => Uint16Array.from(values.subarray(0, vertices))),
            cells: cells.slice(),
        };
    }

    /** -1: before the first step, which is a KEY. */
    private restore(step: number): void {
        this.at = step;
        const kept = this.kept.get(step);
        if (kept === undefined) return this.decoder.beginAgain();
        const mesh = new WireMesh(kept.header.latticeBits, kept.ranges);
        mesh.beginVertices(nothing, kept.vertices);
        mesh.position.values.set(kept.positions);
        mesh.position.change.set(kept.changes);
        kept.codes.forEach((values, i) => mesh.codes[i]!.values.set(values));
        mesh.appendCells(kept.cells);
        mesh.cellsChanged(0);
        this.decoder.beginAgain({ header: kept.header, mesh });
        this.display.note({ header: { ...kept.header, key: true }, edit: { ...noEdit, addedVertices: mesh.vertices }, mesh });
    }
}

function byUpdate(frames: readonly Uint8Array[]): Uint8Array[][] {
    const updates: Uint8Array[][] = [];
    for (const frame of frames) {
        if (readFrame(frame).header.frameIndex === 0) updates.push([]);
        updates.at(-1)?.push(frame);
    }
    return updates;
}
