// The colours of things that show a field where nobody has chosen any, and what they mean: all that show one field have the same, whose
// range only widens while places and times move, so that colours do not flicker.
import { signal } from '@preact/signals-core';
import { coloursOf, coloursOfDifference, type UsualColours } from './usualColours.ts';

export interface FieldMeaning extends UsualColours {
    field: string;
    /** What is subtracted, in words; empty: nothing. */
    less: string;
}

/** Fields, of which something may be subtracted. */
type Shown = Pick<FieldMeaning, 'field' | 'less'>;

export class FieldColours {
    /** By id of the thing. */
    readonly meanings = signal<ReadonlyMap<string, FieldMeaning>>(new Map());
    /** Between which values of a field lie, as far as things have shown; by nameOf(). */
    private readonly spans = new Map<string, [number, number]>();
    /** Of the other half of a comparison, which is to have the same ones. */
    private other: FieldColours | null = null;

    /** From now on colours mean the same in both. @param other null: no more */
    join(other: FieldColours | null): void {
        this.other = other;
        for (const [name, span] of other?.spans ?? []) this.widen(name, span);
    }

    private widen(name: string, by: readonly [number, number]): void {
        const [first] = [...this.meanings.peek()].filter(([, meaning]) => nameOf(meaning) === name);
        if (first !== undefined) this.show(first[0], first[1].field, by, first[1].less);
    }

    /** A thing shows a field. @param usual between which its values lie; null: it has none
     *  Returns whether all that show the field have other colours now. */
    show(id: string, field: string, usual: readonly [number, number] | null, less = ''): boolean {
        const name = nameOf({ field, less });
        const before = this.spans.get(name);
        const beside = this.other?.spans.get(name);
        const known = beside === undefined ? before : joined(before, beside);
        const wider = usual === null ? known : joined(known, usual);
        const changed = JSON.stringify(wider) !== JSON.stringify(before);
        if (wider !== undefined) this.spans.set(name, wider);
        const meanings = new Map(this.meanings.peek());
        const others = [...meanings].filter(([each, meaning]) => each !== id && nameOf(meaning) === name);
        for (const each of [id, ...others.map(([other]) => other)]) {
            if (wider === undefined) meanings.delete(each);
            else meanings.set(each, { field, less, ...(less === '' ? coloursOf : coloursOfDifference)(...wider) });
        }
        this.publish(meanings);
        if (changed && wider !== undefined) this.other?.widen(name, wider);
        return changed;
    }

    forget(id: string): void {
        const meanings = new Map(this.meanings.peek());
        if (meanings.delete(id)) this.publish(meanings);
    }

    private publish(meanings: ReadonlyMap<string, FieldMeaning>): void {
        if (JSON.stringify([...meanings]) !== JSON.stringify([...this.meanings.peek()])) this.meanings.value = meanings;
        // A field that is shown again begins with what is seen then.
        const shown = new Set([...meanings.values()].map(nameOf));
        for (const each of this.spans.keys()) if (!shown.has(each)) this.spans.delete(each);
    }
}

function nameOf({ field, less }: Shown): string {
    return JSON.stringify([field, less]);
}

function joined(a: readonly [number, number] | undefined, b: readonly [number, number]): [number, number] {
    return a === undefined ? [...b] : [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
}
