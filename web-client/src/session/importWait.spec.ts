import { describe, expect, it } from 'vitest';
import { settled } from '../connection/fakeClock.ts';
import type { DatasetEntry } from '../protocol/messages.ts';
import { AppState } from '../state/appState.ts';
import { CallError } from '../worker/workerClient.ts';
import { ImportWait } from './importWait.ts';

const stopped = new CallError({ kind: 'rpc', code: -32800, message: 'cancelled', hint: '' });
const lost = new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' });

function bench() {
    const state = new AppState();
    state.datasetEntry.value = { dataset: 'd', name: 'd', state: 'importing' };
    const calls: { reject: (error: Error) => void; resolve: (entry: DatasetEntry) => void }[] = [];
    const call = (_method: string, _params: object, signal: AbortSignal) =>
        new Promise((resolve, reject) => {
            calls.push({ resolve, reject });
            signal.addEventListener('abort', () => reject(stopped));
        });
    return { state, calls, imports: new ImportWait({ state, worker: { call } as never }) };
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
        imports.again();
        expect(calls).toHaveLength(2);
        expect(imports.left.value).toBe(false);
    });

    it('ends with the connection as if it had not begun, and when somebody else has stopped the import', async () => {
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

    it('is over for everybody once the dataset is ready', async () => {
        const { state, imports } = bench();
        void imports.begin('d');
        imports.stop();
        await settled();
        state.datasetEntry.value = { dataset: 'd', name: 'd', state: 'ready' };
        expect(imports.left.value).toBe(false);
    });
});
