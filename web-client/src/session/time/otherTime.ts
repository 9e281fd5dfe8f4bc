// A time that is told from another: of the right half of a comparison, and of what a slice subtracts.
export type OtherTime =
    | { kind: 'same' }
    /** So much later. */
    | { kind: 'offset'; by: number }
    | { kind: 'at'; time: number };

export function otherTime(chosen: OtherTime, time: number): number {
    return chosen.kind === 'same' ? time : chosen.kind === 'offset' ? time + chosen.by : chosen.time;
}
