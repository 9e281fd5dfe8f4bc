import { describe, expect, it } from 'vitest';
import { ViewState } from './viewState.ts';

const note = { annotation: null, text: '', position: [0, 0, 0] as [number, number, number], surface: null };

describe('what is typed into a note', () => {
    it('is there again the next time, each note its own, until it is saved or discarded', () => {
        const view = new ViewState();
        view.writeNote(note);
        view.endNote('half a sent');
        expect(view.note.value).toBeNull();
        view.writeNote({ ...note, annotation: 'a1', text: 'as saved' });
        expect(view.note.value?.text).toBe('as saved');
        view.endNote('changed');
        view.writeNote({ ...note, position: [1, 2, 3] });
        expect(view.note.value).toEqual({ ...note, position: [1, 2, 3], text: 'half a sent' });
        view.endNote(null);
        view.writeNote(note);
        expect(view.note.value?.text).toBe('');
        view.endNote('  ');
        view.writeNote({ ...note, annotation: 'a1', text: 'as saved' });
        expect(view.note.value?.text).toBe('changed');
    });
});
