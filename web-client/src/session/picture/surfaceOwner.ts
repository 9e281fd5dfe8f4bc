// Under which name and colour a surface stands in lists and beside scalar bars: those of its rake; an isosurface, which has none, by its
// field and level.
import type { DatasetDescription, RakeRecord, SurfaceRecord } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';

/** Calm ones: an isosurface fills much of the picture. */
const isosurfaceColours = ['#8fb8de', '#e0b478', '#93c9a1', '#d39ac0', '#b7a8e0', '#d6d49a'] as const;

/** The velocity along the normal of a plane. */
export const velocityAcross = 'velocity_normal';

/** A stored scalar may have that name. */
export function isVelocityAcross(name: string, dataset: Pick<DatasetDescription, 'fields'> | null): boolean {
    return name === velocityAcross && !dataset?.fields.some((field) => field.name === name);
}

export function fieldWords(name: string, dataset: Pick<DatasetDescription, 'fields' | 'velocity'> | null): string {
    if (name === dataset?.velocity) return `${isolated(name)} (speed)`;
    if (name === 'q_criterion') return 'Vortices (Q)';
    if (isVelocityAcross(name, dataset)) return 'Velocity across the plane';
    return name === 'vorticity' ? 'Vorticity (magnitude)' : name;
}

export function isosurfaceWords({ field = '', level = 0 }: SurfaceRecord, dataset: DatasetDescription | null): string {
    return `${fieldWords(field, dataset)} = ${shortNumber(Number(level.toPrecision(4)))}`;
}

export function ownerName(state: Pick<AppState, 'described' | 'rakes'>, record: SurfaceRecord): string {
    if (record.rake === undefined) return isosurfaceWords(record, state.described(record.dataset));
    return state.rakes.value.get(record.rake)?.name || record.rake;
}

/** The colour of a surface that is coloured by nothing. */
export function ownerColour({ rake: own, surface }: SurfaceRecord, rake: RakeRecord | undefined): string {
    const number = own === undefined ? Number.parseInt(surface.slice(1), 10) || 0 : 1;
    return rake?.colour ?? isosurfaceColours[(number + isosurfaceColours.length - 1) % isosurfaceColours.length]!;
}
