// What is moved in one half of a comparison moves in the other, too, as one act: undo and redo in either half are for both, as long as
// that act is the newest in the other half as well.
import type { TurnAlong } from '../edits/undoHistory.ts';
import type { Half } from './half.ts';

type Mover = { state: Pick<Half['state'], 'locked'>; edits: Pick<Half['edits'], 'follow' | 'turnToo'> };

/** What the other half does not have stays as it is, and so does everything where one may only look. */
export function moves(from: Mover, to: Mover): NonNullable<Half['edits']['onMove']> {
    // Of one act for all its edits: the halves send them at different times, and each remembers the first that it has sent.
    let pair: { gesture: string; here: TurnAlong; there: TurnAlong } | null = null;
    return (moved, change, gesture) => {
        if (to.state.locked.value) return null;
        if (pair?.gesture !== gesture) {
            const there: TurnAlong = turning(from, () => here);
            const here: TurnAlong = turning(to, () => there);
            pair = { gesture, here, there };
        }
        // Each half numbers its own acts.
        to.edits.follow(moved, change, { gesture: `beside.${gesture}`, along: pair.there });
        return pair.here;
    };
}

function turning({ edits }: Mover, step: () => TurnAlong): TurnAlong {
    return { undo: () => void edits.turnToo(step(), 'undo'), redo: () => void edits.turnToo(step(), 'redo') };
}
