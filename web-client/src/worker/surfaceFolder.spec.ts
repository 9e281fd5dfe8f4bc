import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { dracoPoints } from '../protocol/testing/golden.ts';
import { lattice, randomUpdates } from '../protocol/testing/randomSurface.ts';
import { sealed } from '../protocol/testing/wireWriter.ts';
import { surfaceOf } from '../testing/records.ts';
import { AttributeNames, SurfaceFolder } from './surfaceFolder.ts';
import type { SurfaceState } from './workerMessages.ts';

let points: DracoPoints;
beforeAll(async () => {
    points = await dracoPoints();
});

const updates = randomUpdates(61, 12);

class Bench {
    states: SurfaceState[] = [];
    applied: string[] = [];
    troubles: string[] = [];
    folder = new SurfaceFolder({
        draco: points,
        onState: (state) => this.states.push(state),
        onApplied: (subscription, { epoch, seq }) => this.applied.push(`${subscription}: ${epoch} ${seq}`),
        onTrouble: (surface, subscription) => this.troubles.push(`${surface} ${subscription}`),
    });

    subscribe(subscription: number, resumed = false): void {
        const attributes = ['speed', 's', 't'];
        this.folder.subscribed('s1', { subscription, lattice, attributes, epoch: 1, resumed });
    }

    /** The frames are written for subscription 3. */
    receive(update: number, subscription = 3): void {
        for (const frame of updates[update]!.frames) {
            const bytes = frame.slice();
            new DataView(bytes.buffer).setUint32(4, subscription, true);
            this.folder.receive(sealed(bytes));
        }
    }
}

describe('SurfaceFolder', () => {
    let bench: Bench;
    beforeEach(() => {
        bench = new Bench();
        bench.subscribe(3);
    });

    it('acknowledges every update, and hands on no more states than are taken', () => {
        for (let i = 0; i < 6; ++i) bench.receive(i);
        expect(bench.applied).toEqual([0, 1, 2, 3, 4, 5].map((seq) => `3: 1 ${seq}`));
        expect(bench.states.map(({ time }) => time * 8)).toEqual([0, 1]);
        bench.folder.taken('s1');
        bench.folder.taken('s1');
        expect(bench.states.map(({ time }) => time * 8)).toEqual([0, 1, 5]);
        expect(bench.states[2]).toMatchObject({ vertices: updates[5]!.state.positions.length });
    });

    it('goes on from the state it has under the next subscription, on the next connection', () => {
        const cutOff = updates.findIndex(({ frames }, i) => i > 0 && frames.length > 1);
        for (let i = 0; i < cutOff; ++i) bench.receive(i);
        expect(bench.folder.placeOf('s1')).toEqual({ epoch: 1, seq: cutOff - 1 });
        bench.folder.receive(updates[cutOff]!.frames[0]!);
        bench.folder.disconnected();
        bench.receive(cutOff);
        expect(bench.applied).toHaveLength(cutOff);
        bench.subscribe(8, true);
        bench.receive(cutOff, 8);
        expect(bench.applied.at(-1)).toBe(`8: 1 ${cutOff}`);
        expect(bench.troubles).toEqual([]);
    });

    it('starts afresh where the server cannot go on', () => {
        bench.receive(0);
        bench.receive(1);
        bench.folder.disconnected();
        bench.subscribe(8, false);
        expect(bench.folder.placeOf('s1')).toBeUndefined();
        bench.receive(0, 8);
        expect(bench.applied.at(-1)).toBe('8: 1 0');
    });

    it('reports trouble once, has nothing to go on from, and heals with a KEY', () => {
        bench.receive(0);
        bench.receive(2);
        bench.receive(3);
        expect(bench.troubles).toEqual(['s1 3']);
        expect(bench.folder.placeOf('s1')).toBeUndefined();
        bench.subscribe(4);
        bench.receive(0, 4);
        bench.receive(1, 4);
        expect(bench.applied.slice(-2)).toEqual(['4: 1 0', '4: 1 1']);
    });

    it('knows nothing of another session', () => {
        bench.receive(0);
        bench.folder.forgetAll();
        expect(bench.folder.placeOf('s1')).toBeUndefined();
        bench.receive(1);
        expect(bench.applied).toHaveLength(1);
        expect(bench.troubles).toEqual([]);
    });

    it('sends at once what the page asks to show, and what else it wants with every state to come', () => {
        bench.receive(0);
        expect(bench.states.at(-1)!.scalars.map(({ name }) => name)).toEqual(['speed']);
        bench.folder.taken('s1');
        bench.folder.show('s1', { attributes: ['t'], parts: null, trimmed: true });
        expect(bench.states).toHaveLength(2);
        expect(bench.states[1]!.scalars.map(({ name }) => name)).toEqual(['t']);
        expect(bench.states[1]!.positions).toHaveLength(0);
        expect(bench.states.map(({ withheld }) => withheld)).toEqual([
            ['s', 't'],
            ['speed', 's'],
        ]);
        bench.folder.show('s1', { attributes: ['t'], parts: null, trimmed: true });
        expect(bench.states).toHaveLength(2);
        bench.folder.taken('s1');
        bench.subscribe(9);
        bench.receive(0, 9);
        expect(bench.states.at(-1)!.scalars.map(({ name }) => name)).toEqual(['t']);
    });

    it('curves the cells of a state that stands still, and sends all of the next one, flat', async () => {
        vi.useFakeTimers();
        const wish = { attributes: ['speed'], parts: null, trimmed: true };
        bench.folder.show('s1', { ...wish, curved: 1e6 });
        bench.receive(0);
        bench.folder.taken('s1');
        vi.advanceTimersByTime(200);
        bench.receive(1);
        bench.folder.taken('s1');
        vi.advanceTimersByTime(200);
        expect(bench.states).toHaveLength(2);
        vi.advanceTimersByTime(100);
        await vi.dynamicImportSettled();
        const [, flat, curved] = bench.states;
        expect([flat!.curved, curved!.curved]).toEqual([false, true]);
        expect(curved!.meshVertices).toBe(flat!.meshVertices);
        expect(curved!.cells).toBe(flat!.cells);
        expect(curved!.vertices).toBeGreaterThan(flat!.vertices);
        expect(curved!.positions).toHaveLength(3 * curved!.vertices);
        expect(curved!.scalars[0]!.values).toHaveLength(curved!.vertices);
        vi.advanceTimersByTime(10_000);
        expect(bench.states).toHaveLength(3);
        bench.folder.taken('s1');
        bench.folder.show('s1', wish);
        const again = bench.states.at(-1)!;
        expect([again.fromVertex, again.fromIndex, again.vertices]).toEqual([0, 0, flat!.vertices]);
        expect(again.indices).toHaveLength(3 * again.triangles);
        vi.useRealTimers();
    });

    it('names attributes by the fields that the surface had at the epoch of the frames', () => {
        bench.folder.recorded(surfaceOf('s1', { fields: ['p'] }));
        bench.folder.show('s1', { attributes: ['p', 'speed'], parts: null, trimmed: true });
        // Three attributes, and not the four that were told: only what every surface has is sure.
        bench.receive(0);
        expect(bench.states.at(-1)!.scalars.map(({ name }) => name)).toEqual(['speed']);
    });
});

describe('AttributeNames', () => {
    it('are those of the newest epoch up to the one of the frames', () => {
        const names = new AttributeNames();
        names.learn('a', 2, ['speed', 's', 't']);
        names.learn('a', 5, ['speed', 's', 't', 'p']);
        expect(names.of('a', 4, 3)).toEqual(['speed', 's', 't']);
        expect(names.of('a', 5, 4)).toEqual(['speed', 's', 't', 'p']);
        expect(names.of('a', 9, 4)).toEqual(['speed', 's', 't', 'p']);
    });

    it('are only those that every surface has, where the frames have another number of them', () => {
        const names = new AttributeNames();
        names.learn('a', 5, ['speed', 's', 't', 'p']);
        expect(names.of('a', 6, 5)).toEqual(['speed', 's', 't']);
        expect(names.of('b', 1, 3)).toEqual(['speed', 's', 't']);
    });

    it('forget old epochs, and whole surfaces when told', () => {
        const names = new AttributeNames();
        for (let epoch = 1; epoch < 40; ++epoch) names.learn('a', epoch, ['speed', 's', 't', `f${epoch}`]);
        expect(names.of('a', 39, 4)[3]).toBe('f39');
        expect(names.of('a', 1, 4)).toEqual(['speed', 's', 't']);
        names.forget('a');
        expect(names.of('a', 39, 4)).toEqual(['speed', 's', 't']);
    });
});
