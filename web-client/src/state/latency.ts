// From an edit to the picture of its surface. The server's answer to an edit names the epochs it
// started; the frame that shows one of them ends the measurement.

const samplesKept = 2000;

export interface LatencySample {
    surface: string;
    epoch: number;
    milliseconds: number;
}

export class LatencyLog {
    readonly samples: LatencySample[] = [];
    private readonly editedAt = new Map<string, number>();
    private readonly shownAt = new Map<string, number>();

    /** The server has answered an edit that the user made at `time`. */
    answered(surface: string, epoch: number, time: number): void {
        const key = keyOf(surface, epoch);
        const shown = this.shownAt.get(key);
        if (shown !== undefined) this.add(surface, epoch, shown - time);
        else remember(this.editedAt, key, time);
    }

    /** A frame with this state is on the screen. Only the first of an epoch counts. */
    shown(surface: string, epoch: number, time: number): void {
        const key = keyOf(surface, epoch);
        if (this.shownAt.has(key)) return;
        remember(this.shownAt, key, time);
        const edited = this.editedAt.get(key);
        if (edited !== undefined) this.add(surface, epoch, time - edited);
    }

    private add(surface: string, epoch: number, milliseconds: number): void {
        this.editedAt.delete(keyOf(surface, epoch));
        this.samples.push({ surface, epoch, milliseconds });
        if (this.samples.length > samplesKept) this.samples.shift();
    }
}

function keyOf(surface: string, epoch: number): string {
    return `${surface} ${epoch}`;
}

function remember(map: Map<string, number>, key: string, time: number): void {
    map.set(key, time);
    if (map.size <= samplesKept) return;
    const oldest = map.keys().next().value;
    if (oldest !== undefined) map.delete(oldest);
}
