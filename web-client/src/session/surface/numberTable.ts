// The numbers of a surface as the server writes them: CSV with a line of names and units, and one row a time.
import { normalNames } from '../../mesh/meshChange.ts';
import type { DatasetDescription, SurfaceRecord } from '../../protocol/messages.ts';
import { flowNames } from '../../scene/surface/surfaceMesh.ts';
import { intervalError, twinDistance, twinLag } from '../picture/surfaceStyleOf.ts';

/** Returns the fields whose means are asked for: the velocity, for the speed, and what the surface carries for its colours. */
export function averagedFields(dataset: DatasetDescription | null, { fields }: Pick<SurfaceRecord, 'fields'>): string[] {
    const others: readonly string[] = [...normalNames, ...flowNames, twinDistance, twinLag, intervalError];
    const velocity = dataset === null ? [] : [dataset.velocity];
    return [...new Set([...velocity, ...fields.filter((name) => !others.includes(name))])];
}

export interface NumberTable {
    /** Name of a number to its unit, empty where it has none; in the order of the columns. */
    units: ReadonlyMap<string, string>;
    /** NaN where a number is not known. */
    rows: readonly ReadonlyMap<string, number>[];
    /** Why numbers are not known, for each row. */
    notes: readonly string[];
}

/** Splits CSV as RFC 4180 has it. */
function cells(text: string): string[][] {
    const rows: string[][] = [];
    let row: string[] = [];
    for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r?\n|$)/g)) {
        if (end === '' && row.length === 0 && plain === '') break; // behind the last line
        row.push(quoted?.replaceAll('""', '"') ?? plain ?? '');
        if (end !== ',') {
            rows.push(row);
            row = [];
        }
    }
    return rows;
}

export function readNumbers(csv: string): NumberTable {
    const [head = [], ...rows] = cells(csv);
    const columns = head.slice(0, -1).map((word) => /^(.*?)(?: \[(.*)\])?$/s.exec(word) ?? ['', word, '']);
    return {
        units: new Map(columns.map(([, name = '', unit = '']) => [name, unit])),
        rows: rows.map((row) => new Map(columns.map(([, name = ''], i) => [name, row[i] ? Number(row[i]) : Number.NaN]))),
        notes: rows.map((row) => row.at(-1) ?? ''),
    };
}
