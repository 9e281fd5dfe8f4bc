// Writes frames as protocol/wire/FORMAT.md has them, slowly and plainly: every list is searched, every number
// is a BigInt or small. Shares no code with the reader but the byte counts, so that each checks the other.
import { deflateRawSync } from 'node:zlib';
import { crc32, frameCrcAt, frameHeaderBytes } from '../meshFrame.ts';

export interface PlainState {
    positions: number[][];
    codes: number[][]; // by vertex, one an attribute
    changes: number[][];
    cells: number[][]; // 8 ids, -1 where there is none
}

export interface PlainEdit {
    removedVertices: boolean[]; // by old vertex
    movedVertices: boolean[]; // by vertex that stays
    removedCells: boolean[]; // by old cell
    replacedCells: boolean[]; // by cell that stays
    addedVertices: number;
}

export interface WriteOptions {
    surface: number;
    epoch: number;
    seq: number;
    key: boolean;
    history: boolean;
    latticeBits: number;
    ranges: [number, number][];
    time: number;
    phase: number;
    random: () => number;
}

const none = -1;

export function emptyState(): PlainState {
    return { positions: [], codes: [], changes: [], cells: [] };
}

/**
 * The frames from `before` to about `wanted`, and the state that a reader must have after them: `wanted` to
 * within the tolerances that chance chose. `wanted.changes` are looked at with `history` only.
 */
export function writeUpdate(
    before: PlainState,
    edit: PlainEdit,
    wanted: PlainState,
    options: WriteOptions,
): { frames: Uint8Array[]; state: PlainState } {
    const { random } = options;
    const stay = before.positions.flatMap((_, v) => (edit.removedVertices[v] ? [] : [v]));
    const topology = writeTopology(edit, wanted.cells, before);
    const near = neighboursOf(wanted.cells, wanted.positions.length);
    const old = {
        x: stay.map((v) => [...before.positions[v]!, ...before.codes[v]!]),
        h: stay.map((v) => before.changes[v]!),
    };
    const state: PlainState = { ...emptyState(), cells: wanted.cells };
    const x = old.x.map((values) => [...values]);
    const last = [...Array<number>(3).fill(2 ** options.latticeBits - 1), ...options.ranges.map(() => 65535)];
    const blocks: Block[] = [];
    const code = (kind: number, all: number[]): void => {
        for (let at = 0; at < all.length;) {
            const count = Math.min(all.length - at, 1 + (random() % 60));
            const coded = 1 + options.ranges.length;
            const predictors = Array.from({ length: coded }, () => random() % [4, 6][kind]!);
            const tolerances = Array.from({ length: coded }, () => (random() % 2 ? 0 : random() % 5));
            const residuals = all.slice(at, at + count).map((v) => {
                const values = Array.from({ length: 3 + options.ranges.length }, (_, i) => {
                    const channel = Math.max(0, i - 2);
                    const step = 2 * tolerances[channel]! + 1;
                    const goal = i < 3 ? wanted.positions[v]![i]! : wanted.codes[v]![i - 3]!;
                    const expected = predicted(kind, predictors[channel]!, v, i, near, x, old);
                    const residual = Math.round((goal - expected) / step);
                    x[v] ??= [];
                    x[v][i] = Math.min(last[i]!, Math.max(0, expected + residual * step));
                    return residual;
                });
                if (kind === 0) {
                    state.changes[v] = [0, 1, 2].map((k) => x[v]![k]! - old.x[v]![k]!);
                    return values;
                }
                const changes = [0, 1, 2].map((k) => meanChange(near[v]!, state.changes, v, k));
                state.changes[v] = options.history ? wanted.changes[v]! : changes;
                return [...values, ...state.changes[v].map((change, k) => change - changes[k]!)];
            });
            blocks.push(writeBlock(kind, predictors, tolerances, residuals, random));
            at += count;
        }
    };
    stay.forEach((_, v) => (state.changes[v] = [0, 0, 0]));
    code(
        0,
        stay.flatMap((_, v) => (edit.movedVertices[v] ? [v] : [])),
    );
    code(
        1,
        Array.from({ length: edit.addedVertices }, (_, i) => stay.length + i),
    );
    state.positions = x.map((values) => values.slice(0, 3));
    state.codes = x.map((values) => values.slice(3));
    return { frames: pack([...rangesOf(options), ...topology], blocks, state, options), state };
}

interface Block {
    numbers: number[];
    draco: number[];
    count: number;
}

function rangesOf({ key, ranges }: WriteOptions): number[] {
    return key ? [...new Uint32Array(Float64Array.from(ranges.flat()).buffer)] : [];
}

function writeBlock(
    kind: number,
    predictors: number[],
    tolerances: number[],
    residuals: number[][],
    random: () => number,
): Block {
    const channels = predictors.map((_, c) => (c === 0 ? [0, 1, 2] : [c + 2]));
    const behind = predictors.length + 2;
    if (kind === 1) channels.push([behind, behind + 1, behind + 2]);
    const escaped = residuals.map((values) => values.some((r) => Math.abs(r) > 4000) || random() % 40 === 0);
    const coded = channels.map((parts) => residuals.some((r, v) => !escaped[v] && parts.some((i) => r[i] !== 0)));
    const numbers = [residuals.length, coded.reduce((bits, is, c) => bits | (is ? 1 << c : 0), 0)];
    predictors.forEach((predictor, c) => numbers.push(predictor, tolerances[c]!));
    const all = escaped.flatMap((is, v) => (is ? [v] : []));
    numbers.push(all.length);
    all.forEach((v, i) => numbers.push(i === 0 ? v : v - all[i - 1]! - 1, ...residuals[v]!.map(zigzag)));
    const kept = residuals.map((values, v) => (escaped[v] ? values.map(() => 0) : values));
    if (!coded.includes(true)) return { numbers, draco: [], count: residuals.length };
    const draco = dracoBlock(
        kept,
        channels.filter((_, c) => coded[c]),
    );
    return { numbers: [...numbers, draco.length], draco, count: residuals.length };
}

/** With the values as they are: entropy coding is what golden files are for. */
function dracoBlock(residuals: number[][], channels: number[][]): number[] {
    const count = [0, 8, 16, 24].map((shift) => (residuals.length >>> shift) & 0xff);
    const start = [...'DRACO'].map((letter) => letter.charCodeAt(0));
    const attributes = channels.flatMap((parts, i) => [4, 5, parts.length, 0, i]);
    const values = channels.flatMap((parts) => {
        const symbols = Uint32Array.from(residuals.flatMap((r) => parts.map((i) => (r[i]! << 1) ^ (r[i]! >> 31))));
        // No prediction, no compression, bytes a value.
        return [0xfe, 0, 4, ...new Uint8Array(symbols.buffer)];
    });
    const coding = channels.map(() => 1);
    return [...start, 2, 3, 0, 0, 0, 0, ...count, 1, channels.length, ...attributes, ...coding, ...values];
}

function varint(value: number): number[] {
    const bytes: number[] = [];
    let rest = value >>> 0;
    for (; rest >= 0x80; rest >>>= 7) bytes.push((rest & 0x7f) | 0x80);
    return [...bytes, rest];
}

function zigzag(value: number): number {
    return ((value << 1) ^ (value >> 31)) >>> 0;
}

function runs(flags: boolean[]): number[] {
    const pairs: number[][] = [];
    for (let at = 0, end = 0; at < flags.length; at = end) {
        const begin = flags.indexOf(true, at);
        if (begin < 0) break;
        end = flags.indexOf(false, begin);
        end = end < 0 ? flags.length : end;
        pairs.push([begin - at, end - begin]);
    }
    return [pairs.length, ...pairs.flat()];
}

function writeTopology(edit: PlainEdit, cells: number[][], before: PlainState): number[] {
    const stays = before.positions.flatMap((_, v) => (edit.removedVertices[v] ? [] : [v]));
    const now = (id: number): number => (id === none ? none : stays.indexOf(id));
    const kept = before.cells.filter((_, i) => !edit.removedCells[i]).map((cell) => cell.map(now));
    const replaced = kept.flatMap((old, i) => (edit.replacedCells[i] ? [{ cell: cells[i]!, old }] : []));
    const added = cells.slice(kept.length).map((cell) => ({ cell, old: Array<number>(8).fill(none) }));
    return [
        ...runs(edit.removedVertices),
        edit.addedVertices,
        ...runs(edit.movedVertices),
        ...runs(edit.removedCells),
        ...runs(edit.replacedCells),
        added.length,
        ...writeCells([...replaced, ...added], stays.length),
    ];
}

function writeCells(all: { cell: number[]; old: number[] }[], stay: number): number[] {
    const numbers = all.map(({ cell }) => [4, 5, 6, 7].reduce((bits, slot, i) => bits | (cell[slot] === none ? 0 : 1 << i), 0));
    for (let slot = 0; slot < 8; ++slot) {
        all.forEach(({ cell, old }, i) => {
            if (cell[slot] === none) return;
            const before = all.slice(0, i).findLast((other) => other.old[slot] === none)?.cell[slot] ?? stay;
            const near = [before, before, cell[1]!, cell[0]!, ...cell];
            numbers.push(zigzag(cell[slot]! - (old[slot] === none ? near[slot]! : old[slot]!)));
        });
    }
    return numbers;
}

interface Near {
    a: number;
    b: number;
    p: number;
    n: number;
    o: number;
}

/** Collected first, chosen from afterwards, as the definition reads. */
function neighboursOf(cells: number[][], vertices: number): Near[] {
    const below: number[][] = Array.from({ length: vertices }, () => []);
    const corners: Near[] = [];
    const hanging: Near[] = [];
    for (const cell of cells) {
        const outline = [0, 1, 2, 3].flatMap((i) => [cell[i]!, cell[4 + i]!]).filter((id) => id !== none);
        outline.forEach((id, i) => {
            const after = outline[(i + 1) % outline.length]!;
            if (id !== after) below[Math.max(id, after)]!.push(Math.min(id, after));
        });
        for (const i of [0, 1, 2, 3]) {
            const [v, mid] = [cell[i]!, cell[4 + i]!];
            const [p, n, o] = [cell[(i + 3) % 4]!, cell[(i + 1) % 4]!, cell[(i + 2) % 4]!];
            if (p < v && n < v && o < v) corners[v] ??= { a: 0, b: 0, p, n, o };
            if (mid !== none && v < mid && n < mid) hanging[mid] ??= { a: 0, b: 0, p: v, n, o: none };
        }
    }
    return below.map((ids, v) => {
        const ends = ids.length === 0 ? { a: none, b: none } : { a: Math.max(...ids), b: Math.min(...ids) };
        return { ...(hanging[v] ?? corners[v] ?? { p: none, n: none, o: none }), ...ends };
    });
}

function meanChange({ a, b }: Near, changes: number[][], v: number, k: number): number {
    if (a === none) return v === 0 ? 0 : changes[v - 1]![k]!;
    return Math.floor((changes[a]![k]! + changes[b]![k]!) / 2);
}

function predicted(
    kind: number,
    predictor: number,
    v: number,
    i: number,
    near: Near[],
    x: number[][],
    old: { x: number[][]; h: number[][] },
): number {
    const { a, b, p, n, o } = near[v]!;
    const half = (value: number): number => Math.floor(value / 2);
    if (kind === 0) {
        const d = (id: number): number => x[id]![i]! - old.x[id]![i]!;
        const h = (id: number): number => (i < 3 ? old.h[id]![i]! : 0);
        const usable = a === none ? 0 : predictor === 3 && o === none ? 1 : predictor;
        const changes = [
            () => h(v),
            () => half(d(a) + d(b)),
            () => h(v) + half(d(a) - h(a) + d(b) - h(b)),
            () => d(p) + d(n) - d(o),
        ];
        return old.x[v]![i]! + changes[usable]!();
    }
    const at = (id: number): number => x[id]![i]!;
    const aa = a === none ? none : near[a]!.a;
    const additions: (() => number)[] = [
        () => (a !== none ? at(a) : v > 0 ? at(v - 1) : 0),
        () => at(b),
        () => (aa !== none ? 2 * at(a) - at(aa) : additions[0]!()),
        () => (p === none ? additions[0]!() : o === none ? half(at(p) + at(n)) : at(p) + at(n) - at(o)),
        () => half(at(a) + at(b)),
        () => (b < old.x.length ? old.x[b]![i]! : additions[0]!()),
    ];
    // Even of a corner of a cell with lower ones, where only mids are beside it.
    return a === none ? additions[0]!() : additions[predictor]!();
}

function sumOf(words: number[]): number {
    const wrap = (value: bigint): bigint => BigInt.asUintN(32, value);
    const lanes = [0, 1, 2, 3].map((lane) => words.filter((_, i) => i % 4 === lane).map((word) => BigInt(word >>> 0)));
    const stir = (sum: bigint, word: bigint): bigint => {
        const mixed = sum ^ wrap(word);
        return wrap(wrap((mixed << 13n) | (mixed >> 19n)) * 0x9e3779b1n);
    };
    let h = BigInt(words.length);
    for (const lane of lanes) {
        h = stir(
            h,
            lane.reduce((sum, word) => sum + word, 0n),
        );
        h = stir(
            h,
            lane.reduce((sum, word, i) => sum + word * BigInt(lane.length - i), 0n),
        );
    }
    return Number(h ^ (h >> 15n));
}

function stateSumOf(state: PlainState): number {
    const attributes = (state.codes[0] ?? []).map((_, i) => {
        return sumOf(state.codes.map((values) => values[i]!));
    });
    const { positions, cells } = state;
    return sumOf([positions.length, sumOf(positions.flat()), cells.length, sumOf(cells.flat()), ...attributes]);
}

function pack(head: number[], blocks: Block[], state: PlainState, options: WriteOptions): Uint8Array[] {
    const { random, surface, epoch, seq } = options;
    const numbers = Uint8Array.from([...head, ...blocks.flatMap((block) => block.numbers)].flatMap(varint));
    const packed = [...deflateRawSync(numbers, { level: random() % 10 })];
    const update = [...varint(packed.length), ...varint(numbers.length), ...packed, ...blocks.flatMap(({ draco }) => draco)];
    const frames = 1 + (random() % 4);
    const cuts = Array.from({ length: frames - 1 }, () => random() % update.length).sort((a, b) => a - b);
    return [...cuts, update.length].map((end, index) => {
        const body = update.slice(cuts[index - 1] ?? 0, end);
        const bytes = new Uint8Array(frameHeaderBytes + body.length);
        const view = new DataView(bytes.buffer);
        view.setUint16(0, 0x5357, true);
        view.setUint8(2, 5);
        view.setUint8(3, options.key ? 1 : 0);
        [surface, epoch, seq].forEach((value, i) => view.setUint32(4 + 4 * i, value, true));
        view.setUint16(16, index, true);
        view.setUint16(18, frames, true);
        view.setUint8(20, options.phase);
        view.setUint8(21, options.latticeBits);
        view.setUint8(22, options.ranges.length);
        view.setUint32(24, state.positions.length, true);
        view.setUint32(28, state.cells.length, true);
        view.setFloat64(32, options.time, true);
        view.setUint32(40, stateSumOf(state), true);
        bytes.set(body, frameHeaderBytes);
        return sealed(bytes);
    });
}

/** With the checksum made right again. */
export function sealed(bytes: Uint8Array): Uint8Array {
    const crc = crc32(bytes.subarray(frameHeaderBytes), crc32(bytes.subarray(0, frameCrcAt)));
    new DataView(bytes.buffer, bytes.byteOffset).setUint32(frameCrcAt, crc, true);
    return bytes;
}
