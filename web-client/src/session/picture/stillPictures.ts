// Says how pictures that stand still are drawn, as the user of this browser has chosen: shaded where things
// are near each other, and in exact order, at first where that costs nothing to speak of. Software rendering
// takes up to a second for one.
import { effect, type Signal } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';

export function showStillPictures(
    view: Pick<ViewState, 'contactShade' | 'exactWhenStill'>,
    scene: Pick<FlowScene, 'setContactShade' | 'setExactWhenStill'>,
    { software }: { software: boolean },
): void {
    keepChoice('exactOrder', view.exactWhenStill, !software, (on) => scene.setExactWhenStill(on));
    keepChoice('contactShade', view.contactShade, true, (on) => scene.setContactShade(on));
}

function keepChoice(name: string, choice: Signal<boolean>, usual: boolean, show: (on: boolean) => void): void {
    const before = recall(name);
    const first = before === null ? usual : before === 'on';
    choice.value = first;
    effect(() => {
        const on = choice.value;
        show(on);
        // What no user has chosen may be otherwise with other graphics.
        if (on !== first || before !== null) keep(name, on ? 'on' : 'off');
    });
}
