import { describe, expect, it } from 'vitest';
import { sampleRake, sampleStatistics, sampleSurface } from '../testing/records.ts';
import { errorWords, readError, readNotification } from './messages.ts';

describe('why something failed', () => {
    it('is what and what to do, in one text', () => {
        expect(errorWords({ message: 'it is outside', hint: 'move it' })).toBe('it is outside: move it');
        expect(errorWords({ message: 'it is outside', hint: '' })).toBe('it is outside');
        expect(errorWords({ message: 'it is outside' })).toBe('it is outside');
    });

    it('is read from an object that says so, and from no other', () => {
        expect(readError({ message: 'it is outside', hint: 'move it', code: 7 })).toEqual({
            message: 'it is outside',
            hint: 'move it',
        });
        expect(readError({ message: 'it is outside', hint: '', kind: 3 })).toEqual({ message: 'it is outside' });
        expect(readError({ hint: 'move it' })).toBeNull();
        expect(readError('it is outside')).toBeNull();
    });
});

const rake = sampleRake();

function patched(...patches: unknown[]) {
    const read = readNotification('session.patched', { session: 'a', seq: 4, patches });
    return { patches: read.notification?.method === 'session.patched' ? read.notification.patches : null, faults: read.faults };
}

describe('readNotification', () => {
    it('takes what is as described, also with members that it does not know', () => {
        const told: [method: string, params: Record<string, unknown>][] = [
            ['server.notice', { kind: 'notDurable', level: 'warning', text: 'The disk is full.' }],
            ['server.notice', { kind: 'catchingUp', surface: 's1', subscription: 3 }],
            ['$/progress', { token: 'a', value: { kind: 'report', message: 'refining', percentage: 25, quads: 7 } }],
            ['dataset.patched', { dataset: 'd', name: 'D', state: 'importing', progress: 0.2, steps: { ready: 3, total: 16 } }],
            ['cache.patched', { dataset: 'd', changes: [[3, 'resident']], held: [[3, 1, 0]], bytes: 1, budget: 2 }],
            ['session.patched', { session: 'a', seq: 4, patches: [] }],
            ['presence.patched', { session: 'a', participants: [], left: ['p3'] }],
            ['surface.progress', { surface: 's1', epoch: 2, phase: 'coarse' }],
            ['surface.done', { surface: 's1', epoch: 2, stats: sampleStatistics() }],
        ];
        for (const [method, params] of told) {
            const more = { ...params, newer: { than: 'this page' } };
            expect(readNotification(method, more)).toEqual({ notification: { method, ...more }, faults: [] });
        }
    });

    it('ignores notifications that it does not know', () => {
        expect(readNotification('weather.patched', { rain: true })).toEqual({ notification: null, faults: [] });
        expect(readNotification('toString', {})).toEqual({ notification: null, faults: [] });
    });

    it('says of what is not as described what is wrong where', () => {
        const faultsOf = (method: string, params: Record<string, unknown>): unknown => {
            const { notification, faults } = readNotification(method, params);
            expect(notification, method).toBeNull();
            return faults;
        };
        expect(faultsOf('surface.done', { surface: 's1' })).toEqual(['in surface.done, epoch is not a whole number']);
        const stats = { ...sampleStatistics(), maxEdge: null };
        const notFinite = 'in surface.done, stats.maxEdge is not a finite number';
        expect(faultsOf('surface.done', { surface: 's1', epoch: 1, stats })).toEqual([notFinite]);
        expect(faultsOf('presence.patched', {})).toEqual(['in presence.patched, session is not a text']);
        const noList = { session: 'a', participants: 3, left: [] };
        expect(faultsOf('presence.patched', noList)).toEqual(['in presence.patched, participants is not a list']);
        expect(faultsOf('$/progress', { token: null, value: {} })).toEqual(['in $/progress, token is not a text or a number']);
        const entry = { dataset: 'd', name: 'D', state: 'lost', steps: { ready: 0, total: 1 } };
        const states = 'ready, importing, failed, stopped, incomplete';
        expect(faultsOf('dataset.patched', entry)).toEqual([`in dataset.patched, state is not one of ${states}`]);
        expect(faultsOf('server.notice', { kind: 7 })).toEqual(['in server.notice, kind is not a text']);
    });
});

describe('the patches of a session', () => {
    const clock = { time: 2.5, playing: true, speed: 1, loop: false, from: null, to: null };

    it('put and delete records', () => {
        const patches = [
            { op: 'put', type: 'rake', id: 'r1', record: { ...rake, newer: 1 } },
            { op: 'put', type: 'clock', id: 'clock', record: clock },
            { op: 'put', type: 'session', id: 'a', record: { session: 'a', name: 'Tuesday' } },
            { op: 'delete', type: 'surface', id: 's1' },
        ];
        expect(patched(...patches)).toEqual({ patches, faults: [] });
    });

    it('are left out where they are not as described, each alone, and the page hears why', () => {
        const sound = { op: 'delete', type: 'annotation', id: 'a1' };
        expect(
            patched(
                { op: 'put', type: 'rake', id: 'r1', record: { ...rake, points: [[0, 0, null]] } },
                { op: 'move', type: 'rake', id: 'r1' },
                { op: 'put', type: 'rake', id: 'r2' },
                { op: 'put', type: 'rake', id: 7, record: rake },
                7,
                { op: 'put', id: 'r1', record: rake },
                sound,
                { op: 'put', type: 'clock', id: 'clock', record: { ...clock, speed: 'fast' } },
                { op: 'put', type: 'bookmark', id: 'b1', record: rake },
                { op: 'delete', type: 'clock', id: 'clock' },
            ),
        ).toEqual({
            patches: [sound],
            faults: [
                'rake r1.points[0] is not three finite numbers',
                'rake r1.op is not one of put, delete',
                'rake r2 is not an object',
                'rake 7.id is not a text',
                'a patch is not an object',
                'the type of a patch is not a text',
                'clock clock.speed is not a finite number',
                'bookmark b1.bookmark is not a text',
                'clock clock cannot be deleted',
            ],
        });
    });

    it('are ignored where they are of a type that newer servers have', () => {
        expect(patched({ op: 'put', type: 'camera', id: 'c1', record: {} })).toEqual({ patches: [], faults: [] });
    });

    it('have surfaces of every kind, and none of which a member is not what it says', () => {
        const record = sampleSurface({ kind: 'time', to: 1, fields: ['p'] });
        const put = (more: object) => patched({ op: 'put', type: 'surface', id: 's1', record: { ...record, ...more } });
        for (const more of [{ sweep: [0, 1, 0] }, { rake2: 'r2' }, { kind: 'streak', releaseUntil: 0.5 }]) {
            expect(put(more).faults, JSON.stringify(more)).toEqual([]);
        }
        const wrong = [{ sweep: [0, 1] }, { rake2: 2 }, { releaseUntil: '1' }, { kind: 'steam' }, { fields: [1] }];
        const needed = Object.keys(record).filter((name) => name !== 'rake');
        const missing = needed.map((name) => ({ [name]: undefined }));
        for (const more of [...wrong, ...missing]) {
            expect(put(more), Object.keys(more)[0]).toEqual({ patches: [], faults: [expect.stringMatching(/^surface s1\./)] });
        }
    });
});

describe('what has changed of people', () => {
    const camera = { position: [0, 0, 9], target: [0, 0, 0], up: [0, 1, 0], fov: 30 };
    const ada = { participant: 'p1', name: 'Ada', colour: '#0072b2', role: 'host', connected: true, camera };
    const read = (...participants: unknown[]) => readNotification('presence.patched', { session: 's', participants, left: [] });

    it('is some of their members, null where one is taken away', () => {
        const participants = [ada, { participant: 'p2', pointer: null, dragging: { rake: 'r1' } }];
        expect(read(...participants)).toEqual({
            notification: { method: 'presence.patched', session: 's', participants, left: [] },
            faults: [],
        });
    });

    it('is left out of those of whom it is not as described, and the page hears why', () => {
        const { notification, faults } = read(
            { participant: 'p2', pointer: null, colour: 'red' },
            ada,
            { participant: 'p3', camera: { position: [0, 0] } },
            { name: 'nobody' },
            null,
        );
        expect(notification).toMatchObject({ participants: [ada] });
        expect(faults).toEqual([
            'participant p2.colour is not written as ^#[0-9a-fA-F]{6}$',
            'participant p3.camera.position is not three finite numbers',
            'a participant.participant is not a text',
            'a participant is not an object',
        ]);
    });
});

describe('which time-steps are in memory', () => {
    it('are told with their bytes; those that are not as described are left out, and the page hears why', () => {
        const held = [[3, 64, 0], [4, 'all', 0], [5], 'loading', ['6', 0, 0]];
        const patch = { dataset: 'd', changes: [], held, bytes: 1, budget: 2 };
        const { notification, faults } = readNotification('cache.patched', patch);
        expect(notification).toMatchObject({ held: [[3, 64, 0]] });
        expect(faults).toEqual([
            'in a change of time-steps in memory, [1] is not a whole number',
            'a change of time-steps in memory has 1 entries, not 3',
            'a change of time-steps in memory is not a list',
            'in a change of time-steps in memory, [0] is not a whole number',
        ]);
    });
});
