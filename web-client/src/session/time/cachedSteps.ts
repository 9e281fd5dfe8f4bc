// How much of each time-step is in the server's memory: asked for once a connection, then changed by notifications; as marks on the
// timeline, and in words.
import type { HeldChange, StepHeld, StepState } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { AppState, HeldSteps } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';

export class StepsHeld {
    private readonly state: AppState;
    private readonly worker: Pick<WorkerClient, 'call'>;

    constructor(state: AppState, worker: Pick<WorkerClient, 'call'>) {
        this.state = state;
        this.worker = worker;
    }

    /** Nothing is shown where the server cannot tell. */
    async load(dataset: string): Promise<void> {
        try {
            const { held, bytesPerStep } = await this.worker.call('cache.status', { dataset });
            if (this.state.dataset.value?.dataset === dataset) this.state.heldSteps.value = { steps: held, whole: bytesPerStep };
        } catch {
            this.state.heldSteps.value = { steps: [], whole: 0 };
        }
    }

    /** Changes that come before the answer to the question are older than it. */
    patched(dataset: string, changes: readonly HeldChange[]): void {
        const { heldSteps } = this.state;
        if (this.state.dataset.value?.dataset !== dataset || heldSteps.value.steps.length === 0) return;
        const steps = [...heldSteps.value.steps];
        for (const [step, resident, loading] of changes) {
            while (steps.length < step) steps.push([0, 0]); // steps that an import has added
            steps[step] = [resident, loading];
        }
        heldSteps.value = { ...heldSteps.value, steps };
    }
}

/** One time-step on the timeline, or a run of neighbours where there are too many to draw. */
export interface StepMark {
    first: number;
    last: number;
    state: StepState;
    /** The part of its bytes in memory, 0 to 1. */
    resident: number;
    loading: number;
}

/** Resident where anything is. */
function stateOf([resident, loading]: StepHeld): StepState {
    return resident > 0 ? 'resident' : loading > 0 ? 'loading' : 'cold';
}

/**
 * A mark for each time-step; where they are more than `atMost`, one for each run of the same state, for which
 * neighbours count as far as the least of them: resident only if all are.
 */
export function stepMarks({ steps, whole }: HeldSteps, atMost: number): StepMark[] {
    const width = Math.max(1, Math.ceil(steps.length / Math.max(1, atMost)));
    const marks: StepMark[] = [];
    for (let first = 0; first < steps.length; first += width) {
        const run = steps.slice(first, first + width);
        const states = run.map(stateOf);
        const state: StepState = states.includes('loading') ? 'loading' : states.includes('cold') ? 'cold' : 'resident';
        const share = (of: 0 | 1): number => run.reduce((sum, held) => sum + held[of], 0) / (run.length * Math.max(1, whole));
        const now: StepMark = { first, last: first + run.length - 1, state, resident: share(0), loading: share(1) };
        const before = marks.at(-1);
        if (width > 1 && before?.state === state) marks[marks.length - 1] = joined(before, now);
        else marks.push(now);
    }
    return marks;
}

function joined(before: StepMark, now: StepMark): StepMark {
    const [one, other] = [before.last - before.first + 1, now.last - now.first + 1];
    const mean = (of: 'resident' | 'loading'): number => (one * before[of] + other * now[of]) / (one + other);
    return { ...before, last: now.last, resident: mean('resident'), loading: mean('loading') };
}

/** "12 of 40 time-steps in memory, 2 loading"; in parts: "12 of 40 time-steps in memory in part, 3.5 MiB of
 *  40 GiB". */
export function residentWords({ steps, whole }: HeldSteps): string {
    const resident = steps.filter(([bytes]) => bytes > 0);
    const loading = steps.filter(([, bytes]) => bytes > 0).length;
    const inPart = resident.some(([bytes]) => bytes < whole);
    const bytes = resident.reduce((sum, held) => sum + held[0], 0);
    const parts = inPart ? ` in part, ${bytesWords(bytes)} of ${bytesWords(whole * steps.length)}` : '';
    const all = steps.length === 1 ? 'time-step' : 'time-steps';
    return `${resident.length} of ${steps.length} ${all} in memory${parts}${loading === 0 ? '' : `, ${loading} loading`}`;
}

/** "3.5 MiB of 1 GiB in memory, 1.5 MiB loading", of a mark's bytes. */
export function markWords({ first, last, resident, loading }: StepMark, whole: number): string {
    const all = (last - first + 1) * whole;
    const coming = loading === 0 ? '' : `, ${bytesWords(loading * all)} loading`;
    return `${bytesWords(resident * all)} of ${bytesWords(all)} in memory${coming}`;
}

function bytesWords(bytes: number): string {
    const large = bytes >= 2 ** 30;
    return `${shortNumber(bytes / (large ? 2 ** 30 : 2 ** 20))} ${large ? 'GiB' : 'MiB'}`;
}
