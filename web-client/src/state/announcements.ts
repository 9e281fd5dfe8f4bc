// What is said to the user over the picture, by what it is about: the newest words about a thing count, and go when that thing is well
// again or they are sent away; what is said of other things stays. Names that others have written are fenced off in it.
import { signal } from '@preact/signals-core';

/** What can be done about it, at once. */
export interface Remedy {
    label: string;
    act: () => void;
}

/** Until the next edit, or until anything is pressed. */
export type Passing = 'edit' | 'press';

export class Announcements {
    readonly all = signal<ReadonlyMap<string, string>>(new Map());
    private readonly remedies = new Map<string, Remedy>();
    /** What is said of something that was done, and is old news after the next. */
    private readonly passing = new Map<string, Passing>();

    /** @param about the record or control concerned, or the kind of a notice */
    say(about: string, words: string, remedy: Remedy | null = null): void {
        this.passing.delete(about);
        if (remedy === null) this.remedies.delete(about);
        else this.remedies.set(about, remedy);
        if (this.all.value.get(about) !== words) this.all.value = new Map(this.all.value).set(about, words);
    }

    tell(about: string, error: unknown, remedy: Remedy | null = null): void {
        this.say(about, error instanceof Error ? error.message : String(error), remedy);
    }

    /** Goes by itself with the next act of that kind. */
    sayUntil(passing: Passing, about: string, words: string, remedy: Remedy | null = null): void {
        this.say(about, words, remedy);
        this.passing.set(about, passing);
    }

    /** The next act: what was said of those before is no news. */
    passed(act: Passing): void {
        for (const [about, until] of this.passing) if (until === act) this.solved(about);
    }

    remedyOf(about: string): Remedy | undefined {
        return this.remedies.get(about);
    }

    solved(about: string): void {
        this.passing.delete(about);
        if (!this.all.value.has(about)) return;
        const rest = new Map(this.all.value);
        rest.delete(about);
        this.remedies.delete(about);
        this.all.value = rest;
    }
}

/** Letters of scripts that are written from right to left, and signs that turn the direction of writing. */
const turning =
    /[\u0590-\u08ff\u200e\u200f\u202a-\u202e\u2066-\u2069\ufb1d-\ufdff\ufe70-\ufefe\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;
const signs = /[\u200e\u200f\u202a-\u202e\u2066-\u2069]/g;

/** So that what is beside it stays where it is, whatever the name has: between signs that isolate it (Unicode Standard Annex 9). */
export function isolated(name: string): string {
    return turning.test(name) ? `\u2068${name.replace(signs, '')}\u2069` : name;
}
