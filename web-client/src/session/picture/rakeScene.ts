// Shows the session's rakes in the scene: each as its record says, the active one as the user has it, those
// that others move with their name and colour and, where their page says so, where they have it at the
// moment.
import { effect } from '@preact/signals-core';
import type { RakeRecord } from '../../protocol/messages.ts';
import type { DrawnRake, RakeHolder } from '../../scene/rake/rakeLayer.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { showsRake } from '../../state/pageView.ts';
import { rakeColour } from './palette.ts';

const ofNobody = '#ffffff';

export function showRakes(state: AppState, view: ViewState, scene: FlowScene): void {
    effect(() => {
        const { rakes, activeRake } = state;
        // Read in any case, or this would not be run again when it changes.
        const settled = state.rakeShape.value;
        if (scene.rakes.chosenId !== activeRake.value) scene.interaction.abandon();
        const own = scene.interaction.dragging ? scene.rakes.shape : settled;
        const visibility = view.visibility.value;
        const shown = [...rakes.value.values()].filter(({ rake }) => showsRake(visibility, rake, activeRake.value));
        const drawn = shown.map((record): DrawnRake => {
            const chosen = record.rake === activeRake.value;
            const colour = rakeColour(record, rakes.value);
            const locked = state.locked.value || visibility.lockedRakes.has(record.rake);
            const people = { locked, holder: holderOf(state, record), remark: whyNothing(state, record.rake) };
            return { rake: record.rake, shape: chosen ? own : record, colour, chosen, ...people };
        });
        scene.rakes.setRakes(drawn);
        scene.loop.request();
    });
    // Another tool takes the click that would have placed a point.
    effect(() => {
        if (view.tool.value !== 'place') scene.interaction.place(null);
    });
}

/** Says why there is nothing to see where an empty surface of the rake would be. Empty: there is
 *  something. */
function whyNothing({ displayed, outcomes, surfaces }: AppState, rake: string): string {
    for (const { surface, rake: its } of surfaces.value.values()) {
        const outcome = outcomes.value.get(surface);
        const told = its === rake && outcome?.stateSum === displayed.value.get(surface)?.stateSum;
        if (told && outcome?.empty !== undefined) return outcome.empty.message;
    }
    return '';
}

/** Null where no other user holds it. */
export function holderOf(state: AppState, record: RakeRecord): RakeHolder | null {
    const by = record.dragging ? record.leasedBy : undefined;
    if (by === undefined || by === state.you.value) return null;
    const participant = state.participants.value.get(by);
    if (participant === undefined) return { name: by.startsWith('script') ? 'A script' : 'Someone', colour: ofNobody };
    const { name, colour, dragging } = participant;
    const points = dragging?.rake === record.rake ? { points: dragging.points } : {};
    return { name, colour, ...points };
}
