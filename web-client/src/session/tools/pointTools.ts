// Tools that act on a point of what is seen: a surface, the body, a slice, a rake or the disc of a round one. In the open there is no such point,
// because a picture has no depth there. The probe shows what the flow does at a point, or where numbers say; the measure is the distance
// between two; a note has a place by a click, and words by a dialog.
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { ScreenPoint } from '../../scene/base/view.ts';
import type { PickHit } from '../../scene/surface/pickHit.ts';
import type { AppState } from '../../state/appState.ts';
import type { ProbeReading, SeenPlace, ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { announceUnlessDisconnected } from '../base/calls.ts';
import { shownTime } from '../time/timeSteps.ts';

export interface Aim {
    point: Vec3;
    /** Null: on no surface. */
    on: SeenPlace | null;
}

export interface Sight {
    pick: (at: ScreenPoint) => PickHit | null;
    /** The place of a rake under a canvas position. */
    rakeAt: (at: ScreenPoint) => Vec3 | null;
}

export const nothingThere = 'There is nothing under the pointer. Point at a surface, the body, a slice or a rake.';

/** Null where nothing can be seen. */
export function aim({ pick, rakeAt }: Sight, at: ScreenPoint): Aim | null {
    const hit = pick(at);
    if (hit !== null) {
        const { point, surface, s, t, scalar } = hit;
        return { point, on: surface === null ? null : { surface, s, t, scalar } };
    }
    const onRake = rakeAt(at);
    return onRake === null ? null : { point: onRake, on: null };
}

export interface ProbingOptions extends Sight {
    state: AppState;
    pageView: ViewState;
    worker: Pick<WorkerClient, 'call'>;
    requestFrame: () => void;
}

export class Probing implements PointerTool {
    private readonly options: ProbingOptions;
    /** While an answer is awaited only the newest place waits. */
    private asking = false;
    private next: Aim | null = null;
    private under: Pointer | null = null;
    private held = false;
    /** How often there was nothing to probe: an answer that was asked for before that is not shown. */
    private missed = 0;

    constructor(options: ProbingOptions) {
        this.options = options;
    }

    /** Stays there until the pointer is over the picture again after the next click. */
    click(pointer: Pointer): boolean {
        if (this.options.pageView.tool.value !== 'probe') return false;
        this.held = !this.held;
        this.under = this.held ? null : pointer;
        this.probeAt(pointer);
        // Nothing can be held where nothing is.
        this.held &&= !this.options.pageView.probeMissed.value;
        if (this.held) this.options.pageView.probeHeld.value = this.options.pageView.probePlace.value;
        return true;
    }

    hover(pointer: Pointer | null): string | null {
        if (this.options.pageView.tool.value !== 'probe') {
            this.held = false;
            return null;
        }
        if (pointer === null) this.options.pageView.besidePointer.value = null;
        if (!this.held && pointer !== null) {
            this.under = pointer;
            this.options.requestFrame();
        }
        return 'crosshair';
    }

    /** Called at the start of every frame: of the places of a frame the newest counts. */
    flush(): void {
        if (this.under === null || this.asking) return;
        const pointer = this.under;
        this.under = null;
        this.probeAt(pointer);
    }

    /** Where numbers say: the pointer does not take it away before the next click. */
    probeThere(point: Vec3): void {
        this.held = true;
        this.under = null;
        this.options.pageView.probeHeld.value = point;
        this.probe({ point, on: null });
    }

    private probe(aimed: Aim): void {
        this.next = aimed;
        this.options.pageView.probePlace.value = aimed.point;
        this.options.pageView.probeMissed.value = false;
        this.options.pageView.besidePointer.value = null;
        if (!this.asking) void this.ask();
    }

    private probeAt({ at }: Pointer): void {
        if (this.options.state.dataset.value === null) return;
        const aimed = aim(this.options, at);
        if (aimed === null) {
            this.probeNothing();
            this.options.pageView.besidePointer.value = { at, words: nothingThere };
        } else {
            this.probe(aimed);
        }
    }

    /** No number is shown of a place that no user can see. */
    private probeNothing(): void {
        const { pageView, requestFrame } = this.options;
        this.next = null;
        ++this.missed;
        pageView.probe.value = null;
        pageView.probeMissed.value = true;
        requestFrame();
    }

    private async ask(): Promise<void> {
        const { state, pageView, worker, requestFrame } = this.options;
        const description = state.dataset.value;
        const aimed = this.next;
        if (aimed === null || description === null) return;
        const { point, on } = aimed;
        this.next = null;
        this.asking = true;
        const time = shownTime(state);
        const { missed } = this;
        // Masks and vectors that were left out at the import are listed, but are not there to be sampled.
        const fields = description.fields
            .map(({ name }) => name)
            .filter((name) => name === description.velocity || description.surfaceFields?.includes(name));
        const params = { dataset: description.dataset, points: [point], time, fields };
        try {
            const { inside, values } = await worker.call('probe.sample', params);
            const at = ([name, [value]]: [string, (number | Vec3 | null)[]]): ProbeReading['values'][number] => ({
                name,
                value: value ?? null,
            });
            state.problems.solved('probe');
            if (missed !== this.missed) return;
            pageView.probe.value = { point, time, inside: inside[0] === true, values: Object.entries(values).map(at), on };
        } catch (error) {
            announceUnlessDisconnected(state.problems, 'probe', error);
        } finally {
            this.asking = false;
            requestFrame();
            if (this.next !== null) void this.ask();
        }
    }
}

export interface MeasuringOptions extends Sight {
    state: AppState;
    pageView: ViewState;
}

export class Measuring implements PointerTool {
    private readonly options: MeasuringOptions;

    constructor(options: MeasuringOptions) {
        this.options = options;
    }

    /** The first click sets one end, the second the other, the third starts again. */
    click({ at }: Pointer): boolean {
        const { state, pageView } = this.options;
        if (pageView.tool.value !== 'measure' || state.dataset.value === null) return false;
        const aimed = aim(this.options, at);
        if (aimed === null) {
            pageView.besidePointer.value = { at, words: nothingThere };
            return true;
        }
        const ends = pageView.measured.value;
        const first = ends.length !== 1;
        pageView.measured.value = first ? [aimed.point] : [ends[0]!, aimed.point];
        pageView.besidePointer.value = first ? { at, words: 'From here: click the other end.' } : null;
        return true;
    }

    hover(): string | null {
        return this.options.pageView.tool.value === 'measure' ? 'crosshair' : null;
    }
}

export function distance(a: Vec3, b: Vec3): number {
    return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}

export interface NotingOptions extends Sight {
    state: AppState;
    pageView: ViewState;
}

export class Noting implements PointerTool {
    private readonly options: NotingOptions;

    constructor(options: NotingOptions) {
        this.options = options;
    }

    click({ at }: Pointer): boolean {
        const { state, pageView } = this.options;
        if (pageView.tool.value !== 'annotate' || state.dataset.value === null) return false;
        const aimed = aim(this.options, at);
        if (aimed === null) {
            pageView.besidePointer.value = { at, words: nothingThere };
            return true;
        }
        pageView.besidePointer.value = null;
        const { point, on } = aimed;
        pageView.writeNote({ annotation: null, text: '', position: point, surface: on?.surface ?? null });
        return true;
    }

    hover(): string | null {
        return this.options.pageView.tool.value === 'annotate' ? 'crosshair' : null;
    }
}
