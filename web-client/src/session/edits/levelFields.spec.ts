import { describe, expect, it } from 'vitest';
import { datasetOf, fieldOf } from '../../testing/records.ts';
import { describedRange, firstLevel, levelFields, levelOf } from './levelFields.ts';

const surfaceFields = ['p', 'mask', 'error', 'U', 'deformation', 'approximated', 'q_criterion', 'velocity_x'];
const dataset = datasetOf({
    fields: [
        fieldOf('U', { components: 3, range: [0.5, 1.5] }),
        fieldOf('mask'),
        fieldOf('p', { range: [-2, 4] }),
        fieldOf('error', { range: [1, 1] }),
    ],
    surfaceFields,
});

describe('fields of level surfaces', () => {
    it('are what the data have, not what only surfaces have', () => {
        expect(levelFields(dataset)).toEqual(['p', 'mask', 'error', 'U', 'q_criterion', 'velocity_x']);
    });

    it('begin in the middle of their range, or at 0 where it is not known', () => {
        expect(firstLevel(dataset)).toEqual({ field: 'p', level: 1 });
        expect(levelOf(dataset, 'q_criterion')).toEqual({ field: 'q_criterion', level: 0 });
        expect(firstLevel({ ...dataset, surfaceFields: ['mask', 'U'] })).toEqual({ field: 'U', level: 1 });
    });

    it('have no range where all values are the same, or none is known', () => {
        expect(describedRange(dataset, 'error')).toBeNull();
        expect(describedRange(datasetOf({ fields: [fieldOf('p', { range: [null, null] })] }), 'p')).toBeNull();
    });
});
