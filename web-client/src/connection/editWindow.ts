// Edits on their way to the server: at most one is sent a frame, at most four are unanswered, and
// of those still waiting only the newest counts. A queue of edits never forms (docs/measurements.md, Edits in
// flight).

const editsInFlight = 4;

export interface EditWindowOptions<T> {
    /** Settles when the server has answered; must not reject. */
    send: (edit: T) => Promise<void>;
    /** Asks for `flush` at the next frame. */
    requestFlush: () => void;
    /** Called whenever `busy` may have changed. */
    onChange: () => void;
}

export class EditWindow<T> {
    private readonly options: EditWindowOptions<T>;
    private waiting: { edit: T } | null = null;
    private inFlight = 0;

    constructor(options: EditWindowOptions<T>) {
        this.options = options;
    }

    /** True while the server has not answered the newest edit. */
    get busy(): boolean {
        return this.waiting !== null || this.inFlight > 0;
    }

    submit(edit: T): void {
        this.waiting = { edit };
        this.options.onChange();
        this.options.requestFlush();
    }

    /** Called once a frame. */
    flush(): void {
        if (this.waiting === null || this.inFlight >= editsInFlight) return;
        const { edit } = this.waiting;
        this.waiting = null;
        ++this.inFlight;
        void this.options.send(edit).finally(() => {
            --this.inFlight;
            this.options.onChange();
            if (this.waiting !== null) this.options.requestFlush();
        });
    }
}
