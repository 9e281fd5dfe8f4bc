// Says what a level surface may be a level set of, and where one begins: a field of the dataset, at the
// middle of its range.
import type { DatasetDescription } from '../../protocol/messages.ts';

type Level = { field: string; level: number };

/** Holds what surfaces have, and not the data. */
const ofSurfaces = ['deformation', 'approximated', 'error'];

export function levelFields({ surfaceFields, fields }: DatasetDescription): string[] {
    const stored = (name: string): boolean => fields.some((field) => field.name === name);
    return surfaceFields.filter((name) => stored(name) || !ofSurfaces.includes(name));
}

/** Over all that has been read; null: not known of what is derived. Of the velocity its magnitude's. */
export function describedRange({ fields }: DatasetDescription, name: string): readonly [number, number] | null {
    const [low = null, high = null] = fields.find((field) => field.name === name)?.range ?? [];
    return low !== null && high !== null && low < high ? [low, high] : null;
}

/** Returns the middle of the field's range. Zero will do where that is not known: such fields have both
 *  signs, or say what they range over. */
export function levelOf(dataset: DatasetDescription, field: string): Level {
    const range = describedRange(dataset, field);
    return { field, level: range === null ? 0 : Number(((range[0] + range[1]) / 2).toPrecision(4)) };
}

/** Returns a level of the first stored scalar that says more than where the body is; else of the speed. */
export function firstLevel(dataset: DatasetDescription): Level {
    const scalar = dataset.fields.find(
        ({ name, components }) =>
            components === 1 && name !== 'mask' && dataset.surfaceFields.includes(name) && describedRange(dataset, name) !== null,
    );
    return levelOf(dataset, scalar?.name ?? dataset.velocity);
}
