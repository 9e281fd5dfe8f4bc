// Whether pictures that stand still are drawn in exact order: as the user of this browser has chosen, at first where it costs
// nothing to speak of. Software rendering takes up to a second for one.
import { effect } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';

const kept = 'exactOrder';

export function showExactOrder(
    view: Pick<ViewState, 'exactWhenStill'>,
    scene: Pick<FlowScene, 'setExactWhenStill'>,
    { software }: { software: boolean },
): void {
    const before = recall(kept);
    const first = before === null ? !software : before === 'on';
    view.exactWhenStill.value = first;
    effect(() => {
        const on = view.exactWhenStill.value;
        scene.setExactWhenStill(on);
        // What no one has chosen may be otherwise with other graphics.
        if (on !== first || before !== null) keep(kept, on ? 'on' : 'off');
    });
}
