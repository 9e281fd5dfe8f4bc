// Writes frames as protocol/wire/README.md has them, slowly and plainly: every list is searched, every number is a BigInt or
// small. Shares no code with the reader but the byte counts, so that each checks the other.
import { crc32c } from '../crc32c.ts';
import { frameCrcAt, frameHeaderBytes } from '../meshFrame.ts';
import { type PlainKept, writeCells } from './cellsWriter.ts';

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
    baseSeq: number;
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
 * The frames from `before` to about `wanted`, and the state that a reader must have after them: `wanted` to within the
 * tolerances that chance chose. `wanted.changes` are looked at for a KEY with history only.
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
    const blocks: { bytes: number[]; count: number }[] = [];
    const code = (kind: number, all: number[]): void => {
        for (let at = 0; at < all.length;) {
            const count = Math.min(all.length - at, 1 + (random() % 60));
            const channels = kind === 2 ? 1 : 1 + options.ranges.length;
            const predictors = Array.from({ length: channels }, () => (kind === 2 ? 0 : random() % [6, 8][kind]!));
            const tolerances = Array.from({ length: channels }, () => (kind === 2 || random() % 2 ? 0 : random() % 5));
            const residuals = all.slice(at, at + count).map((v) => {
                const components = kind === 2 ? 3 : 3 + options.ranges.length;
                return Array.from({ length: components }, (_, i) => {
                    const channel = Math.max(0, i - 2);
                    const step = 2 * tolerances[channel]! + 1;
                    if (kind === 2) {
                        const expected = meanChange(near[v]!, state.changes, i);
                        state.changes[v] ??= [0, 0, 0];
                        state.changes[v][i] = wanted.changes[v]![i]!;
                        return wanted.changes[v]![i]! - expected;
                    }
                    const goal = i < 3 ? wanted.positions[v]![i]! : wanted.codes[v]![i - 3]!;
                    const expected = predicted(kind, predictors[channel]!, v, i, near, x, old);
                    const residual = Math.round((goal - expected) / step);
                    x[v] ??= [];
                    x[v][i] = Math.min(last[i]!, Math.max(0, expected + residual * step));
                    return residual;
                });
            });
            blocks.push({ bytes: writeBlock(kind, predictors, tolerances, residuals, random), count });
            at += count;
        }
    };
    code(
        0,
        stay.flatMap((_, v) => (edit.movedVertices[v] ? [v] : [])),
    );
    code(
        1,
        Array.from({ length: edit.addedVertices }, (_, i) => stay.length + i),
    );
    for (let v = 0; v < x.length; ++v) {
        if (v < stay.length) state.changes.push([0, 1, 2].map((k) => x[v]![k]! - old.x[v]![k]!));
        else state.changes.push([0, 1, 2].map((k) => meanChange(near[v]!, state.changes, k)));
    }
    if (options.history) {
        state.changes = [];
        code(
            2,
            x.map((_, v) => v),
        );
    }
    state.positions = x.map((values) => values.slice(0, 3));
    state.codes = x.map((values) => values.slice(3));
    return { frames: pack(topology, blocks, state, options), state };
}

function writeBlock(
    kind: number,
    predictors: number[],
    tolerances: number[],
    residuals: number[][],
    random: () => number,
): number[] {
    const channels = predictors.map((_, c) => (c === 0 ? [0, 1, 2] : [c + 2]));
    const escaped = residuals.map((values) => values.some((r) => Math.abs(r) > 4000) || random() % 40 === 0);
    const coded = channels.map((parts) => residuals.some((r, v) => !escaped[v] && parts.some((i) => r[i] !== 0)));
    const bytes = [kind, ...varint(residuals.length), coded.reduce((bits, is, c) => bits | (is ? 1 << c : 0), 0)];
    bytes.push(...predictors);
    if (kind !== 2) bytes.push(...tolerances.flatMap(varint));
    const all = escaped.flatMap((is, v) => (is ? [v] : []));
    bytes.push(...varint(all.length));
    all.forEach((v, i) => {
        bytes.push(...varint(i === 0 ? v : v - all[i - 1]! - 1), ...residuals[v]!.flatMap(signed));
    });
    const kept = residuals.map((values, v) => (escaped[v] ? values.map(() => 0) : values));
    const draco = coded.includes(true)
        ? dracoBlock(
              kept,
              channels.filter((_, c) => coded[c]),
          )
        : [];
    bytes.push(...varint(draco.length));
    return bytes.concat(draco);
}

/** With the values as they are: entropy coding is what golden files are for. */
function dracoBlock(residuals: number[][], channels: number[][]): number[] {
    const count = [0, 8, 16, 24].map((shift) => (residuals.length >>> shift) & 0xff);
    const start = [...'DRACO'].map((letter) => letter.charCodeAt(0));
    const attributes = channels.flatMap((parts, i) => [4, 5, parts.length, 0, i]);
    const values = channels.flatMap((parts) => {
        const symbols = Uint32Array.from(residuals.flatMap((r) => parts.map((i) => (r[i]! << 1) ^ (r[i]! >> 31))));
        return [0xfe, 0, 4, ...new Uint8Array(symbols.buffer)]; // no prediction, no compression, bytes a value
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

function signed(value: number): number[] {
    return varint(((value << 1) ^ (value >> 31)) >>> 0);
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
    return [...varint(pairs.length), ...pairs.flat().flatMap(varint)];
}

function writeTopology(edit: PlainEdit, cells: number[][], before: PlainState): number[] {
    const stay = before.cells.length - edit.removedCells.filter(Boolean).length;
    const changed = cells.filter((_, i) => i >= stay || edit.replacedCells[i]);
    const kept = keptOf(edit, before);
    return [
        ...runs(edit.removedVertices),
        ...varint(edit.addedVertices),
        ...runs(edit.movedVertices),
        ...runs(edit.removedCells),
        ...runs(edit.replacedCells),
        ...varint(cells.length - stay),
        ...writeCells(changed, kept, kept.stay + edit.addedVertices),
    ];
}

function keptOf(edit: PlainEdit, before: PlainState): PlainKept {
    const stays = before.positions.flatMap((_, v) => (edit.removedVertices[v] ? [] : [v]));
    const now = before.positions.map((_, v) => stays.indexOf(v));
    const renumbered = before.cells.map((cell) => cell.map((id) => (id === none ? none : now[id]!)));
    const cells = renumbered.filter((_, i) => !edit.removedCells[i]);
    const lost = before.cells.map((cell, i) => cell.some((id, k) => id !== renumbered[i]![k] && renumbered[i]![k] === none));
    const touching = [
        ...renumbered.filter((_, i) => edit.removedCells[i] || lost[i]),
        ...cells.filter((_, i) => edit.replacedCells[i]),
    ];
    const touched = new Set(touching.flat().filter((id) => id !== none));
    return { cells, replaced: cells.map((_, i) => edit.replacedCells[i] ?? false), touched, stay: stays.length };
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

function meanChange({ a, b }: Near, changes: number[][], k: number): number {
    return a === none ? 0 : Math.floor((changes[a]![k]! + changes[b]![k]!) / 2);
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
        const usable = a === none ? 0 : predictor === 5 && o === none ? 2 : predictor;
        const changes = [
            () => h(v),
            () => d(a),
            () => half(d(a) + d(b)),
            () => h(v) + d(a) - h(a),
            () => h(v) + half(d(a) - h(a) + d(b) - h(b)),
            () => d(p) + d(n) - d(o),
        ];
        return old.x[v]![i]! + changes[usable]!();
    }
    const at = (id: number): number => x[id]![i]!;
    const bb = b === none ? none : near[b]!.b;
    const ba = a === none ? none : near[a]!.b;
    const bba = ba === none ? none : near[ba]!.b;
    const aa = a === none ? none : near[a]!.a;
    const additions: (() => number)[] = [
        () => (a !== none ? at(a) : v > 0 ? at(v - 1) : 0),
        () => (b !== none ? at(b) : additions[0]!()),
        () => (aa !== none ? 2 * at(a) - at(aa) : additions[0]!()),
        () => (bb !== none ? 2 * at(b) - at(bb) : additions[1]!()),
        () => (p === none ? additions[2]!() : o === none ? half(at(p) + at(n)) : at(p) + at(n) - at(o)),
        () => (bb !== none && bba !== none ? 2 * at(b) - at(bb) + at(a) - 2 * at(ba) + at(bba) : additions[4]!()),
        () => (a !== none ? half(at(a) + at(b)) : additions[0]!()),
        () => (b !== none && b < old.x.length ? old.x[b]![i]! : additions[1]!()),
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

export function stateSumOf(state: PlainState): number {
    const attributes = (state.codes[0] ?? []).map((_, i) => {
        return sumOf(state.codes.map((values) => values[i]!));
    });
    const { positions, cells } = state;
    return sumOf([positions.length, sumOf(positions.flat()), cells.length, sumOf(cells.flat()), ...attributes]);
}

function pack(
    topology: number[],
    blocks: { bytes: number[]; count: number }[],
    state: PlainState,
    options: WriteOptions,
): Uint8Array[] {
    const parts: { topology: number[]; points: number[] }[] = [];
    const cut = options.random() % 3 === 0 ? 1 + (options.random() % topology.length) : topology.length;
    for (let at = 0; at < topology.length; at += cut) parts.push({ topology: topology.slice(at, at + cut), points: [] });
    for (const { bytes } of blocks) {
        if (options.random() % 4 === 0) parts.push({ topology: [], points: [] });
        parts.at(-1)!.points.push(...bytes);
    }
    return parts.map((part, index) => {
        const ranges = options.key && index === 0 ? options.ranges : [];
        const body = frameHeaderBytes + 8 * ranges.length;
        const bytes = new Uint8Array(body + part.topology.length + part.points.length);
        const view = new DataView(bytes.buffer);
        view.setUint16(0, 0x5357, true);
        view.setUint8(2, 3);
        view.setUint8(3, (options.key ? 1 : 0) | (options.history ? 4 : 0));
        const { surface, epoch, seq, baseSeq } = options;
        [surface, epoch, seq, baseSeq].forEach((value, i) => view.setUint32(4 + 4 * i, value, true));
        view.setUint16(20, index, true);
        view.setUint16(22, parts.length, true);
        view.setUint8(24, options.phase);
        view.setUint8(25, options.latticeBits);
        view.setUint8(26, options.ranges.length);
        view.setUint32(28, state.positions.length, true);
        view.setUint32(32, state.cells.length, true);
        view.setUint32(36, topology.length, true);
        view.setFloat64(40, options.time, true);
        view.setUint32(48, part.topology.length, true);
        view.setUint32(52, part.points.length, true);
        view.setUint32(56, stateSumOf(state), true);
        ranges.flat().forEach((value, i) => view.setFloat32(frameHeaderBytes + 4 * i, value, true));
        bytes.set(part.topology, body);
        bytes.set(part.points, body + part.topology.length);
        return sealed(bytes);
    });
}

/** With the checksum made right again. */
export function sealed(bytes: Uint8Array): Uint8Array {
    const crc = crc32c(bytes.subarray(frameHeaderBytes), crc32c(bytes.subarray(0, frameCrcAt)));
    new DataView(bytes.buffer, bytes.byteOffset).setUint32(frameCrcAt, crc, true);
    return bytes;
}
