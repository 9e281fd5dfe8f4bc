// Recipes: what the surfaces of a picture were made from, as the server tells it, and their place in the file of the picture. From them
// `wakesurf verify` makes the surfaces again.
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export interface RecipeSource {
    state: Pick<AppState, 'displayed' | 'hiddenSurfaces'>;
    worker: Pick<WorkerClient, 'call'>;
}

/** Returns those of the surfaces that are on the screen now in their final state. */
export async function shownRecipes({ state, worker }: RecipeSource): Promise<string[]> {
    const shown = [...state.displayed.value.values()].filter(({ surface }) => !state.hiddenSurfaces.value.has(surface));
    const told = await Promise.all(
        shown.map(async ({ surface, stateSum }) => {
            // One that is not final has none.
            const answer = await worker.call('surface.recipe', { surface }).catch(() => null);
            return answer?.stateSum === stateSum ? answer.recipe : '';
        }),
    );
    return told.filter((recipe) => recipe !== '');
}

/** The checksum of PNG's chunks. */
function crc32(bytes: Uint8Array): number {
    let crc = -1;
    for (const byte of bytes) {
        crc ^= byte;
        for (let bit = 0; bit < 8; ++bit) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
    }
    return ~crc >>> 0;
}

const headerBytes = 33;

/** One text of a PNG, for behind its header; a multiple of three bytes. */
function textChunk(recipes: readonly string[]): Uint8Array<ArrayBuffer> {
    const text = `wakesurf\0${recipes.join('\n')}`;
    const chunk = new TextEncoder().encode(`....tEXt${text.padEnd(3 * Math.ceil(text.length / 3))}....`);
    const numbers = new DataView(chunk.buffer);
    numbers.setUint32(0, chunk.length - 12);
    numbers.setUint32(chunk.length - 4, crc32(chunk.subarray(4, -4)));
    return chunk;
}

/** Returns the PNG with the recipes in it. */
export function pngWith(recipes: readonly string[], png: Blob): Blob {
    if (recipes.length === 0) return png;
    return new Blob([png.slice(0, headerBytes), textChunk(recipes), png.slice(headerBytes)], { type: png.type });
}

/** The same of a PNG as an address of data: three bytes of it are four letters, so the picture stays as it is. */
export function addressWith(recipes: readonly string[], address: string): string {
    if (recipes.length === 0) return address;
    const place = address.indexOf(',') + 1 + (headerBytes / 3) * 4;
    const letters = Array.from(textChunk(recipes), (byte) => String.fromCharCode(byte)).join('');
    return address.slice(0, place) + btoa(letters) + address.slice(place);
}
