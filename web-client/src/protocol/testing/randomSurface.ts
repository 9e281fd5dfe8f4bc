// Surfaces that change by chance, the same on every run: worse than any real one, so that every branch of the wire is taken.
import { emptyState, type PlainEdit, type PlainState, type WriteOptions, writeUpdate } from './wireWriter.ts';

/** Numbers in 0 .. 2^32 - 1 (xorshift32). */
export function seededRandom(seed: number): () => number {
    let state = seed;
    return () => {
        state ^= state << 13;
        state ^= state >>> 17;
        state ^= state << 5;
        return state >>> 0;
    };
}

export const ranges: [number, number][] = [
    [-1, 3],
    [0, 1],
    [2, 2],
];

const none = -1;

/** Chance with words for it. */
export class Dice {
    readonly random: () => number;

    constructor(random: () => number) {
        this.random = random;
    }

    below(limit: number): number {
        return this.random() % limit;
    }

    oneIn(n: number): boolean {
        return this.below(n) === 0;
    }
}

export interface Step {
    edit: PlainEdit;
    wanted: PlainState;
    options: WriteOptions;
}

/** Returns what comes after `before`; a KEY starts from nothing. */
export function randomStep(before: PlainState, dice: Dice, seq: number, key: boolean): Step {
    const from = key ? emptyState() : before;
    const edit = randomEdit(from, dice);
    const wanted = applied(from, edit, dice);
    const options = {
        ...{ surface: 3, epoch: 1, seq, key, history: dice.oneIn(key ? 2 : 9) },
        ...{ latticeBits: 12, ranges, time: seq / 8, phase: dice.below(4), random: dice.random },
    };
    return { edit, wanted, options };
}

function randomEdit(from: PlainState, dice: Dice): PlainEdit {
    const flags = (count: number, n: number): boolean[] => Array.from({ length: count }, () => n > 0 && dice.oneIn(n));
    const rarely = dice.oneIn(3) ? 6 : 0;
    const removedVertices = flags(from.positions.length, rarely);
    // A cell must go when a corner of it goes, or else be replaced; a mid that goes is freed.
    const needy = (cell: number[]): boolean => cell.slice(0, 4).some((id) => removedVertices[id]);
    const removedCells = from.cells.map((cell) => (needy(cell) ? !dice.oneIn(4) : rarely > 0 && dice.oneIn(9)));
    const stay = from.cells.filter((_, i) => !removedCells[i]);
    const replacedCells = stay.map((cell) => needy(cell) || (rarely > 0 && dice.oneIn(9)));
    const vertices = removedVertices.filter((gone) => !gone).length;
    const movedVertices = dice.oneIn(3) ? flags(vertices, 4) : flags(vertices, 1);
    const addedVertices = vertices < 8 ? 30 : dice.oneIn(2) ? dice.below(20) : 0;
    return { removedVertices, movedVertices, removedCells, replacedCells, addedVertices };
}

function applied(from: PlainState, edit: PlainEdit, dice: Dice): PlainState {
    const now: number[] = [];
    let next = 0;
    from.positions.forEach((_, v) => now.push(edit.removedVertices[v] ? none : next++));
    const vertices = next + edit.addedVertices;
    const stays = (_: unknown, v: number): boolean => !edit.removedVertices[v];
    const wander = (value: number, last: number, far: number): number =>
        Math.min(last, Math.max(0, value + dice.below(2 * far + 1) - far));
    const far = dice.oneIn(10) ? 4095 : 6;
    const moved = (values: number[], v: number, last: number): number[] =>
        edit.movedVertices[v] ? values.map((value) => wander(value, last, far)) : values;
    const positions = from.positions.filter(stays).map((values, v) => moved(values, v, 4095));
    const codes = from.codes.filter(stays).map((values, v) => moved(values, v, 65535));
    while (positions.length < vertices) {
        positions.push((positions.at(-1) ?? [9, 2000, 4095]).map((value) => wander(value, 4095, 40)));
        codes.push((codes.at(-1) ?? [0, 30_000, 65_535]).map((value) => wander(value, 65_535, 40)));
    }
    const changes = positions.map(() => [0, 1, 2].map(() => dice.below(2001) - 1000));
    const cells = from.cells
        .filter((_, i) => !edit.removedCells[i])
        .map((cell, i) =>
            edit.replacedCells[i] ? randomCell(vertices, dice) : cell.map((id) => (id === none ? none : now[id]!)),
        );
    const added = vertices === 0 ? 0 : dice.below(1 + edit.addedVertices);
    for (let i = 0; i < added; ++i) cells.push(randomCell(vertices, dice));
    return { positions, codes, changes, cells };
}

/** Mostly of vertices that are near each other by number, as in a sheet. */
function randomCell(vertices: number, dice: Dice): number[] {
    const base = dice.below(vertices);
    const near = (offset: number): number => (base + offset + (dice.oneIn(5) ? dice.below(7) : 0)) % vertices;
    const mid = (): number => (dice.oneIn(4) ? dice.below(vertices) : none);
    return [near(0), near(6), near(7), near(1), mid(), mid(), mid(), mid()];
}

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
