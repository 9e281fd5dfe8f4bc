// Tells whether a key belongs to a field that is being typed into, and is no shortcut.

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
