// A plot as a file of numbers: a line of names and units, and a row for each place. Twin of Series.to_csv in python/wakesurf/series.py.
import { columnsOf, type Plot, titleOf } from './plot.ts';

export function plotCsv(plot: Plot): string {
    const columns = columnsOf(plot);
    const rows = plot.x.values.map((_, i) => columns.map(({ values }) => numberText(values[i] ?? Number.NaN)).join(','));
    return [columns.map((column) => quoted(titleOf(column))).join(','), ...rows, ''].join('\n');
}

/** As RFC 4180 has it. */
function quoted(text: string): string {
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function numberText(value: number): string {
    return Number.isFinite(value) ? String(value) : '';
}
