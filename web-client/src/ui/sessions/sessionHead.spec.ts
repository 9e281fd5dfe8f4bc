// @vitest-environment happy-dom
import { expect, it, vi } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './sessionHead.ts';

vi.mock('./sessionsDialog.ts', () => {
    throw new Error('not there');
});

it('a list of sessions that could not be loaded is told of', async () => {
    const bench = new PageBench();
    const head = await ShownPanel.of('wakesurf-session-head', { ...bench, sessionList: {} });
    head.get<HTMLButtonElement>('button').click();
    await rested();
    await vi.waitFor(() => expect([...bench.state.notices.all.value.keys()]).toEqual(['sessions']));
});
