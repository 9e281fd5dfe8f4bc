import { describe, expect, it } from 'vitest';
import { cutLevel, wholeCut } from '../mesh/meshChange.ts';
import { borderOfCells, type TornSurface, type Trimming, trimTornBorder } from './tornBorder.ts';

/** A flat sheet with a quad where `is` says so; its border is torn, but for where it `ends`. */
class Grid {
    readonly surface: TornSurface;
    private trimming: Trimming | null | undefined;
    private readonly ids = new Map<string, number>();
    private readonly at: [number, number][] = [];
    private readonly places: [number, number][] = [];

    constructor(wide: number, high: number, is: (x: number, y: number) => boolean, ends: (x: number, y: number) => boolean) {
        const cells: number[] = [];
        for (let x = 0; x < wide; ++x) {
            for (let y = 0; y < high; ++y) {
                if (!is(x, y)) continue;
                const corners = [this.id(x, y), this.id(x + 1, y), this.id(x + 1, y + 1), this.id(x, y + 1)];
                cells.push(...corners, -1, -1, -1, -1);
                this.places.push([x, y]);
            }
        }
        this.surface = {
            cells: Int32Array.from(cells),
            vertices: this.at.length,
            positions: Float32Array.from(this.at.flatMap(([x, y]) => [x, y, 0])),
            isEnd: (v) => ends(...this.at[v]!),
        };
    }

    /** Null: nothing is cut. */
    get trimmed(): Trimming | null {
        if (this.trimming === undefined) this.trimming = trimTornBorder(this.surface);
        return this.trimming;
    }

    /** Quads of which nothing is drawn. */
    get gone(): [number, number][] {
        const levels = this.trimmed?.levels;
        const whole = (x: number, y: number): number => levels?.[this.ids.get(`${x},${y}`)!] ?? 0;
        return this.places.filter(([x, y]) =>
            [whole(x, y), whole(x + 1, y), whole(x, y + 1), whole(x + 1, y + 1)].every((level) => level >= cutLevel),
        );
    }

    /** Returns how much of the quads in column x is drawn along their left sides: what the GPU leaves of the
     *  levels between vertices. */
    drawn(x: number, high: number): number {
        const levels = this.trimmed?.levels;
        let sum = 0;
        for (let y = 0; y < high; ++y) {
            const [low, next] = [this.ids.get(`${x},${y}`), this.ids.get(`${x},${y + 1}`)];
            if (low === undefined || next === undefined) continue;
            const [a, b] = [levels?.[low] ?? 0, levels?.[next] ?? 0].map((level) => level - cutLevel - 0.5) as [number, number];
            sum += a <= 0 && b <= 0 ? 1 : a > 0 && b > 0 ? 0 : Math.min(a, b) / (Math.min(a, b) - Math.max(a, b));
        }
        return sum;
    }

    private id(x: number, y: number): number {
        const name = `${x},${y}`;
        const known = this.ids.get(name);
        if (known !== undefined) return known;
        this.ids.set(name, this.at.length);
        this.at.push([x, y]);
        return this.at.length - 1;
    }
}

const none = (): boolean => false;

describe('borderOfCells', () => {
    it('is where a side belongs to one cell alone, over mids too', () => {
        // Two columns of which the right one is cut once: its new vertex hangs on the left cell.
        const cells = Int32Array.from([0, 1, 4, 3, -1, 6, -1, -1, 1, 2, 7, 6, -1, -1, -1, -1, 6, 7, 5, 4, -1, -1, -1, -1]);
        expect([...borderOfCells(cells, 8)]).toEqual([1, 1, 1, 1, 1, 1, 0, 1]);
        const { surface } = new Grid(20, 20, () => true, none);
        const border = borderOfCells(surface.cells, surface.vertices);
        expect(border.reduce((sum, each) => sum + each, 0)).toBe(80);
    });
});

describe('trimming torn borders', () => {
    it('leaves a straight border as it is, and a surface that ends where it was meant to', () => {
        const half = new Grid(
            30,
            8,
            () => true,
            (x, y) => x === 0 || x === 30 || y === 0,
        );
        expect(trimTornBorder(half.surface)).toBeNull();
        const stairs = (x: number, y: number): boolean => y < 4 + (x % 5);
        expect(trimTornBorder(new Grid(30, 10, stairs, () => true).surface)).toBeNull();
    });

    it('leaves out a comb of teeth, one quad wide, and nothing behind it', () => {
        const comb = new Grid(
            40,
            12,
            (x, y) => y < 6 || (x % 4 === 2 && y < 6 + (x % 3) + 1),
            (x, y) => x === 0 || x === 40 || y === 0,
        );
        const teeth = Array.from({ length: 40 }, (_, x) => x)
            .filter((x) => x % 4 === 2)
            .flatMap((x) => Array.from({ length: (x % 3) + 1 }, (_, i) => [x, 6 + i]));
        expect(comb.gone).toEqual(teeth);
    });

    it('leaves out crumbs beside a large surface, but neither large parts nor any that the rake or the ends are on', () => {
        const islands = (x: number, y: number): boolean =>
            x < 40 || (x >= 42 && x < 45 && y < 2) || (x >= 50 && x < 60) || (x >= 70 && x < 73 && y < 2);
        const beside = new Grid(80, 12, islands, (x, y) => x === 0 || y === 12 || (x >= 70 && y === 0));
        const crumb = [42, 43, 44].flatMap((x) => [0, 1].map((y) => [x, y]));
        expect(beside.gone).toEqual(crumb);
        const { levels } = trimTornBorder(beside.surface)!;
        expect(levels.filter((level) => level === wholeCut)).toHaveLength(12);
    });

    it('lets stay what is one quad wide as a whole, or for long', () => {
        expect(new Grid(30, 1, () => true, none).gone).toEqual([]);
        expect(new Grid(1, 1, () => true, none).gone).toEqual([]);
        expect(
            new Grid(
                2,
                40,
                () => true,
                (_x, y) => y === 0,
            ).gone,
        ).toEqual([]);
        // Half of a sheet has gone round the body, a single column of it on the other side.
        const ribbon = (x: number, y: number): boolean => x < 20 || y === 9 || y < 6;
        expect(new Grid(60, 10, ribbon, none).gone).toEqual([]);
    });

    it.each([
        [2, 0.07],
        [3, 0.12],
        [5, 0.3],
    ])('makes a slope of stairs that are %d quads long: within %d quads, and no higher than they are', (run, within) => {
        const [wide, high] = [60, 60 / run + 8];
        const slope = new Grid(
            wide,
            high,
            (x, y) => y < 5 + Math.floor(x / run),
            (x, y) => x === 0 || x === wide || y === 0,
        );
        const heights = Array.from({ length: wide - 20 }, (_, i) => slope.drawn(i + 10, high));
        // Stairs are 0.25, 0.33 and 0.4 away from it.
        const [first, last] = [heights[0]!, heights.at(-1)!];
        const line = (i: number): number => first + ((last - first) * i) / (heights.length - 1);
        heights.forEach((each, i) => expect(Math.abs(each - line(i))).toBeLessThan(within));
        heights.forEach((each, i) => {
            expect(each).toBeLessThanOrEqual(5 + Math.floor((i + 10) / run) + 1e-6);
            expect(each).toBeGreaterThan(5 + (i + 10) / run - 1.6);
        });
    });

    it('does the same of the same surface in other units, wherever it is', () => {
        const stairs = (x: number, y: number): boolean => y < 5 + Math.floor(x / 3) || (x === 20 && y < 14);
        const { surface } = new Grid(40, 20, stairs, (x) => x === 0);
        const levels = trimTornBorder(surface)!.levels;
        for (const scale of [1e-6, 1e6]) {
            const positions = surface.positions.map((x) => 4 * scale * (x + 64));
            expect(
                [...trimTornBorder({ ...surface, positions })!.levels].map((x, i) => Math.abs(x - levels[i]!) <= 1),
            ).not.toContain(false);
        }
    });

    it('keeps round what is round: a disc of 20 quads across stays', () => {
        const disc = new Grid(22, 22, (x, y) => (x - 10.5) ** 2 + (y - 10.5) ** 2 < 100, none);
        let [whole, drawn] = [0, 0];
        for (let x = 1; x < 22; ++x) {
            drawn += disc.drawn(x, 22);
            for (let y = 0; y < 22; ++y) {
                if ((x - 10.5) ** 2 + (y - 10.5) ** 2 < 100 && (x - 11.5) ** 2 + (y - 10.5) ** 2 < 100) ++whole;
            }
        }
        expect(drawn).toBeGreaterThan(0.98 * whole);
    });
});
