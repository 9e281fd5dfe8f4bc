// The colours of things that show a field where nobody has chosen any, and what they mean: all that show one field have the same, whose
// range only widens while places and times move, so that colours do not flicker.
import { signal } from '@preact/signals-core';
import { coloursOf, type UsualColours } from './usualColours.ts';

export interface FieldMeaning extends UsualColours {
    field: string;
}

export class FieldColours {
    /** By id of the thing. */
    readonly meanings = signal<ReadonlyMap<string, FieldMeaning>>(new Map());
    /** Between which values of a field lie, by field, as far as things have shown. */
    private readonly spans = new Map<string, [number, number]>();
    /** Of the other half of a comparison, which is to have the same ones. */
    private other: FieldColours | null = null;

    /** From now on colours mean the same in both. @param other null: no more */
    join(other: FieldColours | null): void {
        this.other = other;
        for (const [field, span] of other?.spans ?? []) this.widen(field, span);
    }

    private widen(field: string, by: readonly [number, number]): void {
        const [first] = [...this.meanings.peek()].find(([, meaning]) => meaning.field === field) ?? [];
        if (first !== undefined) this.show(first, field, by);
    }

    /** A thing shows a field. @param usual between which its values lie; null: it has none
     *  Returns whether all that show the field have other colours now. */
    show(id: string, field: string, usual: readonly [number, number] | null): boolean {
        const before = this.spans.get(field);
        const beside = this.other?.spans.get(field);
        const known = beside === undefined ? before : joined(before, beside);
        const wider = usual === null ? known : joined(known, usual);
        const changed = JSON.stringify(wider) !== JSON.stringify(before);
        if (wider !== undefined) this.spans.set(field, wider);
        const meanings = new Map(this.meanings.peek());
        const shown = [
            id,
            ...[...meanings].filter(([each, meaning]) => each !== id && meaning.field === field).map(([each]) => each),
        ];
        for (const each of shown) {
            if (wider === undefined) meanings.delete(each);
            else meanings.set(each, { field, ...coloursOf(...wider) });
        }
        this.publish(meanings);
        if (changed && wider !== undefined) this.other?.widen(field, wider);
        return changed;
    }

    forget(id: string): void {
        const meanings = new Map(this.meanings.peek());
        if (meanings.delete(id)) this.publish(meanings);
    }

    private publish(meanings: ReadonlyMap<string, FieldMeaning>): void {
        if (JSON.stringify([...meanings]) !== JSON.stringify([...this.meanings.peek()])) this.meanings.value = meanings;
        // A field that is shown again begins with what is seen then.
        const shown = new Set([...meanings.values()].map(({ field }) => field));
        for (const each of this.spans.keys()) if (!shown.has(each)) this.spans.delete(each);
    }
}

function joined(a: readonly [number, number] | undefined, b: readonly [number, number]): [number, number] {
    return a === undefined ? [...b] : [Math.min(a[0], b[0]), Math.max(a[1], b[1])];
}
