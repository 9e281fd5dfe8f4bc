// Which edits are one act of the user's: a slider that is moved, a handle that is dragged, a button that
// makes two records, a film that plays. The server takes back as one what bears one name
// (protocol/api/README.md, "Gestures").

/** Edits of one slider that follow each other faster are one act, as the wheel and the arrow keys move it. */
const pauseMs = 1000;

export class Gestures {
    /** Names of another page's life must differ, because the server may still have its last one. */
    private readonly page = Math.floor(performance.timeOrigin).toString(36);
    private count = 0;
    private newest = { what: '', at: Number.NEGATIVE_INFINITY, press: 0 };
    private presses = 0;
    private held = false;
    private readonly begun: () => void;

    /** @param begun told of each act as it begins */
    constructor(begun: () => void = () => undefined) {
        this.begun = begun;
    }

    /** A key or a button of the mouse goes down: as long as it is held, what it does is one act. */
    press(): void {
        ++this.presses;
        this.held = true;
    }

    release(): void {
        this.held = false;
    }

    /** The name of an act that begins. */
    begin(): string {
        return this.started('', Number.NEGATIVE_INFINITY);
    }

    /** Joins what goes on by itself, as playing does, to whatever its user does meanwhile. */
    get current(): string {
        return `${this.page}.${this.count}`;
    }

    /** Names the act of a button, or a key that repeats: another press is another act. */
    pressed(what: string, at: number): string {
        return this.continues(what) ? this.current : this.started(what, at);
    }

    /** Names the act of a slider or field that many edits come from. */
    slid(what: string, at: number): string {
        const goesOn = this.continues(what) || (this.newest.what === what && at - this.newest.at < pauseMs);
        if (!goesOn) return this.started(what, at);
        // A hold that goes on with what was just done is of one piece with it, however long it rests later.
        this.newest = { what, at, press: this.presses };
        return this.current;
    }

    private continues(what: string): boolean {
        return this.held && this.newest.what === what && this.newest.press === this.presses;
    }

    private started(what: string, at: number): string {
        this.newest = { what, at, press: this.presses };
        ++this.count;
        this.begun();
        return this.current;
    }
}
