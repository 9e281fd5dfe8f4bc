// Keys that work wherever one is on the page: space plays and pauses, comma and full stop step. Not while something else wants
// them: a field that is typed in, a button in focus, an open dialog.

export type TimeKey = 'toggle' | 'back' | 'forward';

/** What of a key press matters here; KeyboardEvent has it. */
export type KeyPress = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'altKey' | 'metaKey' | 'defaultPrevented'>;

/** Null where the key is none of these, or belongs to the element in focus. */
export function timeKey(press: KeyPress, focused: FocusedElement | null): TimeKey | null {
    if (press.ctrlKey || press.altKey || press.metaKey || press.defaultPrevented) return null;
    if (focused !== null && (focused.typedIn || focused.inDialog)) return null;
    if (press.key === ',') return 'back';
    if (press.key === '.') return 'forward';
    return press.key === ' ' && focused?.takesSpace !== true ? 'toggle' : null;
}

export interface FocusedElement {
    typedIn: boolean;
    takesSpace: boolean;
    inDialog: boolean;
}

const notTypedIn: ReadonlySet<string> = new Set(['range', 'checkbox', 'radio', 'button', 'submit', 'color', 'file']);

/** What the innermost target of an event would do with keys. */
export function focusedElement(path: readonly EventTarget[]): FocusedElement | null {
    const [target] = path;
    if (!(target instanceof HTMLElement)) return null;
    const field = target instanceof HTMLInputElement ? !notTypedIn.has(target.type) : false;
    return {
        typedIn: field || target instanceof HTMLTextAreaElement || target.isContentEditable,
        takesSpace: !(target instanceof HTMLInputElement && target.type === 'range') && target.matches(spaceTakers),
        inDialog: path.some((each) => each instanceof HTMLDialogElement),
    };
}

const spaceTakers = 'button, input, select, summary, a[href], [role="tab"]';
