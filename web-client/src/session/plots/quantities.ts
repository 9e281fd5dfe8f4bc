// What of the data can be plotted: the speed, the velocity's components, fields of one number, stored or made of the velocity. Twin of
// quantities in python/wakesurf/series.py.
import type { DatasetDescription, ResultOf } from '../../protocol/messages.ts';
import { colourFields } from '../picture/surfaceStyleOf.ts';

export interface Quantity {
    name: string;
    unit: string;
    /** Those with one unit share an axis; where it is not known, those of the velocity. */
    group: string;
}

const components = ['velocity_x', 'velocity_y', 'velocity_z'];
const vorticities = ['vorticity', 'vorticity_x', 'vorticity_y', 'vorticity_z'];
const derived = [...vorticities, 'q_criterion'];

export function quantitiesOf(dataset: DatasetDescription): Quantity[] {
    const unit = dataset.fields.find(({ name }) => name === dataset.velocity)?.unit ?? '';
    const scalars = colourFields(dataset);
    const stored = new Set(scalars.map(({ name }) => name));
    return [
        ...['speed', ...components]
            .filter((name) => !stored.has(name))
            .map((name) => ({ name, unit, group: unit || 'velocity' })),
        ...scalars.map(({ name, unit: own = '' }) => ({ name, unit: own, group: own === '' ? `field ${name}` : own })),
        ...derived
            .filter((name) => !stored.has(name) && dataset.surfaceFields.includes(name))
            .map((name) => ({ name, unit: '', group: vorticities.includes(name) ? 'vorticity' : name })),
    ];
}

/** Names of fields that a server is asked for: the velocity by its name has the speed and all components at once. */
export function fieldsOf(dataset: DatasetDescription, quantities: readonly Pick<Quantity, 'name'>[]): string[] {
    const stored = new Set(colourFields(dataset).map(({ name }) => name));
    const ofVelocity = (name: string): boolean => !stored.has(name) && !derived.includes(name);
    return [...new Set(quantities.map(({ name }) => (ofVelocity(name) ? dataset.velocity : name)))];
}

/** The values of a quantity at each point; NaN: there is none. */
export function valuesOf(
    dataset: DatasetDescription,
    { name }: Pick<Quantity, 'name'>,
    { values }: ResultOf<'probe.sample'>,
): number[] {
    const stored = values[name];
    const found = stored !== undefined && name !== dataset.velocity ? stored : (values[dataset.velocity] ?? []);
    const component = components.indexOf(name);
    return found.map((value) => {
        if (value === null) return Number.NaN;
        if (typeof value === 'number') return value;
        return component < 0 ? Math.hypot(...value) : (value[component] ?? Number.NaN);
    });
}
