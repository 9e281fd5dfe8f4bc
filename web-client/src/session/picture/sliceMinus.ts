// What a slice subtracts: the same field of another dataset, or of its own at another time. Of a record, of a request, and in words.
import type { SliceRecord } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import { type OtherTime, otherTime } from '../time/otherTime.ts';

export interface SliceMinus {
    /** Null: its own. */
    dataset: string | null;
    time: OtherTime;
}

type Members = Pick<SliceRecord, 'minus' | 'minusOffset' | 'minusTime'>;

/** Null: nothing. */
export function minusOf({ minus, minusTime, minusOffset }: Members): SliceMinus | null {
    if (minus === undefined && minusTime === undefined && minusOffset === undefined) return null;
    const time: OtherTime =
        minusTime !== undefined
            ? { kind: 'at', time: minusTime }
            : minusOffset !== undefined
              ? { kind: 'offset', by: minusOffset }
              : { kind: 'same' };
    return { dataset: minus ?? null, time };
}

export function membersOf(minus: SliceMinus | null): Members {
    if (minus === null) return {};
    const { dataset, time } = minus;
    return {
        ...(dataset === null ? {} : { minus: dataset }),
        ...(time.kind === 'at' ? { minusTime: time.time } : time.kind === 'offset' ? { minusOffset: time.by } : {}),
    };
}

/** As an address has it, and what colours of the difference are called. No time: its data have one. */
export interface MinusWish {
    dataset: string;
    time: number | null;
    words: string;
}

/** @param shown  when the slice is of; null: its data have one time */
export function minusWish(minus: SliceMinus, own: string, shown: number | null, nameOf: (dataset: string) => string): MinusWish {
    const { dataset, time } = minus;
    const then = shown === null && time.kind === 'same' ? null : otherTime(time, shown ?? 0);
    return { dataset: dataset ?? own, time: then, words: minusWords(minus, nameOf) };
}

export function minusWords({ dataset, time }: SliceMinus, nameOf: (dataset: string) => string): string {
    const then =
        time.kind === 'at'
            ? ` at t = ${shortNumber(time.time)}`
            : time.kind === 'offset'
              ? ` ${shortNumber(Math.abs(time.by))} ${time.by < 0 ? 'earlier' : 'later'}`
              : '';
    return `minus that${dataset === null ? '' : ` of ${nameOf(dataset)}`}${then}`;
}
