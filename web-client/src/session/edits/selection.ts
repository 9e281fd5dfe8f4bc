// Which rake and which surface the panel acts on. They belong together: a rake that is chosen brings one of
// its surfaces along, and a surface its rake; an isosurface has none.
import { batch } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';

/** Surfaces of a rake, in the order in which they were made. */
export function surfacesOf(state: AppState, rake: string | null): string[] {
    return [...state.surfaces.value.values()].filter((each) => each.rake === rake).map(({ surface }) => surface);
}

export class Selection {
    private readonly state: AppState;
    /** Holds for each rake the surface that was chosen last. */
    private readonly lastOf = new Map<string, string>();
    private surface: string | null = null;

    constructor(state: AppState) {
        this.state = state;
    }

    chooseRake(rake: string | null): void {
        const own = surfacesOf(this.state, rake);
        const last = this.lastOf.get(rake ?? '');
        this.set(rake, last !== undefined && own.includes(last) ? last : (own[0] ?? null));
    }

    chooseSurface(surface: string): void {
        const record = this.state.surfaces.value.get(surface);
        if (record !== undefined) this.set(record.rake ?? null, surface);
    }

    /** Another surface has been chosen elsewhere than here. */
    get overtaken(): boolean {
        return this.state.activeSurface.value !== this.surface;
    }

    /** After a change of the records: what is chosen is there, if anything is. */
    settle(): void {
        const { activeRake, activeSurface, rakes, surfaces } = this.state;
        const rake = activeRake.value ?? '';
        const surface = surfaces.value.get(activeSurface.value ?? '');
        // A link or a bookmark has chosen a surface: its rake comes with it.
        if (surface !== undefined && surface.surface !== this.surface) this.chooseSurface(surface.surface);
        else if (rakes.value.has(rake)) {
            if (surface?.rake !== rake) this.chooseRake(rake);
        } else if (surface === undefined || surface.rake !== undefined) this.chooseFirst();
    }

    private chooseFirst(): void {
        const { rakes, surfaces } = this.state;
        const there = [...surfaces.value.values()];
        const first = there.find(({ rake }) => rake !== undefined && rakes.value.has(rake));
        const rake = first?.rake ?? [...rakes.value.keys()][0] ?? null;
        const shown = rake === null ? there.find((each) => each.rake === undefined) : first;
        if (shown === undefined) this.chooseRake(rake);
        else this.set(rake, shown.surface);
    }

    private set(rake: string | null, surface: string | null): void {
        if (rake !== null && surface !== null) this.lastOf.set(rake, surface);
        this.surface = surface;
        batch(() => {
            this.state.activeRake.value = rake;
            this.state.activeSurface.value = surface;
        });
    }
}
