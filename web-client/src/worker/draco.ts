// The Draco decoder, loaded once a worker: its memory only grows and it cannot be created again.
import createDecoderModule from 'draco3d/draco_decoder_nodejs.js';
import wasmUrl from 'draco3d/draco_decoder.wasm?url';
import { DracoPoints } from '../protocol/dracoPoints.ts';

export async function loadDraco(): Promise<DracoPoints> {
    const response = await fetch(wasmUrl);
    if (!response.ok) throw new Error('The mesh decoder could not be loaded from the server.');
    const wasmBinary = await response.arrayBuffer();
    return new DracoPoints(await createDecoderModule({ wasmBinary }));
}
