// Keys wherever the focus is: whether one belongs to a field that is being typed into, and is no shortcut; whether a key or a button of the
// mouse is held, since what it does meanwhile is one act; undo and redo by the keys people know.
import type { Edits } from '../../session/edits/edits.ts';
import type { Gestures } from '../../session/edits/gestures.ts';

const fields = 'input:not([type=range], [type=radio], [type=checkbox]), textarea, select, dialog';

/** Switched by a pointer, a control leaves the keys to the page, where space plays. Who goes by keyboard stays
 *  there. */
export function leaveKeys(control: HTMLElement): void {
    if (!control.matches(':focus-visible')) control.blur();
}

export function isTyping(event: KeyboardEvent): boolean {
    const [at] = event.composedPath();
    return at instanceof Element && at.closest(fields) !== null;
}

/** Arrows and Enter belong to what has the focus; the picture, and the page where nothing has it, leave them to the
 *  camera and to the tools. */
export function isFree(event: KeyboardEvent): boolean {
    const [at] = event.composedPath();
    return at instanceof HTMLCanvasElement || at === document.body;
}

/** @param pressed told of each that is not on a notice, before anything else hears of it */
export function listenForPresses(gestures: Gestures, pressed: () => void): void {
    // Before the control hears of it.
    const capture = true;
    const press = (event: Event): void => {
        // A notice may have a button, which must still be there when the press becomes a click.
        if (!event.composedPath().some((each) => each instanceof Element && each.localName === 'wakesurf-banner')) pressed();
        gestures.press();
    };
    addEventListener('pointerdown', press, capture);
    addEventListener(
        'keydown',
        (event) => {
            if (!event.repeat) press(event);
        },
        capture,
    );
    for (const type of ['pointerup', 'pointercancel', 'keyup']) {
        addEventListener(type, () => gestures.release(), capture);
    }
    // Of the window alone: elements lose the focus while a handle is held.
    addEventListener('blur', () => gestures.release());
}

/** @param edits of the half that is chosen, of two */
export function listenForUndoKeys(edits: () => Pick<Edits, 'undo' | 'redo'>): void {
    addEventListener('keydown', (event) => {
        const key = event.key.toLowerCase();
        // In a field the keys take back what was typed there.
        if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event)) return;
        const redo = (key === 'z' && event.shiftKey) || key === 'y';
        if (!redo && key !== 'z') return;
        event.preventDefault();
        void (redo ? edits().redo() : edits().undo());
    });
}
