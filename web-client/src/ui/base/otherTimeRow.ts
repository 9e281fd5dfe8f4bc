// A row for a time that is told from another: the same, so much later, or a time of its own.
import { html, nothing, type TemplateResult } from 'lit';
import type { OtherTime } from '../../session/time/otherTime.ts';
import { numberField, selectRow } from './rows.ts';

const kinds = [
    { value: 'same', words: 'same time' },
    { value: 'offset', words: 'later by' },
    { value: 'at', words: 'at' },
] as const;

export interface OtherTimeRow {
    id: string;
    words: string;
    /** Left out: it may be the same time. */
    maySame?: boolean;
    chosen: OtherTime;
    /** What it begins with where a number is chosen. */
    first: { by: number; time: number };
    written: (time: number) => string;
    change: (chosen: OtherTime) => void;
}

export function otherTimeRow({ id, words, maySame = true, chosen, first, written, change }: OtherTimeRow): TemplateResult {
    const choose = (kind: OtherTime['kind']): void => {
        change(kind === 'offset' ? { kind, by: first.by } : kind === 'at' ? { kind, time: first.time } : { kind });
    };
    const number = chosen.kind === 'offset' ? chosen.by : chosen.kind === 'at' ? chosen.time : null;
    return html`${selectRow(id, words, kinds.slice(maySame ? 0 : 1), chosen.kind, choose)}
    ${
        number === null
            ? nothing
            : numberField({
                  ...{
                      id: `${id}-number`,
                      label: `${words} ${chosen.kind === 'offset' ? 'later by' : 'at'}`,
                      shown: written(number),
                  },
                  change: (typed) =>
                      change(chosen.kind === 'offset' ? { kind: 'offset', by: typed } : { kind: 'at', time: typed }),
              })
    }`;
}
