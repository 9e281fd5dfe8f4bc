// What a surface can be coloured by, and the colour maps.
import type { DatasetDescription, SurfaceKind, SurfaceRecord } from '../../protocol/messages.ts';
import type { SurfaceStyle } from '../../scene/surface/surfaceStyle.ts';
import {
    canCome,
    colourByField,
    colourFields,
    deformation,
    estimatedError,
    intervalError,
    qCriterion,
    twinDistance,
    twinLag,
    vorticity,
    vorticityComponents,
} from '../../session/picture/surfaceStyleOf.ts';
import type { ColourMap } from '../../state/surfaceLook.ts';
import { isolated } from '../../state/announcements.ts';
import { noUnits, type Units } from '../../state/appState.ts';
import type { Choice } from '../base/rows.ts';

export const mapNames: Record<ColourMap, string> = {
    viridis: 'Viridis',
    cividis: 'Cividis',
    inferno: 'Inferno',
    plasma: 'Plasma',
    coolToWarm: 'Cool to warm',
    grey: 'Grey',
    turbo: 'Turbo',
};

const distanceName = 'Distance from the twin';
const lagName = 'Lag of the twin';

export function ageName(kind: SurfaceKind | undefined): string {
    return kind === 'time' ? 'Position across the patch' : 'Age';
}

const notSent = ' (someone who can edit has to show it first)';

/** Those that others have to compute are not for people who may only look on, unless they are there
 *  already. */
export function colourChoices(
    dataset: DatasetDescription | null,
    { kind, twin }: Pick<SurfaceRecord, 'kind' | 'twin'>,
    isThere: (field: string) => boolean,
): Choice<string>[] {
    const fields = colourFields(dataset).map(({ name }) => ({
        value: colourByField(name),
        words: isThere(name) ? isolated(name) : `${isolated(name)}${notSent}`,
        disabled: !isThere(name),
    }));
    const derived = [
        { value: deformation, words: 'Stretching' },
        { value: vorticity, words: 'Vorticity (magnitude)' },
        ...vorticityComponents.map((value) => ({ value, words: vorticityName(value) })),
        { value: qCriterion, words: 'Vortices (Q)' },
        { value: 'approximated', words: 'Approximated' },
        { value: estimatedError, words: 'Estimated error' },
        { value: intervalError, words: 'Error between stored times' },
        ...(twin === undefined
            ? []
            : [
                  { value: twinDistance, words: distanceName },
                  { value: twinLag, words: lagName },
              ]),
    ];
    return [
        { value: 'speed', words: 'Speed' },
        // Nothing is released on a level set.
        ...(kind === 'level'
            ? []
            : [
                  { value: 'age', words: ageName(kind) },
                  { value: 's', words: 'Position on the rake' },
              ]),
        ...derived
            .filter(({ value }) => canCome(dataset, value))
            .map(({ value, words }) => ({
                value,
                words: isThere(value) ? words : `${words}${notSent}`,
                disabled: !isThere(value),
            })),
        ...fields,
        { value: 'constant', words: 'Single colour' },
    ];
}

function isComponent(name: string): name is (typeof vorticityComponents)[number] {
    return (vorticityComponents as readonly string[]).includes(name);
}

function vorticityName(component: (typeof vorticityComponents)[number]): string {
    return `Vorticity ${component.slice(-1)}`;
}

/** The unit of time in one of speed, as `m/s` or `m s-1`; empty: not found. */
function timeIn(speedUnit: string): string {
    return /(?:\/\s*([^\s/]+)|[\s.·*]([A-Za-zµ]+)\s*(?:\^?-1|⁻¹))\s*$/.exec(speedUnit)?.slice(1).find(Boolean) ?? '';
}

/** The unit of how long particles are followed: where times count a solver's iterations, that of the velocity. */
export function unitOfDuration(units: Units, dataset: DatasetDescription | null): string {
    const velocity = dataset?.fields.find(({ name }) => name === dataset.velocity);
    return units.time === '' || units.time === 'iterations' ? timeIn(velocity?.unit ?? '') : units.time;
}

/** With the unit that follows from that of time, where that is known. */
function withRate(name: string, time: string, before: string, after = ''): string {
    return time === '' ? name : `${name} (${before}${time}${after})`;
}

/** The name and unit of what colours a surface now. */
export function colourTitle(
    { source, scalar }: Pick<SurfaceStyle, 'source' | 'scalar'>,
    dataset: DatasetDescription | null,
    kind: SurfaceKind | undefined,
    units: Units = noUnits,
): string {
    const velocity = dataset?.fields.find(({ name }) => name === dataset.velocity);
    const time = unitOfDuration(units, dataset);
    if (source === 's') return 'Position on the rake';
    if (source === 'age') return ageName(kind);
    if (scalar === deformation) return 'Stretching (log₂ of area)';
    if (scalar === vorticity) return withRate('|Vorticity|', time, '1/');
    if (isComponent(scalar)) return withRate(vorticityName(scalar), time, '1/');
    if (scalar === qCriterion) return withRate('Q, above 0: vortex', time, '1/', '²');
    if (scalar === 'approximated') return 'Approximated (0: no, 1: yes)';
    const length = new Map([
        [estimatedError, 'Estimated error'],
        [intervalError, 'Error between stored times'],
        [twinDistance, distanceName],
    ]).get(scalar);
    if (length !== undefined) return units.length === '' ? length : `${length} (${units.length})`;
    if (scalar === twinLag) return time === '' ? lagName : `${lagName} (${time})`;
    const field = scalar === 'speed' ? velocity : dataset?.fields.find(({ name }) => name === scalar);
    const name = scalar === 'speed' ? 'Speed' : isolated(scalar);
    return field?.unit === undefined ? name : `${name} (${isolated(field.unit)})`;
}
