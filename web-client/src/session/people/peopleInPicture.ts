// The others in the picture as they come, move and go; and what this page's pointer is on, for them: nothing while there are none.
import { effect } from '@preact/signals-core';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import { PeopleLayer } from '../../scene/people/peopleLayer.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { Sight } from '../tools/pointTools.ts';
import type { People } from './people.ts';

export function showPeople(state: AppState, view: ViewState, scene: FlowScene): void {
    const layer = new PeopleLayer(scene.labels);
    scene.add(layer);
    effect(() => {
        const excluded = [state.you.value, view.following.value];
        const others = [...state.participants.value.values()];
        layer.set(others.filter(({ participant, connected }) => connected && !excluded.includes(participant)));
        scene.loop.request();
    });
}

/** Looking up what is under the pointer draws the surfaces once more. */
const pickEveryMs = 100;

export interface PointingOptions extends Pick<Sight, 'pick'> {
    state: AppState;
    people: People;
    requestFrame: () => void;
}

export class Pointing implements PointerTool {
    private readonly options: PointingOptions;
    private at: Pointer | null = null;
    private changed = false;
    private pickedAt = 0;

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
        if (this.at !== null && now - this.pickedAt < pickEveryMs) {
            // The last place counts, also when the pointer stays there.
            setTimeout(this.options.requestFrame, pickEveryMs);
            return;
        }
        this.changed = false;
        this.pickedAt = now;
        const hit = this.at === null ? null : this.options.pick(this.at.at);
        this.options.people.tell({ pointer: hit?.point ?? null });
    }
}
