// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './notesPanel.ts';

const position: Vec3 = [1, 2, 3];
const where = { annotation: null, position, surface: null };

it('a note is saved by Ctrl+Enter, and Escape keeps what was typed', async () => {
    const { view, tries: calls, ...bench } = new PageBench();
    const panel = await ShownPanel.of('wakesurf-note-dialog', { view, calls });
    const dialog = panel.get<HTMLDialogElement>('dialog');
    const write = async (): Promise<void> => {
        view.writeNote({ ...where, text: '' });
        await rested();
    };
    view.tool.value = 'annotate';
    await write();
    expect(dialog.open).toBe(true);
    await panel.enter('textarea', undefined, 'Vortices pair');
    dialog.dispatchEvent(new Event('cancel', { cancelable: true }));
    await rested();
    expect(dialog.open).toBe(false);
    expect(view.tool.value).toBe('annotate');
    await write();
    expect(panel.get('textarea').value).toBe('Vortices pair');
    await panel.enter('textarea', undefined, 'Vortices pair here');
    await panel.key('textarea', undefined, 'Enter', { ctrlKey: true });
    expect(bench.calls).toEqual([['annotation.set', { text: 'Vortices pair here', position, gesture: 'act' }]]);
    expect([dialog.open, view.tool.value]).toEqual([false, 'none']);
});
