// The Draco decoder of a worker, and its memory, which can only grow: past a limit a new one takes its place.
import createDecoderModule from 'draco3d/draco_decoder_nodejs.js';
import wasmUrl from 'draco3d/draco_decoder.wasm?url';
import { DracoPoints } from '../protocol/dracoPoints.ts';

const largestHeap = 256 << 20;

let wasmBinary: ArrayBuffer | null = null;
let renewing = false;

export async function loadDraco(): Promise<DracoPoints> {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error('The mesh decoder could not be loaded from the server.');
    wasmBinary = await response.arrayBuffer();
    return new DracoPoints(await createDecoderModule({ wasmBinary }));
}

/** Called after every frame; nearly always does nothing. */
export function keepDracoSmall(draco: DracoPoints): void {
    if (draco.heapBytes <= largestHeap || renewing || wasmBinary === null) return;
    renewing = true;
    void createDecoderModule({ wasmBinary })
        .then((module) => draco.renew(module))
        .finally(() => (renewing = false));
}
