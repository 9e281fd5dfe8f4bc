// Reads a number as people type it, whatever their language and keyboard: with a comma or a point before its
// decimals, and spaces between groups of three digits.

const plainNumber = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** Returns the number; words say why it is none; null: nothing was typed. */
export function typedNumber(text: string): number | string | null {
    const typed = text.trim();
    if (typed === '') return null;
    const closed = typed.replaceAll('\u2212', '-').replace(/(?<=\d)\s(?=\d{3}(?!\d))|(?<=^[+-])\s+|\s+(?=e)|(?<=e)\s+/gi, '');
    const marks = closed.replace(/[^.,]/g, '');
    // With both, or several, nobody can tell thousands from decimals.
    if (marks.length > 1) return `${typed} is not clear: write the number with one comma or point, before its decimals.`;
    const plain = closed.replace(',', '.');
    const value = Number(plain);
    if (!plainNumber.test(plain) || !Number.isFinite(value)) return `${typed} is not a number.`;
    return value;
}
