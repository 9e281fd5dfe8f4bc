import { beforeEach, expect, it } from 'vitest';
import type { SliceRecord, Vec3 } from '../../protocol/messages.ts';
import { settled } from '../../testing/fakes.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { RecordDrafts } from '../edits/recordDrafts.ts';
import { moves } from './moveTogether.ts';

type Place = Pick<SliceRecord, 'origin' | 'normal' | 'field'>;

const record: SliceRecord = { slice: 'c1', rev: 1, dataset: 'flow', origin: [0, 0, 1], normal: [0, 0, 1], field: 'U' };

/** A page with a slice, and its server, which takes back what bears one name at once. */
class Side extends PageBench {
    readonly drafts: RecordDrafts<SliceRecord, Place>;
    private readonly before: { gesture: string; slices: ReadonlyMap<string, SliceRecord> }[] = [];

    constructor() {
        super();
        const { slices } = this.state;
        slices.value = new Map([['c1', record]]);
        this.drafts = new RecordDrafts<SliceRecord, Place>({
            ...{ state: this.state, edits: this.edits, noun: 'slice', records: slices, own: ['field'] },
            placeOf: ({ origin, normal, field }) => ({ origin, normal, field }),
            set: async (id = '', dataset, place, gesture) => {
                await settled();
                if (this.before.at(-1)?.gesture !== gesture) this.before.push({ gesture, slices: slices.value });
                slices.value = new Map([[id, { ...record, dataset, ...place }]]);
                return id;
            },
            ...{ remove: () => Promise.resolve(), gone: () => undefined },
        });
        this.answers['history.undo'] = () => {
            const { gesture = null, slices: back = slices.value } = this.before.pop() ?? {};
            slices.value = back;
            return { undone: gesture, skipped: [] };
        };
    }

    get height(): number | undefined {
        return this.drafts.places.value.get('c1')?.origin[2];
    }

    drag(...heights: number[]): void {
        this.edits.gestures.press();
        for (const z of heights) this.drafts.change('c1', { origin: [0, 0, z] as Vec3 });
        this.edits.gestures.release();
    }
}

let left: Side;
let right: Side;

beforeEach(() => {
    [left, right] = [new Side(), new Side()];
    left.edits.onMove = moves(left, right);
    right.edits.onMove = moves(right, left);
});

async function done(): Promise<void> {
    for (let i = 0; i < 10; ++i) await settled();
}

it('a slice that is dragged in one half is drawn there in the other at once, whichever that is', async () => {
    left.drag(2);
    expect([left.height, right.height]).toEqual([2, 2]);
    left.drag(3, 4);
    await done();
    expect([left.height, right.height, right.state.slices.value.get('c1')?.origin[2]]).toEqual([4, 4, 4]);
    right.drag(5);
    expect([left.height, right.height]).toEqual([5, 5]);
});

it('one undo, in either half, is for both, and takes nothing else along', async () => {
    left.drag(2, 3);
    await done();
    await left.edits.undo();
    await done();
    expect([left.height, right.height]).toEqual([1, 1]);
    left.drag(2);
    await done();
    right.drafts.change('c1', { field: 'p' });
    await done();
    await left.edits.undo();
    await done();
    expect([left.height, right.height], 'of the other half something else is the last').toEqual([1, 2]);
    await right.edits.undo();
    await right.edits.undo();
    await done();
    expect([left.height, right.height, left.drafts.places.value.get('c1')?.field]).toEqual([1, 1, 'U']);
});

it('what it is coloured by is of each half, and so is a slice that the other does not have or may not move', async () => {
    left.drafts.change('c1', { field: 'p' });
    await done();
    expect(right.drafts.places.value.get('c1')?.field).toBe('U');
    right.state.role.value = 'viewer';
    left.drag(7);
    expect(right.height).toBe(1);
    right.state.role.value = 'host';
    right.state.slices.value = new Map();
    left.drag(8);
    await done();
    expect([left.height, right.state.slices.value.size, right.state.problems.all.value.size]).toEqual([8, 0, 0]);
});

it('a rake that is dragged is one act in both halves, although its last move comes after the button has gone up', async () => {
    for (const side of [left, right]) side.answers['history.undo'] = () => ({ undone: 'act', skipped: [] });
    const move = (z: number, dragging: boolean): void =>
        left.edits.moveRake({ shape: { kind: 'line', points: [[0, 0, 0], [0, 0, z]] }, dragging, movedAt: performance.now() }); // prettier-ignore
    left.edits.gestures.press();
    left.dragging = true;
    for (const z of [1, 2, 3]) {
        move(z, true);
        await settled();
    }
    left.edits.gestures.release();
    left.dragging = false;
    move(4, false);
    await done();
    const steps = (): number[] => [left, right].map(({ edits }) => edits.history.undoable.value);
    expect(right.rakes[0]?.points[1]).toEqual([0, 0, 4]);
    expect(steps()).toEqual([1, 1]);
    await right.edits.undo();
    await done();
    expect(steps()).toEqual([0, 0]);
});
