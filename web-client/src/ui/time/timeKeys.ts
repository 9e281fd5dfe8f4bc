// Keys that work wherever one is on the page: space plays and pauses, comma and full stop step. Not while
// something else wants them: a field that is typed in, a button in focus, an open dialog.
import { isTyping } from '../base/typing.ts';

export type TimeKey = 'toggle' | 'back' | 'forward';

/** Describes what of a key press matters here; KeyboardEvent has it. */
export type KeyPress = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'altKey' | 'metaKey' | 'defaultPrevented'>;

/** Null where the key is none of these. `spaceTaken`: the element in focus does something of its own when
 *  space is pressed. */
export function timeKey(press: KeyPress, spaceTaken: boolean): TimeKey | null {
    if (press.ctrlKey || press.altKey || press.metaKey || press.defaultPrevented) return null;
    if (press.key === ',') return 'back';
    if (press.key === '.') return 'forward';
    return press.key === ' ' && !spaceTaken ? 'toggle' : null;
}

export function timeKeyOf(event: KeyboardEvent): TimeKey | null {
    const [target] = event.composedPath();
    const takes = target instanceof Element && target.matches(spaceTakers);
    return isTyping(event) ? null : timeKey(event, takes);
}

/** Of the radio button that is chosen, and of the tab that is open, space would change nothing. */
const spaceTakers =
    'button:not([aria-selected="true"]), input:not([type="range"], [type="radio"]:checked), select, summary, a[href]';
