// Records that are drawn as this page edits them before the server has answered, which is told the newest edit of each and no other:
// slices, lines.
import { effect, type ReadonlySignal, signal, untracked } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import { announceUnlessDisconnected } from '../base/calls.ts';
import type { Edits } from './edits.ts';
import type { TurnAlong } from './undoHistory.ts';

export interface RecordDraftsOptions<R extends { dataset: string }, P extends object> {
    state: Pick<AppState, 'dataset' | 'described' | 'pictured' | 'problems'>;
    edits: Pick<Edits, 'addFollower' | 'gestures' | 'history' | 'onMove'>;
    /** As methods call them. */
    noun: 'slice' | 'lines';
    records: ReadonlySignal<ReadonlyMap<string, R>>;
    /** What says how it is coloured: each half of a comparison has its own. */
    own: readonly (keyof P)[];
    /** Returns what can be edited: not what the server alone writes. */
    placeOf: (record: R) => P;
    /** Tells the server. @param id undefined: a new one. Returns its id. */
    set: (id: string | undefined, dataset: string, place: P, gesture: string) => Promise<string>;
    remove: (id: string, gesture: string) => Promise<unknown>;
    /** One is not in the picture any more. */
    gone: (id: string) => void;
}

export class RecordDrafts<R extends { dataset: string }, P extends object> {
    /** Those of the data in the picture, as they are drawn. */
    readonly places = signal<ReadonlyMap<string, P>>(new Map());
    private readonly options: RecordDraftsOptions<R, P>;
    private readonly drafts = new Map<string, P>();
    private readonly acts = new Map<string, { gesture: string; along: TurnAlong | null }>();
    private readonly sending = new Set<string>();

    constructor(options: RecordDraftsOptions<R, P>) {
        this.options = options;
        options.edits.addFollower(options.noun, (id, change, act) => this.draw(id, change, act));
        effect(() => {
            const records = options.records.value;
            void options.state.pictured.value;
            for (const [id, record] of records) if (!this.sending.has(id) && this.agrees(id, record)) this.drafts.delete(id);
            untracked(() => this.publish());
        });
    }

    /** What one that is added may be like: the chosen one, or the first, of the data that are worked on. */
    like(chosen: string | null): P | undefined {
        const { state, records } = this.options;
        const own = [...this.places.value].filter(([id]) => records.value.get(id)?.dataset === state.dataset.value?.dataset);
        return (own.find(([id]) => id === chosen) ?? own[0])?.[1];
    }

    /** Null: it was refused, and why is on the screen. */
    async add(place: P): Promise<string | null> {
        const { state, edits, noun, set } = this.options;
        const dataset = state.dataset.value?.dataset;
        if (dataset === undefined) return null;
        const gesture = edits.gestures.begin();
        try {
            const id = await set(undefined, dataset, place, gesture);
            edits.history.noted(gesture);
            state.problems.solved(`${noun}.set`);
            return id;
        } catch (error) {
            announceUnlessDisconnected(state.problems, `${noun}.set`, error);
            return null;
        }
    }

    /** Draws it so at once, and tells the server. */
    change(id: string, change: Partial<P>): void {
        const { edits, noun, own } = this.options;
        const isMoved = Object.keys(change).some((key) => !own.includes(key as keyof P));
        // Another field is another act than another place, also where one follows the other fast.
        const gesture = edits.gestures.slid(`${noun} ${id} ${Object.keys(change).join(' ')}`, performance.now());
        const along = isMoved ? edits.onMove?.({ noun, id }, without(change, own), gesture) : null;
        this.draw(id, change, { gesture, along: along ?? null });
    }

    private draw(id: string, change: Partial<P>, act: { gesture: string; along: TurnAlong | null }): void {
        const place = this.places.value.get(id);
        if (place === undefined) return;
        this.drafts.set(id, { ...place, ...change });
        this.acts.set(id, act);
        this.publish();
        if (!this.sending.has(id)) void this.send(id);
    }

    async remove(id: string): Promise<void> {
        const { state, edits, noun, remove } = this.options;
        const gesture = edits.gestures.begin();
        try {
            await remove(id, gesture);
            edits.history.noted(gesture);
        } catch (error) {
            announceUnlessDisconnected(state.problems, `${noun}.delete`, error);
        }
    }

    /** Of the edits of one record only the newest waits. */
    private async send(id: string): Promise<void> {
        const { state, edits, noun, records, set } = this.options;
        this.sending.add(id);
        try {
            for (let sent: P | undefined; sent !== this.drafts.get(id);) {
                sent = this.drafts.get(id)!;
                const dataset = records.value.get(id)?.dataset;
                // Someone has deleted it.
                if (dataset === undefined) break;
                const { gesture, along } = this.acts.get(id)!;
                await set(id, dataset, sent, gesture);
                edits.history.noted(gesture, along);
            }
            state.problems.solved(`${noun}.set`);
        } catch (error) {
            this.drafts.delete(id);
            announceUnlessDisconnected(state.problems, `${noun}.set`, error);
        }
        this.sending.delete(id);
        const record = records.value.get(id);
        if (record === undefined || this.agrees(id, record)) this.drafts.delete(id);
        this.publish();
    }

    /** The server has what this page draws, or nothing is drawn ahead. */
    private agrees(id: string, record: R): boolean {
        const draft = this.drafts.get(id);
        return draft === undefined || sameMembers(draft, this.options.placeOf(record));
    }

    private publish(): void {
        const { state, records, placeOf, gone } = this.options;
        const places = new Map<string, P>();
        for (const [id, record] of records.peek()) {
            if (state.described(record.dataset) !== null) places.set(id, this.drafts.get(id) ?? placeOf(record));
        }
        for (const id of this.places.peek().keys()) if (!places.has(id)) gone(id);
        this.places.value = places;
    }
}

function without<P extends object>(change: Partial<P>, left: readonly (keyof P)[]): Partial<P> {
    return Object.fromEntries(Object.entries(change).filter(([key]) => !left.includes(key as keyof P))) as Partial<P>;
}

/** In any order. */
function sameMembers(a: object, b: object): boolean {
    const text = (of: object): string => JSON.stringify(Object.entries(of).sort(([one], [other]) => (one < other ? -1 : 1)));
    return text(a) === text(b);
}
