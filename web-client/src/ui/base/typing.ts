// Tells whether a key belongs to a field that is being typed into, and is no shortcut.

const fields = 'input:not([type=range], [type=radio], [type=checkbox]), textarea, select, dialog';

export function isTyping(event: KeyboardEvent): boolean {
    const [at] = event.composedPath();
    return at instanceof Element && at.closest(fields) !== null;
}
