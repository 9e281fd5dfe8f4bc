// Where new streamlines begin, and seeds in words.
import type { Vec3 } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { LinesPlace } from '../../session/picture/linesInPicture.ts';
import { isolated } from '../../state/announcements.ts';
import type { Patch } from '../../state/bodyPatches.ts';

export type Bounds = readonly [number, number, number, number, number, number];
export type SeedsPlace = Pick<LinesPlace, 'kind' | 'points' | 'distance' | 'patches' | 'seeds'>;

const usualSeeds = 50;
/** Off the faces of the domain, a part of its sides: seeds on a face may be outside of the cells. */
const inset = 0.02;
/** Of seeds that are off nothing. */
const elsewhere = { distance: 0, patches: [] };

/** From one end of the rake to the other. */
export function alongRake(rake: readonly Vec3[]): SeedsPlace {
    return { kind: 'line', points: [[...rake[0]!], [...rake.at(-1)!]], ...elsewhere, seeds: usualSeeds };
}

/** The whole of a plane across an axis, through a point. */
export function acrossAxis(bounds: Bounds, axis: 0 | 1 | 2, through: Vec3): SeedsPlace {
    const [u, v] = ([0, 1, 2] as const).filter((k) => k !== axis) as [number, number];
    const at = (k: number, end: 0 | 1): number => {
        const [low, high] = [bounds[2 * k]!, bounds[2 * k + 1]!];
        return end === 0 ? low + inset * (high - low) : high - inset * (high - low);
    };
    const corner = (s: 0 | 1, t: 0 | 1): Vec3 => {
        const point: Vec3 = [...within(bounds, through)];
        [point[u], point[v]] = [at(u, s), at(v, t)];
        return point;
    };
    return { kind: 'plane', points: [corner(0, 0), corner(1, 0), corner(0, 1)], ...elsewhere, seeds: 2 * usualSeeds };
}

/** About a point of any plane, as wide as a half of the shortest side of the domain. */
export function inPlane(bounds: Bounds, origin: Vec3, normal: Vec3): SeedsPlace {
    const axis = normal.findIndex((_, k) => normal.every((each, i) => (i === k) === (each !== 0)));
    if (axis >= 0) return acrossAxis(bounds, axis as 0 | 1 | 2, origin);
    const size = 0.5 * shortestOf(bounds);
    const least = [0, 1, 2].reduce((found, k) => (Math.abs(normal[k]!) < Math.abs(normal[found]!) ? k : found), 0);
    const u = unit(cross(normal, [0, 1, 2].map((k) => (k === least ? 1 : 0)) as unknown as Vec3));
    const v = unit(cross(normal, u));
    const corner = (s: number, t: number): Vec3 =>
        origin.map((each, k) => each + size * (s * u[k]! + t * v[k]!)) as unknown as Vec3;
    return {
        kind: 'plane',
        points: [corner(-0.5, -0.5), corner(0.5, -0.5), corner(-0.5, 0.5)],
        ...elsewhere,
        seeds: 2 * usualSeeds,
    };
}

export function aboutPoint(bounds: Bounds, centre: Vec3): SeedsPlace {
    return {
        kind: 'sphere',
        points: [within(bounds, centre)],
        ...elsewhere,
        distance: rounded(0.15 * shortestOf(bounds)),
        seeds: usualSeeds,
    };
}

/** @param patches  none: all walls of bodies */
export function offWalls(bounds: Bounds, patches: string[] = []): SeedsPlace {
    return { kind: 'walls', points: [], distance: rounded(0.005 * diagonalOf(bounds)), patches, seeds: 2 * usualSeeds };
}

/** On the walls, where the lines stay. @param patches  none: all walls of bodies */
export function alongWalls(patches: string[] = []): SeedsPlace {
    return { kind: 'along', points: [], ...elsewhere, patches, seeds: 4 * usualSeeds };
}

/** Names of patches, those that are no walls first: flow comes in and goes out there. */
export function patchNames(patches: readonly Patch[] = []): string[] {
    const order = ['other', 'wall', 'side'];
    return [...new Set([...patches].sort((a, b) => order.indexOf(a.kind) - order.indexOf(b.kind)).map(({ name }) => name))];
}

/** Where flow probably comes in; nothing where the boundary has no names. */
export function inletAmong(patches: readonly Patch[] | undefined): string | undefined {
    const names = patchNames(patches);
    return names.find((name) => /inlet|inflow/i.test(name)) ?? names[0];
}

export function diagonalOf(bounds: Bounds): number {
    return Math.hypot(...[0, 1, 2].map((k) => bounds[2 * k + 1]! - bounds[2 * k]!));
}

/** As short as it can be said. */
export function seedsWords({ kind, points, distance, patches, seeds }: SeedsPlace): string {
    const named = patches.map(isolated).join(', ');
    const places = {
        line: () => 'from a line',
        plane: () => `from a plane${axisWords(points)}`,
        sphere: () => `from a sphere of ${shortNumber(distance)}`,
        walls: () => `from ${shortNumber(distance)} off ${named || 'the walls'}`,
        along: () => `along ${named || 'walls'}`,
    };
    return `${seeds} ${places[kind]()}`;
}

/** Of a plane across an axis where it lies. */
function axisWords(points: readonly Vec3[]): string {
    const along = [0, 1, 2].filter((k) => points.every((each) => each[k] === points[0]![k]));
    return along.length === 1 ? `, ${'xyz'[along[0]!]!} = ${shortNumber(points[0]![along[0]!]!)}` : '';
}

function shortestOf(bounds: Bounds): number {
    return Math.min(...[0, 1, 2].map((k) => bounds[2 * k + 1]! - bounds[2 * k]!));
}

function cross(a: Vec3, b: Vec3): Vec3 {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function unit(of: Vec3): Vec3 {
    const length = Math.hypot(...of) || 1;
    return of.map((each) => each / length) as unknown as Vec3;
}

function within(bounds: Bounds, point: Vec3): Vec3 {
    return point.map((each, k) => Math.min(Math.max(each, bounds[2 * k]!), bounds[2 * k + 1]!)) as unknown as Vec3;
}

function rounded(value: number): number {
    return Number(value.toPrecision(2));
}
