// Tells when a key or a button of the mouse is held, anywhere on the page: what it does meanwhile is one act.
import type { Gestures } from '../../session/edits/gestures.ts';

export function listenForPresses(gestures: Gestures): void {
    // Before the control hears of it.
    const capture = true;
    addEventListener('pointerdown', () => gestures.press(), capture);
    addEventListener(
        'keydown',
        ({ repeat }) => {
            if (!repeat) gestures.press();
        },
        capture,
    );
    for (const type of ['pointerup', 'pointercancel', 'keyup']) {
        addEventListener(type, () => gestures.release(), capture);
    }
    // Of the window alone: elements lose the focus while a handle is held.
    addEventListener('blur', () => gestures.release());
}
