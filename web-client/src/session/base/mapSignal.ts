// Maps in signals, of which one entry changes.
import type { Signal } from '@preact/signals-core';

/** Sets an entry, or takes it away; the signal changes only where the entry is another. @param value null: none */
export function putInto<V>(map: Signal<ReadonlyMap<string, V>>, id: string, value: V | null): void {
    if ((map.peek().get(id) ?? null) === value) return;
    const next = new Map(map.peek());
    if (value === null) next.delete(id);
    else next.set(id, value);
    map.value = next;
}
