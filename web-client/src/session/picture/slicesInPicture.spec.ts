import { describe, expect, it } from 'vitest';
import type { SliceRecord } from '../../protocol/messages.ts';
import { noSliceValue } from '../../protocol/sliceFile.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { datasetOf } from '../../testing/records.ts';
import { rested } from '../../testing/shownPanel.ts';
import { Slices } from './slicesInPicture.ts';
import { FieldColours } from './fieldColours.ts';
import { coloursOf } from './usualColours.ts';

const record: SliceRecord = { slice: 'c1', rev: 1, dataset: 'flow', origin: [0, 0, 1], normal: [0, 0, 1], field: 'U' };

/** Of one sample, without a value. */
function emptyRaster(inFlow: number): ArrayBuffer {
    const bytes = new DataView(new ArrayBuffer(114));
    [0x014c_5357, 1, 1, inFlow].forEach((each, i) => bytes.setUint32(4 * i, each, true));
    bytes.setUint16(112, noSliceValue, true);
    return bytes.buffer;
}

/** A page with a slice, whose values never come. @param answer  unless there is one */
function slicesOf(page: PageBench, answer?: () => Response) {
    const asked: string[] = [];
    const slices = new Slices({
        ...{
            state: page.state,
            view: page.view,
            worker: page.worker,
            edits: page.edits,
            time: () => 9,
            colours: new FieldColours(),
        },
        scene: {
            ...{
                add: () => undefined,
                hold: () => undefined,
                pick: () => null,
                whenDrawn: () => undefined,
                view: () => null as never,
                rakes: { pointUnder: () => null },
            },
            ...{ size: { width: 800, height: 600 }, loop: { request: () => undefined }, pointerTools: { add: () => undefined } },
        },
        server: {
            fetch: (path) => {
                asked.push(path);
                return answer === undefined ? new Promise(() => undefined) : Promise.resolve(answer());
            },
        },
    });
    page.state.slices.value = new Map([['c1', record]]);
    return { slices, asked };
}

describe('a slice', () => {
    it.each([
        ['in bodies alone', () => new Response(emptyRaster(0)), 'This plane meets only bodies.'],
        ['of a field without values there', () => new Response(emptyRaster(1)), 'U has no values here at this time.'],
        ['that is refused', () => new Response('{"error":{"message":"no memory"}}', { status: 503 }), 'no memory'],
    ])('%s says why nothing is seen of it', async (_, answer, words) => {
        const { slices } = slicesOf(new PageBench(), answer);
        await rested();
        expect(slices.faults.value.get('c1')).toContain(words);
    });

    it('is asked for at the time of the picture', () => {
        const { asked } = slicesOf(new PageBench());
        expect(asked).toHaveLength(1);
        expect(asked[0]).toContain('time=9');
    });

    it('is drawn where it is dragged before the server has answered, which is told the whole slice', async () => {
        const page = new PageBench();
        const { slices } = slicesOf(page);
        slices.change('c1', { origin: [0, 0, 2] });
        expect(slices.places.value.get('c1')?.origin).toEqual([0, 0, 2]);
        await rested();
        const set = page.calls.find(([method]) => method === 'slice.set');
        const { gesture, ...params } = set![1];
        expect(gesture).toBeTypeOf('string');
        expect(params).toEqual({ slice: 'c1', dataset: 'flow', origin: [0, 0, 2], normal: [0, 0, 1], field: 'U' });
    });

    it('is as the server has it again where an edit is refused', async () => {
        const page = new PageBench();
        const { slices } = slicesOf(page);
        page.answers['slice.set'] = () => {
            throw new Error('the plane misses the domain by 4');
        };
        slices.change('c1', { origin: [0, 0, 99] });
        await rested();
        expect(slices.places.value.get('c1')?.origin).toEqual([0, 0, 1]);
        expect([...page.state.problems.all.value.values()].join()).toContain('misses the domain');
    });
});

describe('a new slice', () => {
    it('is of a field of the data that are worked on, whatever others show', async () => {
        const page = new PageBench();
        const { slices } = slicesOf(page);
        page.state.otherDatasets.value = new Map([['other', datasetOf({ dataset: 'other' })]]);
        page.state.slices.value = new Map([['c1', { ...record, dataset: 'other', field: 'p' }]]);
        await slices.add([0, 0, 1], [0, 0, 1]);
        expect(page.asked('slice.set')[0]).toMatchObject({ dataset: 'flow', field: 'U' });
    });
});

describe('the colours of a slice', () => {
    it('are round numbers around what there is', () => {
        expect(coloursOf(0.13, 1.97)).toEqual({ map: 'viridis', range: [0, 2] });
    });

    it('are the same on both sides of 0 where there are both signs, and only there', () => {
        expect(coloursOf(-3, 1)).toEqual({ map: 'coolToWarm', range: [-3, 3] });
        expect(coloursOf(-0.01, 1).map).toBe('viridis');
    });
});

it('is of its own data, at the time of the picture as far as they have it', () => {
    const page = new PageBench();
    const { asked } = slicesOf(page);
    page.state.slices.value = new Map([['c1', { ...record, dataset: 'short' }]]);
    expect(asked.splice(0).length, 'before they are known').toBe(1);
    page.state.otherDatasets.value = new Map([
        ['short', datasetOf({ dataset: 'short', times: [1, 2], bounds: [0, 1, 0, 1, 0, 1] })],
    ]);
    expect(asked.map((path) => [path.includes('datasets/short'), /time=([^&]*)/.exec(path)?.[1]])).toEqual([[true, '2']]);
});
