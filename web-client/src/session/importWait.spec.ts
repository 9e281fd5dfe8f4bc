import { describe, expect, it } from 'vitest';
import { answering, settled } from '../testing/fakes.ts';
import type { DatasetEntry } from '../protocol/messages.ts';
import { AppState } from '../state/appState.ts';
import { CallError } from '../worker/workerClient.ts';
import { ImportWait } from './importWait.ts';

const stopped = new CallError({ kind: 'rpc', code: -32800, message: 'cancelled', hint: '' });
const lost = new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' });

const steps = { ready: 0, total: 4 };
const importing: DatasetEntry = { dataset: 'd', name: 'd', state: 'importing', steps };

function bench(first: DatasetEntry['state'] = 'importing') {
    const state = new AppState();
    state.datasetEntry.value = { ...importing, state: first };
    const calls: { reject: (error: Error) => void; resolve: (entry: DatasetEntry) => void }[] = [];
    const worker = answering(
        (_method, _params, signal) =>
            new Promise((resolve, reject) => {
                calls.push({ resolve, reject });
                signal?.addEventListener('abort', () => reject(stopped));
            }),
    );
    return { state, calls, imports: new ImportWait({ state, worker }) };
}

describe('waiting for an import', () => {
    it('is one call however often it is begun, until it is stopped; then it begins again when asked to', async () => {
        const { calls, imports } = bench();
        void imports.begin('d');
        void imports.begin('d');
        expect(calls).toHaveLength(1);
        imports.stop();
        await settled();
        expect(imports.left.value).toBe(true);
        imports.stop();
        imports.resume();
        expect(calls).toHaveLength(2);
        expect(imports.left.value).toBe(false);
    });

    it('goes on when the server has no more patience, so that it can still be stopped', async () => {
        const { state, calls, imports } = bench();
        calls[0]!.resolve(state.datasetEntry.value!);
        await settled();
        expect(calls).toHaveLength(2);
        imports.stop();
        await settled();
        expect(imports.left.value).toBe(true);
        expect(calls).toHaveLength(2);
    });

    it('begins when someone else has a stopped import go on, unless this user has left it', async () => {
        const { state, calls, imports } = bench('stopped');
        expect(calls).toHaveLength(0);
        state.datasetEntry.value = importing;
        expect(calls).toHaveLength(1);
        imports.stop();
        await settled();
        state.datasetEntry.value = { ...importing, state: 'stopped' };
        state.datasetEntry.value = { ...importing };
        await settled();
        expect(calls).toHaveLength(1);
        expect(imports.left.value).toBe(true);
    });

    it('that someone else has ended is left while the import is stopped, and not before or after', async () => {
        const { state, calls, imports } = bench();
        calls[0]!.reject(stopped);
        await settled();
        // The entry of before the stop is no reason to have it go on.
        state.datasetEntry.value = { ...importing, progress: 0.5 };
        expect(calls).toHaveLength(1);
        state.datasetEntry.value = { ...importing, state: 'stopped' };
        expect(imports.left.value).toBe(true);
        state.datasetEntry.value = importing;
        expect(imports.left.value).toBe(false);
        expect(calls).toHaveLength(2);
    });

    it('ends with the connection as if it had not begun, and when someone else has stopped the import', async () => {
        const { calls, imports } = bench();
        void imports.begin('d');
        calls[0]!.reject(lost);
        await settled();
        expect(imports.left.value).toBe(false);
        void imports.begin('d');
        calls[1]!.reject(stopped);
        await settled();
        expect(imports.left.value).toBe(true);
    });

    it('is over for everyone once the dataset is ready', async () => {
        const { state, imports } = bench();
        void imports.begin('d');
        imports.stop();
        await settled();
        state.datasetEntry.value = { dataset: 'd', name: 'd', state: 'ready', steps };
        expect(imports.left.value).toBe(false);
    });
});

describe('a dataset whose velocity is not clear', () => {
    it('is imported with the one that is chosen, and says why that is refused', async () => {
        const { state, calls, imports } = bench('failed');
        void imports.choose('U.water');
        calls[0]!.resolve(importing);
        await settled();
        expect(state.datasetEntry.value).toEqual(importing);
        void imports.choose('U.air');
        calls.at(-1)!.reject(lost);
        await settled();
        expect([...state.notices.all.value.keys()]).toEqual(['velocity']);
    });
});
