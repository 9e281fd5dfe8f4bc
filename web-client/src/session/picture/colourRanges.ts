// Says what colours stand for where no user has said it: one range for all surfaces that show the same field
// in this picture. It is the server's word for every user what a surface's values range over, so that people
// who come late, or reload, see the same colours; while a surface plays it only grows.
import type { AppState } from '../../state/appState.ts';
import { type AutomaticRange, type AutomaticRanges, meaningOf } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { attributeOf } from './surfaceStyleOf.ts';

export function automaticRanges(
    state: Pick<AppState, 'surfaces' | 'hiddenSurfaces' | 'valueRanges'>,
    view: Pick<ViewState, 'lookOf'>,
): AutomaticRanges {
    const ranges = new Map<string, AutomaticRange>();
    for (const [id, record] of state.surfaces.value) {
        const look = view.lookOf(id);
        if (state.hiddenSurfaces.value.has(id) || look.range !== null) continue;
        const attribute = look.colourBy === 'age' ? 't' : attributeOf(look.colourBy);
        const told = state.valueRanges.value.get(id)?.find((each) => each.attribute === attribute);
        if (told === undefined) continue;
        const meaning = meaningOf(look, record);
        const other = ranges.get(meaning);
        const { low, high, least, greatest } = told;
        ranges.set(meaning, {
            surfaces: (other?.surfaces ?? 0) + 1,
            low: Math.min(low, other?.low ?? low),
            high: Math.max(high, other?.high ?? high),
            least: Math.min(least, other?.least ?? least),
            greatest: Math.max(greatest, other?.greatest ?? greatest),
        });
    }
    return ranges;
}
