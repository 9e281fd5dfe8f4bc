// Tells the other users what this page's pointer is on: nothing while there are none.
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { AppState } from '../../state/appState.ts';
import type { Sight } from '../tools/aiming.ts';
import type { People } from './people.ts';

/** Looking up what is under the pointer draws the surfaces once more. */
const lookEveryMs = 100;

export interface PointingOptions extends Pick<Sight, 'pick'> {
    state: AppState;
    people: People;
    requestFrame: () => void;
}

export class Pointing implements PointerTool {
    private readonly options: PointingOptions;
    private at: Pointer | null = null;
    private changed = false;
    private lookedAt = 0;

    constructor(options: PointingOptions) {
        this.options = options;
    }

    watch(pointer: Pointer | null): void {
        if (this.options.state.participants.value.size < 2) return;
        this.at = pointer;
        this.changed = true;
        this.options.requestFrame();
    }

    /** Called at the start of every frame. */
    flush(): void {
        const now = performance.now();
        if (!this.changed) return;
        if (this.at !== null && now - this.lookedAt < lookEveryMs) {
            // The last place counts, also when the pointer stays there.
            setTimeout(this.options.requestFrame, lookEveryMs);
            return;
        }
        this.changed = false;
        this.lookedAt = now;
        const hit = this.at === null ? null : this.options.pick(this.at.at);
        this.options.people.tell({ pointer: hit?.point ?? null });
    }
}
