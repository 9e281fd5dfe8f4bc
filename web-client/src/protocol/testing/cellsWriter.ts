// Writes the cells code as protocol/wire/README.md has it, slowly and plainly: one endless number instead of a coder with carries,
// maps instead of arrays. Shares no code with the reader, so that each checks the other.

const none = -1;

/** What both ends know: cells that stay, in new numbers, with which of them are replaced, and touched vertices. */
export interface PlainKept {
    cells: number[][];
    replaced: boolean[];
    touched: Set<number>;
    stay: number; // vertices
}

export const nothingKept: PlainKept = { cells: [], replaced: [], touched: new Set(), stay: 0 };

/** An arithmetic coder with a number as long as it takes. */
class Encoder {
    private low = 0n;
    private range = 0xffffffffn;
    private bytes = 4;
    private readonly bits = new Map<string, { one: number; seen: number }>();

    bit(name: string, value: boolean): boolean {
        const learnt = this.bits.get(name) ?? { one: 32768, seen: 0 };
        this.narrow((this.range >> 16n) * BigInt(learnt.one), value);
        const rate = Math.floor(131072 / (2 * learnt.seen + 3));
        learnt.one += value ? Math.floor(((65536 - learnt.one) * rate) / 65536) : -Math.floor((learnt.one * rate) / 65536);
        learnt.one = Math.min(65504, Math.max(32, learnt.one));
        learnt.seen = Math.min(30, learnt.seen + 1);
        this.bits.set(name, learnt);
        return value;
    }

    number(name: string, value: number): void {
        const digits = value === 0 ? '' : value.toString(2);
        let node = 1;
        for (const digit of digits.length.toString(2).padStart(6, '0')) {
            this.bit(`${name} width ${node}`, digit === '1');
            node = 2 * node + Number(digit);
        }
        [...digits].slice(1).forEach((digit, i) => {
            const learnt = i === 0 ? '' : digits[1];
            if (i < 2) this.bit(`${name} high ${digits.length} ${learnt}`, digit === '1');
            else this.narrow(this.range >> 1n, digit === '1');
        });
    }

    finish(): number[] {
        const digits = this.low.toString(16).padStart(2 * this.bytes, '0');
        return Array.from({ length: this.bytes }, (_, i) => parseInt(digits.slice(2 * i, 2 * i + 2), 16));
    }

    private narrow(bound: bigint, value: boolean): void {
        this.low += value ? 0n : bound;
        this.range = value ? bound : this.range - bound;
        while (this.range < 1n << 24n) {
            this.low <<= 8n;
            this.range <<= 8n;
            ++this.bytes;
        }
    }
}

/** Sides that are open, one leaving and one arriving a vertex. */
class Sides {
    readonly leaves = new Map<number, number>();
    readonly arrives = new Map<number, number>();

    add(cell: number[]): void {
        const outline = slotsOf(cell).map((slot) => cell[slot]!);
        outline.forEach((x, i) => {
            const y = outline[(i + 1) % outline.length]!;
            const closes = this.leaves.get(y) === x || this.arrives.get(x) === y;
            if (this.leaves.get(y) === x) this.leaves.delete(y);
            if (this.arrives.get(x) === y) this.arrives.delete(x);
            if (closes) return;
            this.leaves.set(x, y);
            this.arrives.set(y, x);
        });
    }
}

function slotsOf(cell: number[]): number[] {
    return [0, 4, 1, 5, 2, 6, 3, 7].filter((slot) => cell[slot] !== none);
}

function zigzag(difference: number): number {
    return ((difference << 1) ^ (difference >> 31)) >>> 0;
}

/** The replaced cells in order, then those that are added; their vertices are below `vertices`. */
export function writeCells(cells: number[][], kept: PlainKept, vertices: number): number[] {
    if (cells.length === 0) return [];
    const out = new Encoder();
    const sides = new Sides();
    kept.cells.forEach((cell, i) => {
        const near = cell.some((id) => kept.touched.has(id)) || i >= kept.cells.length - 4096;
        if (near && !kept.replaced[i]) sides.add(cell);
    });
    const olds = kept.cells.filter((_, i) => kept.replaced[i]);
    let fresh = kept.stay;
    const last = Array<number>(8).fill(0);
    const stride = Array<number>(8).fill(1);
    let lastMids = Array<boolean>(4).fill(false);
    let pattern: { slots: string; choices: string[] } | undefined;
    let start = 'none';
    let repeats = '000';
    cells.forEach((cell, index) => {
        const old = olds[index];
        const slots = slotsOf(cell);
        const expected = (choice: string, k: number): number => {
            const slot = slots[k]!;
            switch (choice) {
                case 'along':
                    return last[3]!;
                case 'beside':
                    return last[1]!;
                case 'stride':
                    return slot < 4 ? last[slot]! + stride[slot]! : none;
                case 'fresh':
                    return fresh;
                case 'old':
                    return old?.[slot] ?? none;
                case 'gate':
                    return sides.arrives.get(cell[slots[k - 1]!]!) ?? none;
                default: {
                    let v: number | undefined = cell[0];
                    for (let steps = slots.length - k; steps > 0 && v !== undefined; --steps) v = sides.leaves.get(v);
                    return v ?? none;
                }
            }
        };
        const finish = (): void => {
            sides.add(cell);
            slots.forEach((slot) => {
                stride[slot] = cell[slot]! - last[slot]!;
                last[slot] = cell[slot]!;
            });
            fresh = Math.max(fresh, ...slots.map((slot) => cell[slot]! + 1));
        };
        if (old === undefined && pattern !== undefined && !pattern.choices.includes('none')) {
            const { choices } = pattern;
            const same = pattern.slots === slots.join() && slots.every((slot, k) => expected(choices[k]!, k) === cell[slot]);
            out.bit(`repeat ${repeats}`, same);
            repeats = repeats.slice(1) + (same ? '1' : '0');
            if (same) {
                finish();
                return;
            }
        }
        const mids = [4, 5, 6, 7].map((slot) => cell[slot] !== none);
        mids.forEach((has, i) => {
            const had = old !== undefined && old[4 + i] !== none;
            const before = i > 0 && mids[i - 1];
            out.bit(`mid ${old !== undefined} ${i} ${had} ${i !== 2 && lastMids[i]} ${before}`, has);
        });
        lastMids = mids;
        let before = start;
        const choices = slots.map((slot, k) => {
            const order =
                k > 0
                    ? ['old', 'back', 'gate', 'fresh', 'stride']
                    : old !== undefined
                      ? ['old']
                      : ['along', 'beside', 'stride', 'fresh'];
            const seen = slots.slice(0, k).map((known) => cell[known]!);
            const found = order.find((choice) => {
                const v = expected(choice, k);
                if (v < 0 || v >= vertices || seen.includes(v)) return false;
                seen.push(v);
                return out.bit(`choice ${old !== undefined} ${slot} ${before} ${choice}`, v === cell[slot]);
            });
            if (found === undefined) {
                const from = k === 0 ? last[0]! : slot >= 4 ? fresh : cell[slots[k - 1]!]!;
                out.number(k === 0 ? 'first' : slot >= 4 ? 'mid' : 'corner', zigzag(cell[slot]! - from));
            }
            return (before = found ?? 'none');
        });
        if (old === undefined) {
            pattern = { slots: slots.join(), choices };
            start = choices[0]!;
        }
        finish();
    });
    return out.finish();
}
