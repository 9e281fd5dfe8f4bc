// What is expected of a cell's vertices, and how likely. protocol/wire/README.md, Cells code. Twin: protocol/wire/cell_model.hpp.
import { unzigzag } from './bytes.ts';
import { cellStride, noVertex } from './cell.ts';
import { FrameError } from './frameError.ts';
import type { OpenSides } from './openSides.ts';
import { AdaptiveBits, AdaptiveNumber, type RangeDecoder } from './rangeDecoder.ts';

/** Where a vertex was expected from. */
const along = 0;
const beside = 1;
const stride = 2;
const fresh = 3;
const old = 4;
const back = 5;
const gate = 6;
const explicit = 7;
const choices = 8;

const starts = [along, beside, stride, fresh];
const startsOfOld = [old];
const nexts = [old, back, gate, fresh, stride];

/** The slots of a cell's outline, in order, by which mids there are. */
const outlines = Array.from({ length: 16 }, (_, mids) =>
    [0, 1, 2, 3].flatMap((side) => ((mids >> side) & 1 ? [side, 4 + side] : [side])),
);

export class CellModel {
    private readonly vertices: number;
    private readonly open: OpenSides;
    private fresh: number; // above all vertices there have been
    private readonly last = new Int32Array(8); // the newest vertex in each slot
    private readonly stride = new Int32Array(8).fill(1);
    private lastMids = 0;
    private readonly choice = new Uint8Array(8); // by place in the outline, of the last cell that replaced none
    private choiceMids = 0;
    private lastStart = explicit;
    private repeatable = false; // all vertices of that cell were as expected
    private repeats = 0; // whether the cells before repeated, a bit each

    private readonly repeatBits = new AdaptiveBits(8);
    private readonly midBits = new AdaptiveBits(64);
    private readonly choiceBits = new AdaptiveBits(2 * 8 * choices * choices);
    private readonly numbers = [new AdaptiveNumber(), new AdaptiveNumber(), new AdaptiveNumber()] as const;

    // The outline of the cell that is being read.
    private slots: readonly number[] = outlines[0]!;
    private readonly outline = new Int32Array(16); // and what has been asked of the next vertex

    constructor(vertices: number, stay: number, open: OpenSides) {
        this.vertices = vertices;
        this.fresh = stay;
        this.open = open;
    }

    /** The next cell, into eight ids from `at` on; `replaces`: in place of the one that is there. Throws FrameError. */
    read(decoder: RangeDecoder, cells: Int32Array, at: number, replaces: boolean): void {
        if (replaces || !this.repeatable || !this.readRepeat(decoder)) this.readCell(decoder, cells, at, replaces);
        this.finish(cells, at);
    }

    private readRepeat(decoder: RangeDecoder): boolean {
        const repeats = decoder.bit(this.repeatBits, this.repeats & 7);
        this.repeats = (this.repeats << 1) | repeats;
        if (repeats === 0) return false;
        this.slots = outlines[this.choiceMids]!;
        for (let k = 0; k < this.slots.length; ++k) {
            this.outline[k] = this.checked(this.expected(this.choice[k]!, k, this.last, 0));
        }
        return true;
    }

    private readCell(decoder: RangeDecoder, cells: Int32Array, at: number, replaces: boolean): void {
        const mids = this.readMids(decoder, cells, at, replaces);
        this.slots = outlines[mids]!;
        let before = this.lastStart;
        let allExpected = true;
        for (let k = 0; k < this.slots.length; ++k) {
            before = this.readVertex(decoder, cells, at, replaces, k, before);
            allExpected &&= before !== explicit;
            if (replaces) continue;
            this.choice[k] = before;
            if (k === 0) this.lastStart = before;
        }
        if (!replaces) {
            this.choiceMids = mids;
            this.repeatable = allExpected;
        }
        this.lastMids = mids;
    }

    private readMids(decoder: RangeDecoder, cells: Int32Array, at: number, replaces: boolean): number {
        let mids = 0;
        for (let side = 0; side < 4; ++side) {
            const had = replaces && cells[at + 4 + side]! !== noVertex ? 4 : 0;
            const last = side !== 2 && ((this.lastMids >> side) & 1) !== 0 ? 2 : 0;
            const sideBefore = side > 0 ? (mids >> (side - 1)) & 1 : 0;
            mids |= decoder.bit(this.midBits, (replaces ? 32 : 0) + 8 * side + had + last + sideBefore) << side;
        }
        return mids;
    }

    /** Gives the choice; the vertex is in the outline. */
    private readVertex(
        decoder: RangeDecoder,
        cells: Int32Array,
        at: number,
        replaces: boolean,
        k: number,
        before: number,
    ): number {
        const slot = this.slots[k]!;
        const context = (((replaces ? 8 : 0) + slot) * choices + before) * choices;
        const inTurn = k > 0 ? nexts : replaces ? startsOfOld : starts;
        const { outline } = this;
        let asked = k;
        for (const choice of inTurn) {
            if ((choice === old && !replaces) || (choice === stride && slot >= 4)) continue;
            const v = this.expected(choice, k, cells, at);
            if (v < 0 || v >= this.vertices || this.isInOutline(v, asked)) continue;
            outline[asked] = v; // behind the outline so far: not asked again
            if (decoder.bit(this.choiceBits, context + choice) !== 0) {
                outline[k] = v;
                return choice;
            }
            ++asked;
        }
        const from = k === 0 ? this.last[0]! : slot >= 4 ? this.fresh : outline[k - 1]!;
        const number = this.numbers[k === 0 ? 0 : slot >= 4 ? 2 : 1];
        outline[k] = this.checked((from + unzigzag(number.read(decoder))) | 0);
        return explicit;
    }

    private isInOutline(v: number, count: number): boolean {
        for (let i = 0; i < count; ++i) if (this.outline[i] === v) return true;
        return false;
    }

    /** None of the vertices where nothing is expected. */
    private expected(choice: number, k: number, cells: Int32Array, at: number): number {
        const slot = this.slots[k]!;
        switch (choice) {
            case along:
                return this.last[3]!;
            case beside:
                return this.last[1]!;
            case stride:
                return (this.last[slot]! + this.stride[slot]!) | 0;
            case fresh:
                return this.fresh;
            case old:
                return cells[at + slot]!;
            case back: {
                let v = this.outline[0]!;
                for (let steps = this.slots.length - k; steps > 0 && v >= 0; --steps) v = this.open.before(v);
                return v;
            }
            case gate:
                return this.open.after(this.outline[k - 1]!);
            default:
                return noVertex;
        }
    }

    private checked(v: number): number {
        if (v < 0 || v >= this.vertices) throw new FrameError('a cell of a mesh frame uses a vertex that was not sent');
        return v;
    }

    private finish(cells: Int32Array, at: number): void {
        const { slots, outline, open, last } = this;
        cells.fill(noVertex, at, at + cellStride);
        for (let k = 0; k < slots.length; ++k) {
            const v = outline[k]!;
            const slot = slots[k]!;
            cells[at + slot] = v;
            this.stride[slot] = v - last[slot]!;
            last[slot] = v;
            if (v >= this.fresh) this.fresh = v + 1;
        }
        for (let k = 0; k < slots.length; ++k) open.join(outline[k]!, outline[k + 1 < slots.length ? k + 1 : 0]!);
    }
}
