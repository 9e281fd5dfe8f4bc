import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { lateMs, LateWaits } from './lateWaits.ts';

let told: boolean[];
let waits: LateWaits;
let asked: { answer: (value: number) => void; signal: AbortSignal }[];

beforeEach(() => {
    vi.useFakeTimers();
    [told, asked] = [[], []];
    waits = new LateWaits((late) => told.push(late));
});

afterEach(() => {
    vi.useRealTimers();
});

const ask = (signal: AbortSignal): Promise<number> => new Promise((answer) => asked.push({ answer, signal }));

it('whoever waits long is told, and no more once the answer is there', async () => {
    const found = waits.until(ask);
    await vi.advanceTimersByTimeAsync(lateMs - 1);
    expect(told).toEqual([]);
    await vi.advanceTimersByTimeAsync(1);
    expect(told).toEqual([true]);
    asked[0]!.answer(7);
    expect(await found).toBe(7);
    expect(told).toEqual([true, false]);
});

it('what is late is asked for again, what is not goes on, and an old answer is none', async () => {
    const found = waits.until(ask);
    await vi.advanceTimersByTimeAsync(lateMs);
    const other = waits.until(ask);
    waits.again();
    await vi.advanceTimersByTimeAsync(0);
    expect(asked.map(({ signal }) => signal.aborted)).toEqual([true, false, false]);
    expect(told).toEqual([true, false]);
    asked[0]!.answer(1);
    asked[1]!.answer(2);
    asked[2]!.answer(3);
    expect([await found, await other]).toEqual([3, 2]);
});

it('what is not wanted any more is not asked for again', async () => {
    const ended = new AbortController();
    const found = waits.until(ask, ended.signal);
    const failed = expect(found).rejects.toThrow('Given up');
    await vi.advanceTimersByTimeAsync(lateMs);
    ended.abort();
    await failed;
    expect([told, asked.length, asked[0]!.signal.aborted]).toEqual([[true, false], 1, true]);
});
