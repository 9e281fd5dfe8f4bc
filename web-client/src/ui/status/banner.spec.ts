// @vitest-environment happy-dom
import { signal } from '@preact/signals-core';
import { beforeEach, describe, expect, it } from 'vitest';
import type { DatasetEntry } from '../../protocol/messages.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './banner.ts';

let bench: PageBench;
let banner: ShownPanel;
/** What has been asked for by its buttons. */
let asked: string[];
const left = signal(false);

beforeEach(async () => {
    bench = new PageBench();
    asked = [];
    left.value = false;
    const note = (what: string) => (): void => void asked.push(what);
    const choose = (name: string): Promise<void> => Promise.resolve(void asked.push(name));
    banner = await ShownPanel.of('wakesurf-banner', {
        ...{ state: bench.state, view: bench.view, imports: { left, resume: note('resume'), stop: note('stop'), choose } },
        ...{ retryNow: note('retry'), restoreSession: note('restore'), recoverSession: note('make again') },
    });
});

async function importIs(change: Partial<DatasetEntry>): Promise<void> {
    const entry: DatasetEntry = { dataset: 'd', name: 'wake', state: 'importing', steps: { ready: 2, total: 4 }, ...change };
    bench.state.datasetEntry.value = entry;
    await rested();
}

describe('an import', () => {
    it('can be left, which is said where it goes on for others, and be waited for again', async () => {
        await importIs({ progress: 0.5 });
        expect(banner.get<HTMLProgressElement>('#importing progress').getAttribute('aria-label')).toBe('Import');
        await banner.press('Stop');
        left.value = true;
        await rested();
        expect(banner.text).toContain('You stopped waiting for wake. Its import continues for others (2 of 4).');
        await banner.press('Wait again');
        expect(asked).toEqual(['stop', 'resume']);
    });

    it('that was stopped says how far it is, and is resumed by who can edit', async () => {
        await importIs({ state: 'stopped' });
        expect(banner.text).toContain('The import of wake was stopped: 2 of 4 time-steps are here.');
        await banner.press('Resume the import');
        expect(asked).toEqual(['resume']);
        bench.state.role.value = 'viewer';
        await rested();
        expect(banner.all('button')).toEqual([]);
    });

    it('that does not know the velocity asks for it', async () => {
        await importIs({ state: 'failed', velocities: ['U.air', 'U.water'] });
        expect(banner.text).toContain('It is not clear which field of wake is the velocity.');
        await banner.press('U.water');
        expect(asked).toEqual(['U.water']);
    });
});

describe('a page whose session or connection has ended', () => {
    it('says until when the session can be restored, and restores it', async () => {
        const restorableUntil = '2026-12-22T12:00:00Z';
        bench.state.gone.value = { session: 's', name: 'Shared work', restorableUntil, remembered: true };
        await rested();
        expect(banner.get<HTMLElement>('#gone strong').textContent).toBe('“Shared work” was moved to the trash.');
        expect(banner.text).toContain('It can be restored until December 22, 2026.');
        await banner.press('Restore');
        expect(asked).toEqual(['restore']);
    });

    it('says why it does not come back by itself, and that the picture stays', async () => {
        bench.state.connection.value = { state: 'ended', reason: 'The host removed you.' };
        await rested();
        expect(banner.get<HTMLElement>('#ended strong').textContent).toBe('Connection ended.');
        expect(banner.text).toContain('The host removed you. The picture stays as it was.');
        expect(banner.all('button', 'Reload')).toHaveLength(1);
    });
});
