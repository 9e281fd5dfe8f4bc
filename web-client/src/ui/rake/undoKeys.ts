// Undo and redo by the keys people know, wherever the focus is.
import type { Edits } from '../../session/edits/edits.ts';
import { isTyping } from '../base/typing.ts';

export function listenForUndoKeys(edits: Edits): void {
    addEventListener('keydown', (event) => {
        const key = event.key.toLowerCase();
        // In a field the keys take back what was typed there.
        if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event)) return;
        const redo = (key === 'z' && event.shiftKey) || key === 'y';
        if (!redo && key !== 'z') return;
        event.preventDefault();
        void (redo ? edits.redo() : edits.undo());
    });
}
