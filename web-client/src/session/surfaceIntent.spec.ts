import { describe, expect, it } from 'vitest';
import type { SurfaceRecord } from '../protocol/messages.ts';
import { fulfils, intentOf, settingOf } from './surfaceIntent.ts';

const record: SurfaceRecord = {
    surface: 's1',
    rev: 1,
    epoch: 1,
    rake: 'r1',
    kind: 'stream',
    dataset: 'd',
    from: 8.5,
    to: 20.5,
    direction: 'forward',
    separation: 0.2,
    accuracy: 'balanced',
    maxQuads: 1000,
    fields: [],
};
const times = [8.5, 12, 16];

describe('settingOf', () => {
    it('keeps the integration time when the moment of a stream surface moves', () => {
        const setting = settingOf({ ...intentOf(record), from: 12 }, record, times, false);
        expect(setting).toMatchObject({ surface: 's1', from: 12, to: 24, kind: 'stream' });
    });

    it('lets a path surface end where the data end', () => {
        const intent = { ...intentOf(record), kind: 'path' as const };
        expect(settingOf(intent, record, times, false)).toMatchObject({ from: 8.5, to: 16 });
        expect(settingOf(intent, record, [0], true)).toMatchObject({ from: 8.5, to: 20.5 });
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
});
