// The numbers of a surface over time, as lines of a plot.
import { type NumberTable } from '../surface/numberTable.ts';
import type { Plot, Series } from './plot.ts';
import type { Quantity } from './quantities.ts';

/** What is a number's own error, or a time, is no line. */
const noLine = /^(?!(inside_)?mean_).*_error$|^(time|age|from|to)$/;

/** Those that are known at some time. */
export function quantitiesIn({ units, rows }: NumberTable): Quantity[] {
    return [...units]
        .filter(([name]) => !noLine.test(name) && rows.some((row) => Number.isFinite(row.get(name))))
        .map(([name, unit]) => ({ name, unit, group: unit === '' ? `number ${name}` : unit }));
}

export function plotOfNumbers(table: NumberTable, quantities: readonly Quantity[], title: string): Plot {
    // The times of a stream surface are ages of its particles.
    const first = table.units.has('age') ? 'age' : 'time';
    const at = (row: ReadonlyMap<string, number> | undefined): number => row?.get(first) ?? Number.NaN;
    // Those of a backward surface descend.
    const rows = at(table.rows.at(-1)) < at(table.rows[0]) ? table.rows.toReversed() : table.rows;
    const column = (name: string): number[] => rows.map((row) => row.get(name) ?? Number.NaN);
    // Why something is not known says something of a plot only where that is drawn.
    const unknown = table.rows.map((row) => quantities.some(({ name }) => !Number.isFinite(row.get(name))));
    return {
        title,
        x: { name: first, unit: table.units.get(first) ?? '', values: column(first) },
        places: [],
        series: quantities.map((each): Series => ({ ...each, values: column(each.name) })),
        notes: [...new Set(table.notes.filter((note, i) => note !== '' && unknown[i] === true))],
    };
}
