// Says what the numbers of the data mean: names of units, which are written and never computed with.

export interface Units {
    length: string;
    time: string;
}

/** Not known. */
export const noUnits: Units = { length: '', time: '' };
