// What was refused or has failed, in words, by what it was about: that one thing works again takes away what was said of it,
// and of nothing else.
import { signal } from '@preact/signals-core';

export class Problems {
    readonly all = signal<ReadonlyMap<string, string>>(new Map());

    /** @param about the record or control concerned; the newest words about it count */
    say(about: string, words: string): void {
        if (this.all.value.get(about) !== words) this.all.value = new Map(this.all.value).set(about, words);
    }

    tell(about: string, error: unknown): void {
        this.say(about, error instanceof Error ? error.message : String(error));
    }

    solved(about: string): void {
        if (!this.all.value.has(about)) return;
        const rest = new Map(this.all.value);
        rest.delete(about);
        this.all.value = rest;
    }
}
