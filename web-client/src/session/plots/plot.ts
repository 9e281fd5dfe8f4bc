// What a plot shows, as columns of numbers: along the lower axis, beside it for the file and the table, and as lines.

export interface Column {
    name: string;
    /** Empty: none, or not known. */
    unit: string;
    /** NaN: there is no value. */
    values: readonly number[];
}

/** A line of a plot. */
export interface Series extends Column {
    /** Lines of one group share an axis. */
    group: string;
}

export interface Plot {
    title: string;
    x: Column;
    /** Where and when the values are of, as far as `x` does not say it. */
    places: readonly Column[];
    series: readonly Series[];
    /** What is good to know of gaps. */
    notes: readonly string[];
}

/** Name and unit, as in the head of a file of numbers and beside an axis. */
export function titleOf({ name, unit }: Pick<Column, 'name' | 'unit'>): string {
    return unit === '' ? name : `${name} [${unit}]`;
}

export function columnsOf({ x, places, series }: Plot): Column[] {
    return [x, ...places, ...series];
}
