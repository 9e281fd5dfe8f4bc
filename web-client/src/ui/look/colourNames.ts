// What a surface can be coloured by, and the colour maps, in words.
import type { DatasetDescription, SurfaceKind } from '../../protocol/messages.ts';
import type { SurfaceStyle } from '../../scene/surface/surfaceStyle.ts';
import {
    canCome,
    colourByField,
    colourFields,
    deformation,
    estimatedError,
    qCriterion,
    vorticity,
} from '../../session/picture/surfaceStyleOf.ts';
import type { ColourMap } from '../../state/surfaceLook.ts';
import type { Choice } from './lookStyles.ts';

export const mapNames: Record<ColourMap, string> = {
    viridis: 'Viridis',
    cividis: 'Cividis',
    inferno: 'Inferno',
    plasma: 'Plasma',
    coolToWarm: 'Cool to warm',
    grey: 'Grey',
    turbo: 'Turbo',
};

export function ageName(kind: SurfaceKind | undefined): string {
    return kind === 'time' ? 'Position across the patch' : 'Age';
}

/** Those that others have to compute are not for people who may only look on, unless they are there already. */
export function colourChoices(
    dataset: DatasetDescription | null,
    kind: SurfaceKind | undefined,
    isThere: (field: string) => boolean,
): Choice<string>[] {
    const fields = colourFields(dataset).map(({ name }) => ({
        value: colourByField(name),
        words: name,
        disabled: !isThere(name),
    }));
    const derived = [
        { value: deformation, words: 'Stretching' },
        { value: vorticity, words: 'Vorticity' },
        { value: qCriterion, words: 'Vortices (Q)' },
        { value: 'approximated', words: 'Approximated' },
        { value: estimatedError, words: 'Estimated error' },
    ];
    return [
        { value: 'speed', words: 'Speed' },
        { value: 'age', words: ageName(kind) },
        { value: 's', words: 'Position on the rake' },
        ...derived.filter(({ value }) => canCome(dataset, value)).map((each) => ({ ...each, disabled: !isThere(each.value) })),
        ...fields,
        { value: 'constant', words: 'Single colour' },
    ];
}

/** The name and unit of what colours a surface now. */
export function colourTitle(
    { source, scalar }: SurfaceStyle,
    dataset: DatasetDescription | null,
    kind: SurfaceKind | undefined,
    lengthUnit = '',
): string {
    if (source === 's') return 'Position on the rake';
    if (source === 'age') return ageName(kind);
    if (scalar === deformation) return 'Stretching (log₂ of area)';
    if (scalar === vorticity) return 'Vorticity';
    if (scalar === qCriterion) return 'Q (above 0: vortex)';
    if (scalar === 'approximated') return 'Approximated (0: no, 1: yes)';
    if (scalar === estimatedError) return lengthUnit === '' ? 'Estimated error' : `Estimated error (${lengthUnit})`;
    const field = dataset?.fields.find(({ name }) => name === (scalar === 'speed' ? dataset.velocity : scalar));
    const name = scalar === 'speed' ? 'Speed' : scalar;
    return field?.unit === undefined ? name : `${name} (${field.unit})`;
}
