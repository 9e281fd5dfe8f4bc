// Tells when a key or a button of the mouse is held, anywhere on the page: what it does meanwhile is one act.
import type { Gestures } from '../../session/edits/gestures.ts';

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
