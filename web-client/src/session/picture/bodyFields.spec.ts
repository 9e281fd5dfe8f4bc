import { signal } from '@preact/signals-core';
import { describe, expect, it, vi } from 'vitest';
import type { BodyColours } from '../../scene/surface/drawnBody.ts';
import type { DatasetDescription } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { datasetOf } from '../../testing/records.ts';
import { rested } from '../../testing/shownPanel.ts';
import { plainBody } from '../../state/bodyLook.ts';
import { lateMs } from '../base/lateWaits.ts';
import { BodyFields, extentOf } from './bodyFields.ts';

/** A server that answers when the test lets it. */
function bench(change: Partial<DatasetDescription> = {}) {
    const [state, view, time] = [new AppState(), new ViewState(), signal(1)];
    state.stage.value = 'running';
    state.dataset.value = datasetOf({ obstacle: true, times: [0, 5, 10], ...change });
    const asked: number[] = [];
    const waiting: { answer: () => void; fail: () => void }[] = [];
    const shown: (number | null)[] = [];
    const moved: (number | null)[] = [];
    const fields: string[] = [];
    const files: string[] = [];
    const coloured: BodyColours[] = [];
    const clock = signal(true);
    const bodyFields = new BodyFields({
        ...{ state, view, time: () => time.value, moves: () => clock.value },
        server: {
            fetch: (path) => {
                files.push(path);
                return Promise.resolve(
                    path.includes('field=none') ? new Response('gone', { status: 404 }) : new Response('<VTKFile'),
                );
            },
        },
        scene: {
            body: {
                setColours: (colours) => void coloured.push(colours),
                setValues: (values) => void shown.push(values?.flow[0] ?? null),
                setTime: (by) => void moved.push(by),
            },
        },
        worker: {
            bodyValues: (_dataset, _lattice, at, field) => {
                asked.push(at);
                fields.push(field);
                return new Promise((resolve, reject) => {
                    waiting.push({
                        answer: () =>
                            resolve({
                                flow: Float32Array.of(at),
                                field: field === '' ? null : Float32Array.of(at, Number.NaN, 3 * at),
                            }),
                        fail: () => reject(new Error('too busy')),
                    });
                });
            },
        },
    });
    shown.length = 0;
    const answer = async (how: 'answer' | 'fail' = 'answer') => {
        waiting.shift()![how]();
        await rested();
    };
    return { state, view, time, clock, asked, fields, files, coloured, shown, moved, bodyFields, answer };
}

describe('the values along the body', () => {
    it('is asked for only while it is wanted, and goes when it is not', async () => {
        const { view, time, asked, shown, bodyFields, answer } = bench();
        time.value = 2;
        expect([asked, bodyFields.status.value]).toEqual([[], 'off']);
        view.body.value = { ...plainBody, texture: true };
        expect([asked, bodyFields.status.value]).toEqual([[2], 'waiting']);
        await answer();
        expect([shown, bodyFields.status.value]).toEqual([[2], 'shown']);
        view.body.value = plainBody;
        expect([shown, bodyFields.status.value]).toEqual([[2, null], 'off']);
    });

    it('is asked for once at a time, and then at the newest of the times that came meanwhile', async () => {
        const { view, time, clock, asked, shown, moved, bodyFields, answer } = bench();
        view.body.value = { ...plainBody, texture: true };
        for (const at of [2, 3, 4]) time.value = at;
        expect(asked).toEqual([1]);
        await answer();
        expect([asked, shown, bodyFields.status.value]).toEqual([[1, 4], [1], 'waiting']);
        await answer();
        expect([asked, shown, bodyFields.status.value]).toEqual([[1, 4], [1, 4], 'shown']);
        // The texture goes on meanwhile, and stands where there is no clock.
        clock.value = false;
        expect(moved).toEqual([1, 2, 3, 4, null]);
    });

    it('is asked for again where the server is late with it, at the newest time', async () => {
        const { state, view, time, asked, shown, answer } = bench();
        vi.useFakeTimers();
        view.body.value = { ...plainBody, texture: true };
        time.value = 3;
        await vi.advanceTimersByTimeAsync(lateMs);
        vi.useRealTimers();
        const [[about, words]] = [...state.notices.all.value] as [[string, string]];
        expect(words).toContain('has not sent the values along the body');
        state.notices.remedyOf(about)!.act();
        await rested();
        await answer();
        expect([asked, shown]).toEqual([[1, 3], []]);
        await answer();
        expect([asked, shown, state.notices.all.value.size]).toEqual([[1, 3], [3], 0]);
    });

    it('is that of the time nearest to the data, and one for all times where it stands still', async () => {
        const { view, time, asked, answer } = bench();
        time.value = 12;
        view.body.value = { ...plainBody, texture: true };
        await answer();
        time.value = 13;
        expect(asked).toEqual([10]);
        const still = bench({ steady: true, times: [0] });
        still.time.value = 3;
        still.view.body.value = { ...plainBody, texture: true };
        await still.answer();
        still.time.value = 4;
        expect(still.asked).toEqual([0]);
    });

    it('is said not to come, and asked for again at another time alone', async () => {
        const { state, view, time, asked, bodyFields, answer } = bench();
        view.body.value = { ...plainBody, texture: true };
        await answer('fail');
        expect([asked, bodyFields.status.value]).toEqual([[1], 'failed']);
        expect(state.notices.all.value.get('body values')).toBe('too busy');
        time.value = 2;
        await answer();
        expect([asked, bodyFields.status.value]).toEqual([[1, 2], 'shown']);
        expect(state.notices.all.value.size).toBe(0);
    });

    it('colour it by the field that is chosen, over what there has been of it on the body, unless a range is locked', async () => {
        const { view, time, asked, fields, coloured, bodyFields, answer } = bench({ surfaceFields: ['p'] });
        view.body.value = { ...plainBody, colourBy: 'field:of other data' };
        expect([asked, bodyFields.status.value]).toEqual([[], 'off']);
        view.body.value = { ...plainBody, colourBy: 'field:p', contours: true };
        expect([asked, fields]).toEqual([[1], ['p']]);
        await answer();
        expect(bodyFields.span.value).toEqual({ field: 'p', map: 'viridis', colours: [1, 3], beyond: [null, null] });
        expect(coloured.at(-1)).toEqual({ map: 'viridis', inverted: false, range: [1, 3], contourStep: 0.2 });
        time.value = 0.5; // values from 0.5 to 1.5
        await answer();
        expect(bodyFields.span.value?.colours).toEqual([0.5, 3]);
        view.body.value = { ...view.body.value, range: [0, 2], invert: true, contours: false };
        expect(coloured.at(-1)).toEqual({ map: 'viridis', inverted: true, range: [0, 2], contourStep: 0 });
        view.body.value = plainBody;
        expect(bodyFields.span.value).toBeNull();
    });

    it('lie between their ends without the last hundredth, where a few are far larger', () => {
        const values = Float32Array.from({ length: 1001 }, (_, i) => (i === 1000 ? 5000 : i));
        expect(extentOf(values)).toEqual({ least: 0, greatest: 5000, most: [10, 990] });
        expect(extentOf(Float32Array.of(Number.NaN))).toBeNull();
    });

    it('waits for the connection, and for other data asks again', async () => {
        const { state, view, asked, shown, answer } = bench();
        state.stage.value = 'starting';
        view.body.value = { ...plainBody, texture: true };
        expect(asked).toEqual([]);
        state.stage.value = 'running';
        expect(asked).toEqual([1]);
        state.dataset.value = datasetOf({ dataset: 'other', obstacle: true, times: [0, 10] });
        await answer();
        expect([asked, shown]).toEqual([[1, 1], []]);
        await answer();
        expect(shown).toEqual([1]);
        state.dataset.value = datasetOf({ dataset: 'empty', obstacle: false });
        expect(shown).toEqual([1, null]);
    });
});

describe('the file of the body', () => {
    it('has the field and the time that are shown, and the patches that were fetched', async () => {
        const { state, view, time, files, bodyFields } = bench();
        time.value = 2;
        expect(await (await bodyFields.file(new AbortController().signal))?.text()).toBe('<VTKFile');
        state.dataset.value = { ...state.dataset.value!, patches: [{ name: 'inlet', kind: 'other', triangles: 2 }] };
        view.body.value = { ...view.body.value, colourBy: 'speed', patches: ['inlet (other)'] };
        await bodyFields.file(new AbortController().signal);
        const { dataset, velocity } = state.dataset.value;
        expect(files.map((path) => path.replace(`api/v1/datasets/${dataset}/body.vtp?`, ''))).toEqual([
            '',
            `field=${velocity}&time=2&patches=all`,
        ]);
    });
});
