// From an edit to the picture of its surface, and where the time went. The server's answer to an edit names
// the epochs it started; the frame that shows one of them ends the measurement.
import type { PassSeconds } from '../protocol/messages.ts';

const maxSamples = 2000;

/** In order; together they are the whole. */
export const latencyParts = ['network', 'queue', 'load', 'compute', 'encode', 'decode', 'draw', 'rest'] as const;
export type LatencyPart = (typeof latencyParts)[number];

export interface LatencySample {
    surface: string;
    epoch: number;
    milliseconds: number;
    /** Milliseconds; `rest` is waiting for the next frame, and what is not measured. */
    parts: Record<LatencyPart, number>;
}

/** What is measured of a picture besides when it was there. */
export interface Drawn {
    decodeMs: number;
    drawMs: number;
    /** A message to the server and back; null: not known yet. */
    roundTripMs: number | null;
}

interface Shown extends Drawn {
    at: number;
}

export class LatencyLog {
    readonly samples: LatencySample[] = [];
    private readonly editedAt = new Map<string, number>();
    private readonly shownAt = new Map<string, Shown>();
    private readonly passes = new Map<string, PassSeconds>();

    /** The server has answered an edit that the user made at `time`. */
    answered(surface: string, epoch: number, time: number): void {
        const key = keyOf(surface, epoch);
        const shown = this.shownAt.get(key);
        if (shown !== undefined) this.add(surface, epoch, time, shown);
        else remember(this.editedAt, key, time);
    }

    /** Takes what the first pass of an epoch took on the server. */
    passed(surface: string, epoch: number, seconds: PassSeconds): void {
        const key = keyOf(surface, epoch);
        if (!this.passes.has(key)) remember(this.passes, key, seconds);
    }

    /** A frame with this state is on the screen. Only the first of an epoch counts. */
    shown(surface: string, epoch: number, at: number, drawn: Drawn): void {
        const key = keyOf(surface, epoch);
        if (this.shownAt.has(key)) return;
        const shown = { at, ...drawn };
        remember(this.shownAt, key, shown);
        const edited = this.editedAt.get(key);
        if (edited !== undefined) this.add(surface, epoch, edited, shown);
    }

    private add(surface: string, epoch: number, edited: number, shown: Shown): void {
        const key = keyOf(surface, epoch);
        this.editedAt.delete(key);
        const milliseconds = shown.at - edited;
        const pass = this.passes.get(key) ?? { queue: 0, load: 0, compute: 0, encode: 0 };
        const measured = {
            network: shown.roundTripMs ?? 0,
            queue: 1000 * pass.queue,
            load: 1000 * pass.load,
            compute: 1000 * pass.compute,
            encode: 1000 * pass.encode,
            decode: shown.decodeMs,
            draw: shown.drawMs,
        };
        const sum = Object.values(measured).reduce((total, each) => total + each, 0);
        this.samples.push({ surface, epoch, milliseconds, parts: { ...measured, rest: Math.max(0, milliseconds - sum) } });
        if (this.samples.length > maxSamples) this.samples.shift();
    }
}

function keyOf(surface: string, epoch: number): string {
    return `${surface} ${epoch}`;
}

function remember<Value>(map: Map<string, Value>, key: string, value: Value): void {
    map.set(key, value);
    if (map.size <= maxSamples) return;
    const oldest = map.keys().next().value;
    if (oldest !== undefined) map.delete(oldest);
}
