import { describe, expect, it } from 'vitest';
import type { RakeRecord, SurfaceRecord, Vec3 } from '../../protocol/messages.ts';
import { answering } from '../../testing/fakes.ts';
import { rakeOf, surfaceOf } from '../../testing/records.ts';
import { CallError } from '../../worker/workerClient.ts';
import { recoverSession } from './sessionRecovery.ts';

const rake = (id: string, seeds = 8): RakeRecord => rakeOf(id, { seeds });
const surface = (id: string, of: string, more: object = {}): SurfaceRecord => surfaceOf(id, { rake: of, to: 1, ...more });

/** What it makes n1, n2, ...; takes no rake with fewer than two seeds. */
function serverThat(fails: CallError) {
    const asked: Record<string, unknown>[] = [];
    const worker = answering((method, params) => {
        if (method === 'rake.set' && Number(params['seeds']) < 2) throw fails;
        asked.push(params);
        return { [method.split('.')[0]!]: `n${asked.length}` };
    });
    return { asked, worker };
}

const refused = new CallError({ kind: 'rpc', code: -32602, message: 'seeds: too few', hint: '' });
const lost = new CallError({ kind: 'disconnected', code: 0, message: 'gone', hint: '' });
const none = { slices: [], lines: [], bookmarks: [], annotations: [] };
const former = {
    ...none,
    rakes: [rake('r1', 1), rake('r2')],
    surfaces: [surface('s1', 'r1'), surface('s2', 'r2', { session: 'another', hostile: true })],
};

describe('a session made again', () => {
    it('has all that the server takes, says what is missing, and knows the new names', async () => {
        const { asked, worker } = serverThat(refused);
        const made = await recoverSession(worker, former);
        expect([...made.rakes]).toEqual([['r2', 'n1']]);
        expect([...made.surfaces]).toEqual([['s2', 'n2']]);
        expect(made.missing).toBe('Not recreated: 1 rake and 1 surface. seeds: too few');
        expect(asked[1]).toMatchObject({ rake: 'n1', kind: 'stream', from: 0, to: 1 });
        expect(asked[1]).not.toHaveProperty('session');
        expect(asked[1]).not.toHaveProperty('hostile');
    });

    it('goes on where a lost connection has ended the first attempt', async () => {
        const { asked, worker } = serverThat(refused);
        const there = { rakes: [rake('n7')].map((each) => ({ ...each, name: 'r2' })), surfaces: [surface('n8', 'n7')] };
        const remembered = { ...none, rakes: [rake('r2'), rake('r3')], surfaces: [surface('s1', 'r2'), surface('s2', 'r2')] };
        const made = await recoverSession(worker, remembered, there);
        expect(asked).toHaveLength(2);
        expect([...made.rakes]).toEqual([
            ['r2', 'n7'],
            ['r3', 'n1'],
        ]);
        expect([...made.surfaces]).toEqual([
            ['s1', 'n8'],
            ['s2', 'n2'],
        ]);
        expect(made.missing).toBeNull();
    });

    it('has its notes, and its views of the surfaces under their new names', async () => {
        const { asked, worker } = serverThat(refused);
        const note = { annotation: 'a1', rev: 1, text: 'Here', position: [1, 2, 3] as Vec3, author: 'Ada', surface: 's1' };
        const view = { surface: 's1', looks: { s1: { opacity: 0.5 }, gone: { opacity: 0.2 } } };
        const kept = { bookmark: 'b1', rev: 1, name: 'From above', view, time: 4 };
        await recoverSession(worker, {
            ...none,
            rakes: [rake('r2')],
            surfaces: [surface('s1', 'r2')],
            bookmarks: [kept],
            annotations: [note],
        });
        expect(asked.slice(2)).toEqual([
            { text: 'Here', position: [1, 2, 3], surface: 'n2' },
            { name: 'From above', time: 4, view: { surface: 'n2', looks: { n2: { opacity: 0.5 } } } },
        ]);
    });

    it('has its slices and streamlines, each once, and what was hidden of them stays so', async () => {
        const { asked, worker } = serverThat(refused);
        const plane = { dataset: 'flow', origin: [0, 0, 1] as Vec3, normal: [0, 0, 1] as Vec3, field: 'p' };
        const seeds = {
            kind: 'sphere' as const,
            points: [[1, 1, 1] as Vec3],
            distance: 0.5,
            patches: [],
            seeds: 50,
            direction: 'both' as const,
        };
        const lines = { lines: 'l1', rev: 7, dataset: 'flow', ...seeds, duration: 0, length: 2, field: 'U' };
        const there = { rakes: [], surfaces: [], slices: [{ slice: 'c9', rev: 1, ...plane, field: 'U' }] };
        const made = await recoverSession(
            worker,
            {
                ...{ ...none, rakes: [], surfaces: [] },
                slices: [
                    { slice: 'c1', rev: 3, ...plane, field: 'U' },
                    { slice: 'c2', rev: 4, ...plane },
                ],
                lines: [lines],
            },
            there,
        );
        const { lines: _, rev: _rev, ...setting } = lines;
        expect(asked).toEqual([plane, setting]);
        expect([...made.surfaces]).toEqual([
            ['c1', 'c9'],
            ['c2', 'n1'],
            ['l1', 'n2'],
        ]);
        expect(made.missing).toBeNull();
    });

    it('is given up when the connection is lost', async () => {
        await expect(recoverSession(serverThat(lost).worker, former)).rejects.toBe(lost);
    });
});
