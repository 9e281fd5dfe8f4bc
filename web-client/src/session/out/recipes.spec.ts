import { crc32 } from 'node:zlib';
import { describe, expect, it } from 'vitest';
import { signal } from '@preact/signals-core';
import type { DisplayedSurface } from '../../state/appState.ts';
import { addressWith, pngWith, type RecipeSource, shownRecipes } from './recipes.ts';

/** The least PNG: one grey pixel. */
const pixel = 'iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==';

const bytesOf = (base64: string): Uint8Array<ArrayBuffer> => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

function chunks(file: Uint8Array): { type: string; data: string; sound: boolean }[] {
    const view = new DataView(file.buffer);
    const out = [];
    for (let at = 8; at < file.length;) {
        const length = view.getUint32(at);
        const body = file.subarray(at + 4, at + 8 + length);
        const text = String.fromCharCode(...body);
        out.push({ type: text.slice(0, 4), data: text.slice(4), sound: crc32(body) === view.getUint32(at + 8 + length) });
        at += 12 + length;
    }
    return out;
}

function source(answers: Record<string, { recipe: string; stateSum: number } | null>, hidden: string[] = []): RecipeSource {
    const displayed = new Map(Object.keys(answers).map((surface) => [surface, { surface, stateSum: 7 } as DisplayedSurface]));
    return {
        state: { displayed: signal(displayed), hiddenSurfaces: signal(new Set(hidden)) },
        worker: {
            call: (_method: string, { surface }: { surface: string }) =>
                answers[surface] === null ? Promise.reject(new Error('not final')) : Promise.resolve(answers[surface]),
        },
    } as unknown as RecipeSource;
}

describe('recipes', () => {
    it('are those of the final surfaces on the screen, as they are shown', async () => {
        const answers = {
            s1: { recipe: 'one', stateSum: 7 },
            s2: { recipe: 'of a later state', stateSum: 8 },
            s3: null,
            s4: { recipe: 'hidden', stateSum: 7 },
            s5: { recipe: 'five', stateSum: 7 },
        };
        expect(await shownRecipes(source(answers, ['s4']))).toEqual(['one', 'five']);
    });

    it('stand in a PNG as a text that readers of PNG take', async () => {
        const recipes = ['wakesurf-recipe:a.', 'wakesurf-recipe:bc.'];
        const file = pngWith(recipes, new Blob([bytesOf(pixel)], { type: 'image/png' }));
        const found = chunks(new Uint8Array(await file.arrayBuffer()));
        expect(file.type).toBe('image/png');
        expect(found.map(({ type }) => type)).toEqual(['IHDR', 'tEXt', 'IDAT', 'IEND']);
        expect(found.every(({ sound }) => sound)).toBe(true);
        expect(found[1]!.data.trimEnd()).toBe('wakesurf\0wakesurf-recipe:a.\nwakesurf-recipe:bc.');
    });

    it('stand in the address of a PNG as in its file', async () => {
        for (const recipes of [[], ['a.'], ['ab.'], ['abc.', 'd.']]) {
            const file = pngWith(recipes, new Blob([bytesOf(pixel)], { type: 'image/png' }));
            const address = addressWith(recipes, `data:image/png;base64,${pixel}`);
            expect(bytesOf(address.slice(address.indexOf(',') + 1))).toEqual(new Uint8Array(await file.arrayBuffer()));
        }
    });
});
