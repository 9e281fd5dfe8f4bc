// The probe: what the flow does at a point of what is seen under the pointer, or where numbers say.
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { ProbeReading, ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { tellUnlessCut } from '../base/lostConnection.ts';
import { aim, nothingThere, type Sight } from './aiming.ts';
import { shownTime } from '../time/shownTime.ts';

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
    private next: Vec3 | null = null;
    private under: Pointer | null = null;
    private held = false;
    /** Says how often there was nothing to probe: an answer that was asked for before that is not shown. */
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
        this.probe(point);
    }

    private probe(point: Vec3): void {
        this.next = point;
        this.options.pageView.probePlace.value = point;
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
            this.probe(aimed.point);
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
        const point = this.next;
        if (point === null || description === null) return;
        this.next = null;
        this.asking = true;
        const time = shownTime(state);
        const { missed } = this;
        // Masks and vectors that were left out at the import are listed, but are not there to be sampled.
        const fields = description.fields
            .map(({ name }) => name)
            .filter((name) => name === description.velocity || description.surfaceFields?.includes(name));
        const asked = { dataset: description.dataset, points: [point], time, fields };
        try {
            const { inside, values } = await worker.call('probe.sample', asked);
            const at = ([name, [value]]: [string, (number | Vec3 | null)[]]): ProbeReading['values'][number] => ({
                name,
                value: value ?? null,
            });
            state.problems.solved('probe');
            if (missed !== this.missed) return;
            pageView.probe.value = { point, time, inside: inside[0] === true, values: Object.entries(values).map(at) };
        } catch (error) {
            tellUnlessCut(state.problems, 'probe', error);
        } finally {
            this.asking = false;
            requestFrame();
            if (this.next !== null) void this.ask();
        }
    }
}
