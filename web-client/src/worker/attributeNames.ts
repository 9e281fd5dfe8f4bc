// Says what the attributes of a surface's frames are called. Frames carry numbers alone; which ones depends
// on the fields that the surface had at their epoch.

/** protocol/wire/README.md, Attributes: these come first, then the surface's fields. */
export const everySurface: readonly string[] = ['speed', 's', 't'];
const epochsKept = 8;

export class AttributeNames {
    private readonly known = new Map<string, Map<number, readonly string[]>>();

    learn(surface: string, epoch: number, names: readonly string[]): void {
        const epochs = this.known.get(surface) ?? new Map<number, readonly string[]>();
        this.known.set(surface, epochs.set(epoch, names));
        const [oldest] = [...epochs.keys()].sort((a, b) => a - b);
        if (epochs.size > epochsKept && oldest !== undefined) epochs.delete(oldest);
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
