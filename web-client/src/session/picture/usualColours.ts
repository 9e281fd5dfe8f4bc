// The colours of a field where nobody has chosen any: of slices and bodies, so that the same field looks alike on both.
import { steadyRange } from '../../scene/surface/colourMap.ts';
import type { ColourMap } from '../../state/surfaceLook.ts';

/** Of both signs where the smaller one is at least such a part of the larger. */
const bothSigns = 0.05;

export interface UsualColours {
    map: ColourMap;
    range: [number, number];
}

/** Of a difference: the same about 0, whichever signs there are. */
export function coloursOfDifference(low: number, high: number): UsualColours {
    const [, end] = steadyRange(0, Math.max(Math.abs(low), Math.abs(high)));
    return { map: 'coolToWarm', range: end > 0 ? [-end, end] : [-1, 1] };
}

/** The same about 0 where there are both signs, so that 0 is seen. */
export function coloursOf(low: number, high: number): UsualColours {
    if (low < 0 && high > 0 && Math.min(-low, high) > bothSigns * Math.max(-low, high)) {
        const [, end] = steadyRange(0, Math.max(-low, high));
        return { map: 'coolToWarm', range: [-end, end] };
    }
    return { map: 'viridis', range: steadyRange(low, high) };
}
