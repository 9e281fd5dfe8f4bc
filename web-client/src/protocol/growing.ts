// A typed array that grows at its end by doubling, so that appending frames copies each number at
// most twice on average.

type Numbers = Float32Array | Int32Array | Uint32Array;

export class Growing<Kind extends Numbers> {
    private readonly make: new (length: number) => Kind;
    private room: Kind;
    private used = 0;

    constructor(make: new (length: number) => Kind) {
        this.make = make;
        this.room = new make(0);
    }

    /// What has been appended so far.
    get view(): Kind {
        return this.room.subarray(0, this.used) as Kind;
    }

    /// Appends `count` zeros and returns a view to overwrite them.
    extend(count: number): Kind {
        const before = this.used;
        this.used += count;
        if (this.used > this.room.length) {
            const room = new this.make(before === 0 ? this.used : Math.max(this.used, 2 * this.room.length));
            room.set(this.room);
            this.room = room;
        }
        return this.room.subarray(before, this.used) as Kind;
    }
}
