import { describe, expect, it } from 'vitest';
import { AttributeNames } from './attributeNames.ts';

describe('AttributeNames', () => {
    it('are those of the newest epoch up to the one of the frames', () => {
        const names = new AttributeNames();
        names.learn('a', 2, ['speed', 's', 't']);
        names.learn('a', 5, ['speed', 's', 't', 'p']);
        expect(names.of('a', 4, 3)).toEqual(['speed', 's', 't']);
        expect(names.of('a', 5, 4)).toEqual(['speed', 's', 't', 'p']);
        expect(names.of('a', 9, 4)).toEqual(['speed', 's', 't', 'p']);
    });

    it('are only those that every surface has, where the frames have another number of them', () => {
        const names = new AttributeNames();
        names.learn('a', 5, ['speed', 's', 't', 'p']);
        expect(names.of('a', 6, 5)).toEqual(['speed', 's', 't']);
        expect(names.of('b', 1, 3)).toEqual(['speed', 's', 't']);
    });

    it('forget old epochs, and whole surfaces when told', () => {
        const names = new AttributeNames();
        for (let epoch = 1; epoch < 40; ++epoch) names.learn('a', epoch, ['speed', 's', 't', `f${epoch}`]);
        expect(names.of('a', 39, 4)[3]).toBe('f39');
        expect(names.of('a', 1, 4)).toEqual(['speed', 's', 't']);
        names.forget('a');
        expect(names.of('a', 39, 4)).toEqual(['speed', 's', 't']);
    });
});
