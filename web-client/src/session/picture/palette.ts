// The colours of rakes that have none of their own: bright ones that differ from each other and from the maps
// that surfaces are coloured with.
import type { RakeRecord } from '../../protocol/messages.ts';

export const rakeColours = ['#ff7a45', '#4cc2ff', '#ffd84d', '#ff7ab8', '#9be564', '#c79bff', '#ffffff', '#ff5c5c'] as const;

/** Its own, or one by its place among the rakes of the session. */
export function rakeColour(record: RakeRecord, rakes: ReadonlyMap<string, RakeRecord>): string {
    if (record.colour !== undefined && record.colour !== '') return record.colour;
    return byOrder([...rakes.keys()].indexOf(record.rake));
}

function byOrder(place: number): string {
    return rakeColours[Math.max(0, place) % rakeColours.length] ?? rakeColours[0];
}
