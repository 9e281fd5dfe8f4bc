import { describe, expect, it } from 'vitest';
import type { SurfaceRecord, Vec3 } from '../../protocol/messages.ts';
import { sampleSurface } from '../../testing/records.ts';
import { fulfils, intentOf, settingForRecovery, settingOf, withSecondCurve } from './surfaceIntent.ts';

const record = sampleSurface({ from: 8.5, to: 20.5, maxQuads: 1000 });
const times = [8.5, 12, 16];

describe('settingOf', () => {
    it('keeps the integration time when the moment of a stream surface moves', () => {
        const setting = settingOf({ ...intentOf(record), from: 12 }, record, times, false);
        expect(setting).toMatchObject({ surface: 's1', from: 12, to: 24, kind: 'stream' });
    });

    it('lets all but stream surfaces end where the data end', () => {
        for (const kind of ['path', 'streak', 'time'] as const) {
            const intent = { ...intentOf(record), kind, sweep: [0, 1, 0] as Vec3 };
            expect(settingOf(intent, record, times, false)).toMatchObject({ from: 8.5, to: 16 });
            expect(settingOf(intent, record, [0], true)).toMatchObject({ from: 8.5, to: 20.5 });
        }
    });

    it('says until when a streak surface is released, unless that is as long as it is shown', () => {
        const streak = { ...intentOf(record), kind: 'streak' as const };
        expect(settingOf(streak, record, times, false)).not.toHaveProperty('releaseUntil');
        const sheet = { ...streak, released: 2 };
        expect(settingOf(sheet, record, times, false)).toMatchObject({ releaseUntil: 10.5 });
        const later = { ...sheet, from: 12 };
        expect(settingOf(later, record, times, false)).toMatchObject({ releaseUntil: 14 });
        const long = { ...streak, released: 9 };
        expect(settingOf(long, record, times, false)).not.toHaveProperty('releaseUntil');
        const stream = { ...sheet, life: 3, kind: 'stream' as const };
        expect(settingOf(stream, record, times, false)).not.toHaveProperty('releaseUntil');
        expect(settingOf(stream, record, times, false)).not.toHaveProperty('life');
        expect(settingOf({ ...stream, kind: 'path' as const }, record, times, false)).toMatchObject({ life: 3 });
    });

    it('gives a time surface one second curve, and the others none', () => {
        const time = { ...intentOf(record), kind: 'time' as const };
        const swept = settingOf({ ...time, sweep: [0, 2, 0] }, record, times, false);
        expect(swept).toMatchObject({ sweep: [0, 2, 0] });
        expect(swept).not.toHaveProperty('rake2');
        const between = settingOf({ ...time, rake2: 'r2' }, record, times, false);
        expect(between).toMatchObject({ rake2: 'r2' });
        const path = { ...time, kind: 'path' as const, sweep: [0, 2, 0] as Vec3 };
        expect(settingOf(path, record, times, false)).not.toHaveProperty('sweep');
    });

    it('follows particles back to the beginning of the data, or both ways as far as there are data after the release', () => {
        const path = { ...intentOf(record), kind: 'path' as const, from: 12 };
        const back = settingOf({ ...path, direction: 'backward' }, record, times, false);
        expect(back).toMatchObject({ direction: 'backward', from: 12, to: 8.5 });
        const both = settingOf({ ...path, direction: 'both' }, record, times, false);
        expect(both).toMatchObject({ direction: 'both', from: 12, to: 16 });
        const sheet = settingOf({ ...path, kind: 'streak', direction: 'backward', released: 2 }, record, times, false);
        expect(sheet).toMatchObject({ to: 8.5, releaseUntil: 10 });
        expect(intentOf({ ...record, ...sheet! })).toMatchObject({ length: 3.5, released: 2 });
    });

    it('shows a level surface at all times that there are, of its field', () => {
        const level = { ...intentOf(record), kind: 'level' as const, field: 'p', level: 0.25 };
        const setting = settingOf(level, record, times, false);
        expect(setting).toMatchObject({ kind: 'level', field: 'p', level: 0.25, from: 8.5, to: 16, direction: 'forward' });
        expect(settingOf(level, record, [3], true)).toMatchObject({ from: 3, to: 3 });
        expect(settingOf({ ...level, field: null }, record, times, false)).toBeNull();
        expect(settingOf({ ...level, kind: 'stream' }, record, times, false)).not.toHaveProperty('field');
        expect(intentOf({ ...record, ...setting! })).toMatchObject({ field: 'p', level: 0.25 });
    });

    it('keeps what only scripts set', () => {
        const tuned = { ...record, merge: 0.1, angle: 5 };
        expect(settingOf(intentOf(tuned), tuned, times, false)).toMatchObject({ merge: 0.1, angle: 5 });
    });

    it('has none for a path surface released at the end of the data', () => {
        const intent = { ...intentOf(record), kind: 'path' as const, from: 16 };
        expect(settingOf(intent, record, times, false)).toBeNull();
    });

    it('is fulfilled by the record it asks for, not by the one before', () => {
        const setting = settingOf({ ...intentOf(record), from: 12 }, record, times, false)!;
        expect(fulfils(record, setting)).toBe(false);
        expect(fulfils({ ...record, from: 12, to: 24 }, setting)).toBe(true);
    });

    it('is not fulfilled by a record with another release or second curve', () => {
        const sheet: SurfaceRecord = { ...record, kind: 'streak', to: 12, releaseUntil: 10.5 };
        const setting = settingOf(intentOf(sheet), sheet, times, false)!;
        expect(fulfils(sheet, setting)).toBe(true);
        expect(fulfils({ ...sheet, releaseUntil: 11 }, setting)).toBe(false);
        const patch: SurfaceRecord = { ...record, kind: 'time', to: 12, sweep: [0, 1, 0] };
        const swept = settingOf(intentOf(patch), patch, times, false)!;
        expect(fulfils(patch, swept)).toBe(true);
        expect(fulfils({ ...patch, sweep: [0, 1, 1] }, swept)).toBe(false);
    });
});

describe('fulfils', () => {
    it('takes no record for what was asked for in which someone has changed anything that a setting has', () => {
        const patch: SurfaceRecord = { ...record, kind: 'time', to: 12, sweep: [0, 1, 0] };
        const setting = settingOf(intentOf(patch), patch, times, false)!;
        const changes: Partial<SurfaceRecord>[] = [
            ...[{ merge: 0.1 }, { angle: 5 }, { stagnationSpeed: 0 }, { maxQuads: 7 }, { rake: 'r9' }, { dataset: 'another' }],
            ...[
                { separation: 0.5 },
                { life: 2 },
                { fields: ['p'] },
                { accuracy: 'exact' as const },
                { sweep: undefined, rake2: 'r2' },
            ],
            ...[{ interpolation: 'smooth' as const }, { refine: 'off' as const }],
        ];
        for (const change of changes) expect(fulfils({ ...patch, ...change }, setting), JSON.stringify(change)).toBe(false);
        expect(fulfils({ ...patch, rev: 9, epoch: 9 }, setting)).toBe(true);
    });
});

describe('settingForRecovery', () => {
    it('asks for all the record says, but for its identity, on the new rakes', () => {
        const patch: SurfaceRecord = { ...record, kind: 'time', rake2: 'r2', angle: 5 };
        const rakes = new Map([
            ['r1', 'r7'],
            ['r2', 'r8'],
        ]);
        const { surface: _, rev: __, epoch: ___, ...asked } = patch;
        expect(settingForRecovery(patch, rakes)).toEqual({ ...asked, rake: 'r7', rake2: 'r8' });
        expect(settingForRecovery(patch, new Map([['r1', 'r7']]))).toBeNull();
        expect(settingForRecovery(record, new Map())).toBeNull();
        expect(settingForRecovery(record, rakes)).not.toHaveProperty('rake2');
    });
});

describe('withSecondCurve', () => {
    const rake: Vec3[] = [
        [0, 0, 1],
        [0, 0, 5],
    ];

    it('sweeps the rake where a time surface has no second curve yet', () => {
        const time = { ...intentOf(record), kind: 'time' as const };
        const { sweep } = withSecondCurve(time, [-3, 13, -4, 4, 0, 6], rake);
        expect(sweep).toEqual([0, 3.8, 0]);
    });

    it('changes nothing that was chosen, and no other surface', () => {
        const chosen = { ...intentOf(record), kind: 'time' as const, rake2: 'r2' };
        expect(withSecondCurve(chosen, [-3, 13, -4, 4, 0, 6], rake)).toBe(chosen);
        const path = { ...intentOf(record), kind: 'path' as const };
        expect(withSecondCurve(path, [-3, 13, -4, 4, 0, 6], rake)).toBe(path);
    });
});
