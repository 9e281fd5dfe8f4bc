import { describe, expect, it } from 'vitest';
import type { LinesRecord } from '../../protocol/messages.ts';
import { linesFileOf } from '../../protocol/testing/linesFile.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { datasetOf } from '../../testing/records.ts';
import { rested } from '../../testing/shownPanel.ts';
import { FieldColours } from './fieldColours.ts';
import { Lines } from './linesInPicture.ts';
import { linesPath } from './linesValues.ts';

const record: LinesRecord = {
    ...{ lines: 'l1', rev: 1, dataset: 'flow', kind: 'sphere', points: [[0, 0, 1]], distance: 0.5, seeds: 9 },
    ...{ patches: [], direction: 'both', duration: 0, length: 0, field: 'U' },
};

function linesOf(page: PageBench) {
    const asked: string[] = [];
    const bytes = linesFileOf({
        lines: [
            [
                [1, 2, 3, 0],
                [1, 2, 4, 2],
            ],
        ],
        outside: 8,
    });
    const lines = new Lines({
        ...{
            state: page.state,
            view: page.view,
            worker: page.worker,
            edits: page.edits,
            time: () => 9,
            colours: new FieldColours(),
        },
        scene: { add: () => undefined, loop: { request: () => undefined } },
        server: {
            fetch: (path) => {
                asked.push(path);
                return Promise.resolve(new Response(bytes));
            },
        },
    });
    page.state.lines.value = new Map([['l1', record]]);
    return { lines, asked };
}

describe('a set of streamlines', () => {
    it('is asked for at the time of the picture, and says which seeds have no line', async () => {
        const { lines, asked } = linesOf(new PageBench());
        await rested();
        expect(asked).toEqual([
            'api/v1/datasets/flow/lines.bin?from=sphere%3A0%2C0%2C1%3A0.5&seeds=9&direction=both&field=U&time=9',
        ]);
        expect(lines.told.value.get('l1')).toBe('1 line. 8 of 9 seeds lie outside of the flow or in a body.');
        expect(lines.meanings.value.get('l1')).toEqual({ field: 'U', less: '', map: 'viridis', range: [0, 2] });
        expect(lines.waiting.value).toBe(false);
    });

    it('that is added is like one of the data that are worked on, not of others', () => {
        const page = new PageBench();
        const { lines } = linesOf(page);
        page.state.otherDatasets.value = new Map([['other', datasetOf({ dataset: 'other' })]]);
        page.state.lines.value = new Map([
            ['l2', { ...record, lines: 'l2', dataset: 'other', field: 'p' }],
            ['l1', record],
        ]);
        expect([null, 'l1', 'l2'].map((chosen) => lines.like(chosen)?.field)).toEqual(['U', 'U', 'U']);
        page.state.lines.value = new Map([['l2', { ...record, lines: 'l2', dataset: 'other', field: 'p' }]]);
        expect(lines.like('l2')).toBeUndefined();
    });

    it('takes a range of colours of its own without being asked for again', async () => {
        const page = new PageBench();
        const { lines, asked } = linesOf(page);
        await rested();
        lines.change('l1', { range: [-1, 1] });
        await rested();
        const [, params] = page.calls.find(([method]) => method === 'lines.set')!;
        expect(params).toMatchObject({ lines: 'l1', dataset: 'flow', low: -1, high: 1, seeds: 9 });
        expect(lines.meanings.value.get('l1')?.range).toEqual([-1, 1]);
        expect(asked).toHaveLength(1);
    });
});

it('an address of lines has only what they have', () => {
    const place = {
        kind: 'line' as const,
        points: [
            [0, 0, 0],
            [1, 0, 0],
        ],
        distance: 0,
        patches: [] as string[],
        seeds: 5,
        direction: 'forward' as const,
        duration: 2,
        length: 3,
    };
    expect(
        linesPath({
            dataset: 'a b',
            ...place,
            points: [
                [0, 0, 0],
                [1, 0, 0],
            ],
            field: 'p',
            time: null,
        }),
    ).toBe(
        'api/v1/datasets/a%20b/lines.bin?from=line%3A0%2C0%2C0%3A1%2C0%2C0&seeds=5&direction=forward&field=p&duration=2&length=3',
    );
    expect(
        linesPath({
            dataset: 'a',
            ...place,
            kind: 'walls',
            points: [],
            distance: 2,
            patches: ['hull', 'in let'],
            field: 'p',
            time: 1,
        }),
    ).toContain('?from=walls%3A2&seeds=5&direction=forward&field=p&patch=hull%0Ain+let&duration=2');
});
