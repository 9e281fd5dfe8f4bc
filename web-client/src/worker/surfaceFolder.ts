// Folds the frames of all subscriptions into complete states. A state that a newer one has
// overtaken before it was whole is never handed on: MeshDecoder starts afresh at each first frame.
import type { Subscription } from '../protocol/messages.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { MeshDecoder, type WireMesh } from '../protocol/meshDecoder.ts';
import { surfaceOf } from '../protocol/meshFrame.ts';
import { triangulate } from '../protocol/triangulate.ts';
import { vertexNormals } from './normals.ts';
import type { SurfaceState } from './workerMessages.ts';

export interface SurfaceFolderOptions {
    draco: DracoPoints;
    onState: (state: SurfaceState) => void;
    onTrouble: (subscription: number, reason: string) => void;
}

export class SurfaceFolder {
    private readonly options: SurfaceFolderOptions;
    private readonly decoders = new Map<number, MeshDecoder>();
    private readonly troubled = new Set<number>();

    constructor(options: SurfaceFolderOptions) {
        this.options = options;
    }

    subscribed(agreed: Subscription): void {
        const decoder = new MeshDecoder(this.options.draco, agreed.lattice, agreed.attributes);
        this.decoders.set(agreed.subscription, decoder);
        this.troubled.delete(agreed.subscription);
    }

    unsubscribed(subscription: number): void {
        this.decoders.delete(subscription);
    }

    /** Subscriptions do not outlive the connection. */
    clear(): void {
        this.decoders.clear();
        this.troubled.clear();
    }

    receive(frame: Uint8Array): void {
        const subscription = surfaceOf(frame);
        const decoder = subscription === undefined ? undefined : this.decoders.get(subscription);
        if (subscription === undefined || decoder === undefined) return;
        try {
            if (!decoder.fold(frame).last) return;
            this.troubled.delete(subscription);
            const mesh = decoder.take();
            if (mesh !== undefined) this.options.onState(stateOf(mesh));
        } catch (error) {
            // Frames that follow a damaged one fail too; one report is enough.
            if (this.troubled.has(subscription)) return;
            this.troubled.add(subscription);
            const reason = error instanceof Error ? error.message : String(error);
            this.options.onTrouble(subscription, reason);
        }
    }
}

function stateOf(mesh: WireMesh): SurfaceState {
    const indices = triangulate(mesh.cells, mesh.positions);
    const range = mesh.ranges['speed'];
    return {
        subscription: mesh.surface,
        epoch: mesh.epoch,
        final: mesh.final,
        stateCrc: mesh.stateCrc,
        vertices: mesh.vertexCount,
        cells: mesh.cellCount,
        triangles: indices.length / 3,
        speedRange: range === undefined ? [0, 0] : [range.lo, range.hi],
        positions: mesh.positions,
        normals: vertexNormals(mesh.positions, indices),
        scalars: mesh.attributes['speed'] ?? new Float32Array(mesh.vertexCount),
        indices,
    };
}
