// What is moved in one half of a comparison moves in the other, too, as one act: undo and redo in either half are for both.
import type { TurnAlong } from '../edits/undoHistory.ts';
import type { Half } from './half.ts';

type Mover = { state: Pick<Half['state'], 'locked'>; edits: Pick<Half['edits'], 'follow' | 'turnToo'> };

/** What the other half does not have, or one may only look at there, stays. */
export function moves(from: Mover, to: Mover): NonNullable<Half['edits']['onMove']> {
    return (moved, change) => {
        if (to.state.locked.value) return null;
        const there: TurnAlong = turning(from, () => here);
        const here: TurnAlong = turning(to, () => there);
        to.edits.follow(moved, change, there);
        return here;
    };
}

function turning({ edits }: Mover, step: () => TurnAlong): TurnAlong {
    return { undo: () => void edits.turnToo(step(), 'undo'), redo: () => void edits.turnToo(step(), 'redo') };
}
