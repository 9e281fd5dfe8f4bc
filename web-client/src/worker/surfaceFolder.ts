// Folds the frames of all subscriptions into states. What the page has not taken yet waits here as a note of
// what has changed: a page that is slow or hidden gets the newest state when it asks, and no state in
// between.
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { MeshDecoder } from '../protocol/meshDecoder.ts';
import { surfaceOf } from '../protocol/meshFrame.ts';
import type { Subscription, SurfaceRecord } from '../protocol/messages.ts';
import { type CurveCells, DisplayArrays } from './displayArrays.ts';
import type { ShowWish, SurfaceState } from './workerMessages.ts';

/** One on its way to the screen, and one to be there at once afterwards. */
const maxPendingStates = 2;

/** After which a state without a successor stands still. */
const restMs = 250;

const firstWish: ShowWish = { attributes: ['speed'], parts: null, trimmed: true };

export interface UpdatePlace {
    epoch: number;
    seq: number;
}

export interface SurfaceFolderOptions {
    draco: DracoPoints;
    onState: (state: SurfaceState) => void;
    onApplied: (subscription: number, place: UpdatePlace) => void;
    onTrouble: (surface: string, subscription: number, reason: string) => void;
}

interface Followed {
    surface: string;
    decoder: MeshDecoder;
    display: DisplayArrays;
    pending: number;
    keys: number;
    deltas: number;
    /** Spent on what has not been offered yet. */
    decodeMs: number;
    changed: boolean;
    troubled: boolean;
    /** Until cells are curved. */
    rest: ReturnType<typeof setTimeout> | undefined;
}

export class SurfaceFolder {
    private readonly options: SurfaceFolderOptions;
    private readonly followed = new Map<string, Followed>();
    private readonly wishes = new Map<string, ShowWish>();
    private readonly names = new AttributeNames();
    /** Only of this connection; the states outlive it. */
    private readonly bySubscription = new Map<number, Followed>();

    constructor(options: SurfaceFolderOptions) {
        this.options = options;
    }

    /** Returns what a new subscription of the surface may go on from. */
    placeOf(surface: string): UpdatePlace | undefined {
        const decoder = this.followed.get(surface)?.decoder;
        if (decoder?.newest === undefined || decoder.mesh === undefined) return undefined;
        const { epoch, seq } = decoder.newest;
        return { epoch, seq };
    }

    subscribed(surface: string, agreed: Subscription): void {
        const { subscription, lattice, attributes, resumed } = agreed;
        this.names.learn(surface, agreed.epoch, attributes);
        const known = this.followed.get(surface);
        if (known !== undefined && resumed === true && this.placeOf(surface) !== undefined) {
            known.decoder.continueAs(subscription);
            this.bySubscription.set(subscription, known);
            return;
        }
        const display = new DisplayArrays(lattice, attributes);
        display.show(this.wishes.get(surface) ?? firstWish);
        const followed = {
            surface,
            decoder: new MeshDecoder(this.options.draco, lattice, null),
            display,
            pending: known?.pending ?? 0,
            keys: known?.keys ?? 0,
            deltas: known?.deltas ?? 0,
            decodeMs: 0,
            changed: false,
            troubled: false,
            rest: undefined,
        };
        this.followed.set(surface, followed);
        this.bySubscription.set(subscription, followed);
    }

    /** An edit of a surface's fields changes what its frames carry. */
    recorded({ surface, epoch, fields }: SurfaceRecord): void {
        this.names.learn(surface, epoch, [...everySurface, ...(fields ?? [])]);
    }

    /** Sends at once what is asked for and is here. */
    show(surface: string, wish: ShowWish): void {
        this.wishes.set(surface, wish);
        const followed = this.followed.get(surface);
        if (followed === undefined) return;
        if (followed.display.show(wish)) {
            followed.changed = true;
            this.offer(followed);
        } else if (wish.curved !== undefined) this.curveAtRest(followed);
    }

    forget(surface: string): void {
        this.wishes.delete(surface);
        this.names.forget(surface);
        const followed = this.followed.get(surface);
        this.followed.delete(surface);
        for (const [subscription, each] of this.bySubscription) {
            if (each === followed) this.bySubscription.delete(subscription);
        }
    }

    /** Subscriptions do not outlive the connection. */
    disconnected(): void {
        this.bySubscription.clear();
    }

    /** Another session, or a server that has forgotten it: its surfaces may be called the same. */
    forgetAll(): void {
        this.bySubscription.clear();
        this.followed.clear();
        this.names.clear();
    }

    /** The page has put a state on the screen. */
    taken(surface: string): void {
        const followed = this.followed.get(surface);
        if (followed === undefined) return;
        followed.pending = Math.max(0, followed.pending - 1);
        this.offer(followed);
    }

    receive(frame: Uint8Array): void {
        const subscription = surfaceOf(frame);
        const followed = subscription === undefined ? undefined : this.bySubscription.get(subscription);
        if (subscription === undefined || followed === undefined) return;
        const start = performance.now();
        try {
            const applied = followed.decoder.fold(frame);
            followed.decodeMs += performance.now() - start;
            if (applied === undefined) return;
            followed.troubled = false;
            followed.changed = true;
            if (applied.header.key) ++followed.keys;
            else ++followed.deltas;
            const { key, epoch, attributeCount } = applied.header;
            if (key) followed.display.rename(this.names.of(followed.surface, epoch, attributeCount));
            followed.display.note(applied);
            this.options.onApplied(subscription, applied.header);
        } catch (error) {
            // Frames that follow a damaged one fail too; one report is enough.
            if (followed.troubled) return;
            followed.troubled = true;
            const reason = error instanceof Error ? error.message : String(error);
            this.options.onTrouble(followed.surface, subscription, reason);
            return;
        }
        this.offer(followed);
    }

    /** Curves what is at rest; what moves stays flat: curved cells take as long as many states. */
    private curveAtRest(followed: Followed): void {
        clearTimeout(followed.rest);
        if (!followed.display.wantsCurves) return;
        followed.rest = setTimeout(() => {
            // A chunk of its own: few need it.
            import('./curvedCells.ts').then(
                ({ curvedChange }) => this.curve(followed, curvedChange),
                () => undefined,
            );
        }, restMs);
    }

    private curve(followed: Followed, curve: CurveCells): void {
        if (this.followed.get(followed.surface) !== followed || followed.changed) return;
        if (followed.pending >= maxPendingStates) return this.curveAtRest(followed);
        followed.changed = true;
        this.offer(followed, curve);
    }

    private offer(followed: Followed, curve: CurveCells | null = null): void {
        const { newest: header, mesh } = followed.decoder;
        if (!followed.changed || followed.pending >= maxPendingStates) return;
        if (header === undefined || mesh === undefined) return;
        followed.changed = false;
        ++followed.pending;
        const { epoch, phase, time, stateSum } = header;
        const { surface, keys, deltas, display } = followed;
        const { withheld } = display;
        const start = performance.now();
        const arrays = display.take(mesh, curve);
        const decodeMs = followed.decodeMs + performance.now() - start;
        followed.decodeMs = 0;
        this.options.onState({
            ...{ surface, epoch, phase, time, stateSum, cells: mesh.cellCount, meshVertices: mesh.vertices },
            ...{ keys, deltas, withheld, curved: display.curved, decodeMs },
            ...arrays,
        });
        if (curve === null) this.curveAtRest(followed);
    }
}

/** protocol/wire/README.md, Attributes: these come first, then the surface's fields. */
const everySurface: readonly string[] = ['speed', 's', 't'];
const rememberedEpochs = 8;

/**
 * The names of the attributes in a surface's frames, which carry numbers alone: they depend on the fields that the surface had
 * at their epoch.
 */
export class AttributeNames {
    private readonly known = new Map<string, Map<number, readonly string[]>>();

    learn(surface: string, epoch: number, names: readonly string[]): void {
        const epochs = this.known.get(surface) ?? new Map<number, readonly string[]>();
        this.known.set(surface, epochs.set(epoch, names));
        const [oldest] = [...epochs.keys()].sort((a, b) => a - b);
        if (epochs.size > rememberedEpochs && oldest !== undefined) epochs.delete(oldest);
    }

    /** Returns names of the `count` attributes of an epoch's frames: those that are known for sure. */
    of(surface: string, epoch: number, count: number): readonly string[] {
        const epochs = [...(this.known.get(surface) ?? [])].filter(([known]) => known <= epoch);
        const newest = epochs.sort(([a], [b]) => b - a)[0]?.[1];
        return newest?.length === count ? newest : everySurface.slice(0, count);
    }

    forget(surface: string): void {
        this.known.delete(surface);
    }

    clear(): void {
        this.known.clear();
    }
}
