// @vitest-environment happy-dom
import { expect, it, vi } from 'vitest';
import { surfaceSteps } from '../../session/out/panelSteps.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { ShownPanel } from '../../testing/shownPanel.ts';
import './copyAs.ts';

it('a script is shown to be copied by hand where there is no clipboard', async () => {
    // As in pages that come over plain http from another machine.
    vi.stubGlobal('navigator', {});
    const { state } = new PageBench();
    const panel = await ShownPanel.of('wakesurf-copy-as', { state });
    Object.assign(panel.get('wakesurf-copy-as'), { calls: () => surfaceSteps(state) });
    const dialog = panel.get<HTMLDialogElement>('dialog');
    await panel.press('Copy as curl');
    expect(dialog.open).toBe(true);
    const script = panel.get<HTMLTextAreaElement>('textarea', 'Script').value;
    expect(script).toContain('curl ');
    expect(script).toContain('rake.set');
    expect(script).toContain('[-1.48,0.204,5.696]');
    vi.unstubAllGlobals();
});
