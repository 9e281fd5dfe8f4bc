// A KEY and what follows it, by chance, with the state after each update.
import { seededRandom } from './random.ts';
import { Dice, randomStep } from './randomSurface.ts';
import { emptyState, type PlainState, writeUpdate } from './wireWriter.ts';

export interface Update {
    frames: Uint8Array[];
    state: PlainState;
}

export const lattice = { origin: [10, -2, 5] as [number, number, number], step: 0.25, bits: 12 };

/** `stillness`: vertices that are there do not move. */
export function randomUpdates(seed: number, count: number, stillness = false): Update[] {
    const dice = new Dice(seededRandom(seed));
    const all: Update[] = [];
    let state = emptyState();
    for (let seq = 0; seq < count; ++seq) {
        const step = randomStep(state, dice, seq, seq === 0 || dice.oneIn(40));
        if (stillness) step.edit.movedVertices.fill(false);
        all.push(writeUpdate(step.options.key ? emptyState() : state, step.edit, step.wanted, step.options));
        ({ state } = all.at(-1)!);
    }
    return all;
}
