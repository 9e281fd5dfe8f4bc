import { beforeAll, describe, expect, it } from 'vitest';
import type { MeshChange } from '../mesh/meshChange.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { type AppliedUpdate, MeshDecoder } from '../protocol/meshDecoder.ts';
import { dracoPoints } from '../protocol/testing/golden.ts';
import { lattice, randomUpdates, ranges, seededRandom } from '../protocol/testing/randomSurface.ts';
import { DisplayArrays } from './displayArrays.ts';
import { addNormals } from './vertexQuantities.ts';
import type { ShowWish } from './workerMessages.ts';

let points: DracoPoints;
beforeAll(async () => {
    points = await dracoPoints();
});

/** What a page has that puts every change in its place. */
class Screen {
    private readonly room = { positions: new Float32Array(9000), normals: new Float32Array(9000) };
    private readonly seeds = new Float32Array(6000);
    private readonly scalars = new Float32Array(3000);
    private readonly indices = new Uint32Array(60_000);
    private cut = new Uint8Array(0);
    private vertices = 0;
    private triangles = 0;

    put(change: MeshChange): void {
        this.room.positions.set(change.positions, 3 * change.fromVertex);
        this.room.normals.set(change.normals, 3 * change.fromNormal);
        this.seeds.set(change.seeds, 2 * change.fromSeed);
        for (const { name, fromVertex, values } of change.scalars) {
            if (name === 'speed') this.scalars.set(values, fromVertex);
        }
        this.indices.set(change.indices, change.fromIndex);
        if (change.cut !== null) this.cut = new Uint8Array(change.cut.levels);
        ({ vertices: this.vertices, triangles: this.triangles } = change);
    }

    get picture(): Record<'positions' | 'normals' | 'seeds' | 'scalars' | 'indices' | 'cut', number[]> {
        return {
            positions: [...this.room.positions.subarray(0, 3 * this.vertices)],
            normals: [...this.room.normals.subarray(0, 3 * this.vertices)],
            seeds: [...this.seeds.subarray(0, 2 * this.vertices)],
            scalars: [...this.scalars.subarray(0, this.vertices)],
            indices: [...this.indices.subarray(0, 3 * this.triangles)],
            cut: [...this.cut],
        };
    }
}

const attributes = ['speed', 's', 't'].slice(0, ranges.length);

function wish(attributes: readonly string[]): ShowWish {
    return { attributes, parts: null, trimmed: true };
}

function display(): DisplayArrays {
    const made = new DisplayArrays(lattice, attributes);
    made.show(wish(['speed']));
    return made;
}

function whole(update: AppliedUpdate): Screen {
    const screen = new Screen();
    screen.put(display().take(update.mesh));
    return screen;
}

/** Calls `check` with the screen each time something has been taken. */
function play(still: boolean, seed: number, check: (screen: Screen, update: AppliedUpdate) => void): number {
    const random = seededRandom(seed);
    const decoder = new MeshDecoder(points, lattice, ranges.length);
    const shown = display();
    const screen = new Screen();
    let partial = 0;
    for (const frame of randomUpdates(seed, 150, still).flatMap(({ frames }) => frames)) {
        const update = decoder.fold(frame);
        if (update === undefined) continue;
        shown.note(update);
        if (random() % 3 === 0) continue;
        const change = shown.take(update.mesh);
        partial += change.fromVertex > 0 && change.fromIndex > 0 ? 1 : 0;
        screen.put(change);
        check(screen, update);
    }
    return partial;
}

describe('DisplayArrays', () => {
    it('trims torn borders while it is asked to, of changes as of the whole', () => {
        const decoder = new MeshDecoder(points, lattice, ranges.length);
        const [shown, screen] = [new DisplayArrays(lattice, ['t', 's']), new Screen()];
        shown.show(wish([]));
        let most = 0;
        for (const frame of randomUpdates(36, 80, false).flatMap(({ frames }) => frames)) {
            const update = decoder.fold(frame);
            if (update === undefined) continue;
            const { mesh } = update;
            const fresh = new DisplayArrays(lattice, ['t', 's']);
            for (const each of [shown, fresh]) each.note(update);
            fresh.show(wish([]));
            const { cut } = fresh.take(mesh);
            screen.put(shown.take(mesh));
            expect(screen.picture.cut).toEqual([...cut!.levels]);
            most = Math.max(most, cut!.trimmedCells);
            expect(shown.take(mesh).cut).toBeNull();
            expect(shown.show({ ...wish([]), trimmed: false })).toBe(true);
            expect(shown.take(mesh).cut).toEqual({ levels: new Uint8Array(0), trimmedCells: 0 });
            expect(shown.show(wish([]))).toBe(true);
            expect(shown.take(mesh).cut).toEqual(cut);
        }
        expect(most).toBeGreaterThan(3);
    });

    it('returns changes that add up to the whole, while vertices stay where they are', () => {
        const partial = play(true, 31, (screen, update) => {
            expect(screen.picture).toEqual(whole(update).picture);
        });
        expect(partial).toBeGreaterThan(20);
    });

    it('follows moving vertices, whose quads stay cut as they were', () => {
        play(false, 32, (screen, update) => {
            const [shown, expected] = [screen.picture, whole(update).picture];
            expect(shown.positions).toEqual(expected.positions);
            expect(shown.scalars).toEqual(expected.scalars);
            expect(shown.cut).toEqual(expected.cut);
            expect(shown.indices).toHaveLength(expected.indices.length);
            const normals = new Float32Array(shown.positions.length);
            addNormals(Float32Array.from(shown.positions), Uint32Array.from(shown.indices), 0, normals);
            expect(shown.normals).toEqual([...normals]);
        });
    });

    it('puts vertices where the lattice says, with the values of their codes', () => {
        const [{ frames, state }] = randomUpdates(33, 1) as [ReturnType<typeof randomUpdates>[0]];
        const decoder = new MeshDecoder(points, lattice, ranges.length);
        const update = frames.map((frame) => decoder.fold(frame)).at(-1)!;
        const { positions, scalars } = display().take(update.mesh);
        expect(state.positions.length).toBeGreaterThan(3);
        state.positions.forEach(([x, y, z], v) => {
            const expected = [10 + x! / 4, -2 + y! / 4, 5 + z! / 4];
            expect([...positions.subarray(3 * v, 3 * v + 3)]).toEqual(expected);
            expect(scalars[0]!.values[v]).toBeCloseTo(-1 + (4 * state.codes[v]![0]!) / 65535, 6);
        });
    });

    it('returns an attribute whole when it is asked for, and afterwards only where it may have changed', () => {
        const decoder = new MeshDecoder(points, lattice, ranges.length);
        const shown = display();
        const updates = randomUpdates(34, 40, true).flatMap(({ frames }) => frames.map((frame) => decoder.fold(frame)));
        const applied = updates.filter((update) => update !== undefined);
        // All of them change the one mesh, which is now the last.
        const { mesh } = applied.at(-1)!;
        shown.note(applied.at(-1)!);
        expect(shown.take(mesh).scalars.map(({ name }) => name)).toEqual(['speed']);
        expect(shown.take(mesh).scalars).toEqual([]);
        expect(shown.show(wish(['speed', 's']))).toBe(true);
        const [only, ...others] = shown.take(mesh).scalars;
        expect([only?.name, only?.fromVertex, only?.values.length, others.length]).toEqual(['s', 0, mesh.vertices, 0]);
        expect(shown.show(wish(['s']))).toBe(false);
        expect(shown.show(wish(['unknown', 's']))).toBe(false);
        shown.rename(['speed', 's', 'unknown']);
        expect(shown.take(mesh).scalars.map(({ name, values }) => [name, values.length])).toEqual([['unknown', mesh.vertices]]);
    });

    it('goes on with what is shown, of every state, until all that is wanted is here', () => {
        const decoder = new MeshDecoder(points, lattice, ranges.length);
        const shown = display();
        const names = randomUpdates(37, 30, false).flatMap(({ frames }, i) => {
            if (i === 10) shown.show(wish(['unknown']));
            if (i === 20) shown.rename(['unknown', 's', 't']);
            const updates = frames.map((frame) => decoder.fold(frame)).filter((update) => update !== undefined);
            updates.forEach((update) => shown.note(update));
            return updates.length === 0
                ? []
                : [
                      shown
                          .take(updates.at(-1)!.mesh)
                          .scalars.map(({ name }) => name)
                          .join(),
                  ];
        });
        expect(new Set(names.slice(0, 20))).toEqual(new Set(['speed']));
        expect(new Set(names.slice(20))).toEqual(new Set(['unknown']));
    });

    it('takes back what was cut once no one asks for it', () => {
        const [{ frames }] = randomUpdates(35, 1) as [ReturnType<typeof randomUpdates>[0]];
        const decoder = new MeshDecoder(points, lattice, ranges.length);
        const update = frames.map((frame) => decoder.fold(frame)).at(-1)!;
        const shown = display();
        shown.show({ attributes: ['speed'], parts: { hidden: [[0, 0]] }, trimmed: false });
        shown.take(update.mesh);
        expect(shown.show({ attributes: ['speed'], parts: null, trimmed: false })).toBe(true);
        expect(shown.take(update.mesh)).toMatchObject({ parts: null, cut: { levels: new Uint8Array(0), trimmedCells: 0 } });
    });

    it('finds parts only when asked, and again only when cells have changed', () => {
        const [{ frames }] = randomUpdates(35, 1) as [ReturnType<typeof randomUpdates>[0]];
        const decoder = new MeshDecoder(points, lattice, ranges.length);
        const update = frames.map((frame) => decoder.fold(frame)).at(-1)!;
        const shown = display();
        expect(shown.take(update.mesh).parts).toBeNull();
        expect(shown.show({ ...wish(['speed']), parts: { hidden: [] } })).toBe(true);
        const cells = shown.take(update.mesh).parts!.reduce((sum, part) => sum + part.cells, 0);
        expect(cells).toBe(update.mesh.cellCount);
        expect(shown.take(update.mesh).parts).toBeNull();
        shown.note(update);
        expect(shown.take(update.mesh).parts).not.toBeNull();
    });
});
