import { describe, expect, it } from 'vitest';
import { errorWords } from './records.ts';
import { readNotification } from './notifications.ts';
import { sampleRake, sampleSurface } from './testing/sampleRecords.ts';

const rake = sampleRake();

describe('readNotification', () => {
    it('reads patches that put and delete records', () => {
        const patches = [
            { op: 'put', type: 'rake', id: 'r1', record: rake },
            { op: 'delete', type: 'surface', id: 's1' },
        ];
        expect(readNotification('session.patched', { session: 'a', seq: 4, patches })).toEqual({
            method: 'session.patched',
            session: 'a',
            seq: 4,
            patches,
            faults: [],
        });
    });

    it('leaves out patches that it cannot trust, and says why', () => {
        const broken = { ...rake, points: [[0, 0, null]] };
        const patches = [
            { op: 'put', type: 'rake', id: 'r1', record: broken },
            { op: 'put', type: 'camera', id: 'c1', record: {} },
            { op: 'move', type: 'rake', id: 'r1' },
            7,
        ];
        const read = readNotification('session.patched', { session: 'a', seq: 4, patches });
        expect(read).toMatchObject({
            patches: [],
            faults: [
                'rake r1.points[0] is not three finite numbers',
                'rake r1 is neither put nor deleted',
                'a patch is not an object',
            ],
        });
    });

    it('keeps what and what to do of the error of a surface', () => {
        const error = { code: -32012, message: 'the rake is outside', hint: 'move it' };
        expect(readNotification('surface.done', { surface: 's1', epoch: 2, error })).toEqual({
            method: 'surface.done',
            surface: 's1',
            epoch: 2,
            error: { message: 'the rake is outside', hint: 'move it' },
        });
        expect(readNotification('surface.done', { surface: 's1', epoch: 2, stats: {} })).toMatchObject({
            error: null,
        });
    });

    it('says of a surface that ends before it should why it does', () => {
        const stats = { stopped: 'time-step 4 is damaged' };
        expect(readNotification('surface.done', { surface: 's1', epoch: 2, stats })).toMatchObject({
            error: { message: 'The surface ends early: time-step 4 is damaged' },
        });
    });

    it('says what and what to do in one text', () => {
        expect(errorWords({ message: 'it is outside', hint: 'move it' })).toBe('it is outside: move it');
        expect(errorWords({ message: 'it is outside' })).toBe('it is outside');
    });

    it('reads the clock, and leaves out what is no record', () => {
        const clock = { time: 2.5, playing: true, speed: 1, loop: false, from: null, to: null };
        const patches = [
            { op: 'put', type: 'clock', record: clock },
            { op: 'put', type: 'clock', record: { ...clock, speed: 'fast' } },
            { op: 'put', type: 'bookmark', id: 'b1', record: {} },
            { op: 'delete', type: 'annotation', id: 'a1' },
        ];
        expect(readNotification('session.patched', { session: 's', seq: 1, patches })).toEqual({
            method: 'session.patched',
            session: 's',
            seq: 1,
            patches: [patches[0], patches[3]],
            faults: ['clock.speed is not a finite number', 'bookmark b1.bookmark is not a text'],
        });
        expect(readNotification('presence.patched', {})).toBeNull();
        expect(readNotification('cache.patched', {})).toBeNull();
    });

    it('reads a notice for people, for programs, or for both', () => {
        const method = 'server.notice';
        expect(readNotification(method, { kind: 'catchingUp', surface: 's1' })).toEqual({
            ...{ method, kind: 'catchingUp', text: null, surface: 's1' },
        });
        expect(readNotification(method, { kind: 'notDurable', text: 'The disk is full.' })).toEqual({
            ...{ method, kind: 'notDurable', text: 'The disk is full.', surface: null },
        });
    });

    it('reads the progress of an import', () => {
        const steps = { ready: 3, total: 16 };
        const read = readNotification('dataset.patched', {
            dataset: 'd',
            state: 'importing',
            progress: 0.2,
            steps,
        });
        expect(read).toEqual({
            method: 'dataset.patched',
            dataset: 'd',
            change: { state: 'importing', progress: 0.2, steps },
        });
    });

    it('takes streak and time surfaces, and drops records whose parts are not what they say', () => {
        const record = sampleSurface({ kind: 'time', to: 1, fields: ['p'] });
        const patched = (more: object): number => {
            const patches = [{ op: 'put', type: 'surface', id: 's1', record: { ...record, ...more } }];
            const read = readNotification('session.patched', { session: 'main', seq: 1, patches });
            return read?.method === 'session.patched' ? read.patches.length : -1;
        };
        expect(patched({ sweep: [0, 1, 0] })).toBe(1);
        expect(patched({ rake2: 'r2' })).toBe(1);
        expect(patched({ kind: 'streak', releaseUntil: 0.5 })).toBe(1);
        expect(patched({ sweep: [0, 1] })).toBe(0);
        expect(patched({ rake2: 2 })).toBe(0);
        expect(patched({ releaseUntil: '1' })).toBe(0);
        expect(patched({ kind: 'steam' })).toBe(0);
        expect(patched({ dataset: undefined })).toBe(0);
        expect(patched({ fields: [1] })).toBe(0);
        for (const name of Object.keys(record)) expect(patched({ [name]: undefined }), name).toBe(0);
    });

    it('ignores what it does not know', () => {
        expect(readNotification('presence.patched', {})).toBeNull();
        expect(readNotification('surface.done', { surface: 's1' })).toBeNull();
    });

    it('reads what changed of people, and leaves out what is not as it should be', () => {
        const camera = { position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], fov: 30 };
        const participants = [
            { participant: 'p1', name: 'Ada', colour: '#0072b2', role: 'host', connected: true, camera },
            { participant: 'p2', pointer: null, colour: 'red', camera: { position: [0, 0] } },
            { name: 'nobody' },
        ];
        expect(readNotification('presence.patched', { session: 's', participants, left: ['p3'] })).toEqual({
            method: 'presence.patched',
            participants: [participants[0], { participant: 'p2', pointer: null }],
            left: ['p3'],
        });
    });

    it('reads which time-steps are in memory, as pairs', () => {
        const changes = [[3, 'resident'], [4, 'melting'], 'loading'];
        expect(readNotification('cache.patched', { dataset: 'd', changes, bytes: 1, budget: 2 })).toEqual({
            method: 'cache.patched',
            dataset: 'd',
            changes: [{ step: 3, state: 'resident' }],
        });
    });

    it('reads the progress of a call as a fraction', () => {
        const value = { kind: 'report', message: 'refining', percentage: 25 };
        expect(readNotification('$/progress', { token: 'a', value })).toEqual({
            ...{ method: '$/progress', token: 'a', fraction: 0.25, message: 'refining', ended: false },
        });
    });
});
