// Names that others have written, in a line with words of the page.

/** Letters of scripts that are written from right to left, and signs that turn the direction of writing. */
const turning =
    /[\u0590-\u08ff\u200e\u200f\u202a-\u202e\u2066-\u2069\ufb1d-\ufdff\ufe70-\ufefe\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;
const signs = /[\u200e\u200f\u202a-\u202e\u2066-\u2069]/g;

/** So that what is beside it stays where it is, whatever the name has: between signs that isolate it (Unicode Standard Annex 9). */
export function isolated(name: string): string {
    return turning.test(name) ? `\u2068${name.replace(signs, '')}\u2069` : name;
}
