// From the look that a user wants to what the picture needs: names become attributes, ranges those of the
// dataset.
import { normalNames } from '../../mesh/meshChange.ts';
import type {
    DatasetDescription,
    FieldDescription,
    RakeRecord,
    SurfaceRecord,
    SurfaceStats,
    Vec3,
} from '../../protocol/messages.ts';
import { ownerColour } from './surfaceOwner.ts';
import { niceStep } from '../../scene/base/numbers.ts';
import { steadyRange } from '../../scene/surface/colourMap.ts';
import { flowNames } from '../../scene/surface/surfaceMesh.ts';
import type { ColourSource, SurfaceStyle } from '../../scene/surface/surfaceStyle.ts';
import type { AppState } from '../../state/appState.ts';
import { type AutomaticRange, type AutomaticRanges, meaningOf, type SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';

export const deformation = 'deformation';
export const vorticity = 'vorticity';
export const qCriterion = 'q_criterion';
export const estimatedError = 'error';
export const intervalError = 'interval_error';
/** Of a surface that is compared with a twin. */
export const twinDistance = 'twin_distance';
export const twinLag = 'twin_lag';
/** Name the components of the vorticity along x, y and z. */
export const vorticityComponents = ['vorticity_x', 'vorticity_y', 'vorticity_z'] as const;
const derived: readonly string[] = [
    deformation,
    vorticity,
    ...vorticityComponents,
    qCriterion,
    'approximated',
    estimatedError,
    intervalError,
    twinDistance,
    twinLag,
];
const fieldMark = 'field:';

export interface StyleFacts {
    look: SurfaceLook;
    record: SurfaceRecord;
    rake: RakeRecord | undefined;
    dataset: DatasetDescription | null;
    speedRange: readonly [number, number];
    /** Of the newest complete state. */
    outcome?: SurfaceStats | undefined;
    /** The ranges of fields for which the user has chosen none, by meaningOf(). */
    automatic: AutomaticRanges;
    /** They are those of a film. */
    fixed: boolean;
}

/** Returns whether the server can send it with a surface; one that does not say what it can is asked for
 *  anything. */
export function canCome(dataset: DatasetDescription | null, field: string): boolean {
    return dataset?.surfaceFields?.includes(field) ?? true;
}

/** Fields that a surface can be coloured by: one number each. */
export function colourFields(dataset: DatasetDescription | null): FieldDescription[] {
    return dataset?.fields.filter(({ name, components }) => components === 1 && canCome(dataset, name)) ?? [];
}

export function colourByField(name: string): string {
    return fieldMark + name;
}

/** The name of what the server has to send; null for what it always sends or what is made here. */
function fieldOf(colourBy: string): string | null {
    if (colourBy.startsWith(fieldMark)) return colourBy.slice(fieldMark.length);
    return derived.includes(colourBy) ? colourBy : null;
}

/** With a sign that says something: stretched or gathered, turning or straining, this way round or that. */
export function isSigned(colourBy: string): boolean {
    return [deformation, qCriterion, twinLag, ...vorticityComponents].includes(colourBy);
}

/** Over powers of ten: most of the surface has a small part of what its worst place has. */
export function isLogarithmic(colourBy: string): boolean {
    return [estimatedError, intervalError, twinDistance].includes(colourBy);
}

/** The attribute on the wire; null for what is made from s and t, or is constant. */
export function attributeOf(colourBy: string): string | null {
    return colourBy === 'speed' ? 'speed' : fieldOf(colourBy);
}

/** All attributes that a look needs, those that it can do without last.
 *  @param fields of the surface: it is hatched only where it carries what that takes */
export function attributesOf(look: SurfaceLook, fields: readonly string[] = []): string[] {
    const names = [
        attributeOf(look.colourBy),
        ...(needsFlow(look) ? flowNames : []),
        look.smoke > 0 ? deformation : null,
        ...(look.curved ? normalNames : []),
        look.hatched && fields.includes(intervalError) ? intervalError : null,
    ];
    return [...new Set(names.filter((name) => name !== null))];
}

/** The flow texture and arrows follow the velocity. */
export function needsFlow({ texture, pieces }: SurfaceLook): boolean {
    return texture || pieces === 'arrows';
}

/** Returns whether the server sends the velocity with the surface. */
export function hasFlow({ fields }: Pick<SurfaceRecord, 'fields'>): boolean {
    return flowNames.every((name) => fields.includes(name));
}

export function styleOf(facts: StyleFacts): SurfaceStyle {
    const { look, record, rake, speedRange } = facts;
    const { colourBy, colour, invert, log, root, bands, ...same } = look;
    const isStreak = record.kind === 'streak';
    return {
        ...pick(same),
        ...pieceLengths(look, facts.dataset?.bounds),
        pieces: look.pieces === 'arrows' && !hasFlow(record) ? 'whole' : look.pieces,
        rakeCloses: rake?.kind === 'circle',
        source: sourceOf(colourBy),
        scalar: attributeOf(colourBy) ?? '',
        colour: colour ?? ownerColour(record, rake),
        inverted: invert,
        logarithmic: log,
        root,
        bands,
        ...rangeFor(facts),
        tIsRelease: isStreak,
        tOrigin: isStreak ? record.from : 0,
        texture: look.texture && hasFlow(record),
        textureMoves: !look.animated ? 'no' : record.kind === 'stream' ? 'byItself' : 'withTime',
        from: record.from,
        hatchAbove: look.hatched ? (facts.outcome?.separation ?? null) : null,
        fixedGrid: record.refine === 'off',
        areaPerSeed: lengthOf(rake?.points ?? []) * sweepOf(record, speedRange),
    };
}

/** Where they are not said, some 25 pieces fit across the domain, with room between them. */
export function pieceLengths(
    { pieces, pieceEvery, pieceWidth }: Pick<SurfaceLook, 'pieces' | 'pieceEvery' | 'pieceWidth'>,
    bounds: DatasetDescription['bounds'] | undefined,
): Pick<SurfaceStyle, 'pieceEvery' | 'pieceWidth'> {
    const [x0, x1, y0, y1, z0, z1] = bounds ?? [0, 1, 0, 1, 0, 1];
    const every = pieceEvery ?? niceStep(Math.hypot(x1 - x0, y1 - y0, z1 - z0) / 25);
    const usual = Number((every / (pieces === 'arrows' ? 5 : 3)).toPrecision(4));
    return { pieceEvery: every, pieceWidth: Math.min(every, pieceWidth ?? usual) };
}

type Same = 'map' | 'points' | 'centre' | 'backSide' | 'opacity' | 'angleOpacity' | 'smoke' | 'silhouettes' | 'lines';
type AlsoSame = 'density' | 'sWindow' | 'ageWindow' | 'painting' | 'faded';

function pick(look: Pick<SurfaceLook, Same | AlsoSame>): Pick<SurfaceStyle, Same | AlsoSame> {
    const { map, points, centre, backSide, opacity, angleOpacity, smoke, silhouettes, lines } = look;
    const { density, sWindow, ageWindow, painting, faded } = look;
    return {
        ...{ map, points, centre, backSide, opacity, angleOpacity, smoke, silhouettes, lines },
        ...{ density, sWindow, ageWindow, painting, faded },
    };
}

function sourceOf(colourBy: string): ColourSource {
    if (attributeOf(colourBy) !== null) return 'scalar';
    if (colourBy === 's' || colourBy === 'age') return colourBy;
    return 'constant';
}

type RangeStyle = Pick<SurfaceStyle, 'range' | 'rangeOf' | 'beyond'>;
const nothingBeyond = [null, null] as const;

function rangeFor({ look, record, dataset, speedRange, automatic, fixed }: StyleFacts): RangeStyle {
    const { colourBy, range, rangeOf } = look;
    if (range !== null) return { range, rangeOf: 'locked', beyond: nothingBeyond };
    const always = colourBy === 'approximated' || colourBy === 's';
    const known = always || rangeOf === 'data' ? knownRange(colourBy, dataset, speedRange) : null;
    if (known !== null) return { range: known, rangeOf: always ? 'surface' : 'data', beyond: nothingBeyond };
    const seen = automatic.get(meaningOf(look, record));
    // Of a server that does not tell, or has not yet: what the scene finds.
    if (seen === undefined) return { range: null, rangeOf: 'surface', beyond: nothingBeyond };
    return { ...endsOf(look, seen), rangeOf: fixed ? 'film' : seen.surfaces > 1 ? 'surfaces' : 'surface' };
}

/** Rounded outward, so that small changes leave them as they are. */
function endsOf({ colourBy, log }: SurfaceLook, seen: AutomaticRange): Pick<RangeStyle, 'range' | 'beyond'> {
    if (log || colourBy === 'age') return { range: [seen.least, seen.greatest], beyond: nothingBeyond };
    const [low, high] = steadyRange(seen.low, seen.high);
    return { range: [low, high], beyond: [seen.least < low ? seen.least : null, seen.greatest > high ? seen.greatest : null] };
}

/** Returns the range of all the data. Null: only what has been seen tells. */
export function knownRange(
    colourBy: string,
    dataset: DatasetDescription | null,
    speedRange: readonly [number, number],
): readonly [number, number] | null {
    if (colourBy === 'speed') return speedRange;
    if (colourBy === 'approximated' || colourBy === 's') return [0, 1];
    const field = dataset?.fields.find(({ name }) => colourByField(name) === colourBy);
    const [least, most] = field?.range ?? [null, null];
    return least === null || most === null ? null : [least, most];
}

function lengthOf(points: readonly Vec3[]): number {
    let length = 0;
    for (let i = 1; i < points.length; ++i) {
        length += Math.hypot(...points[i]!.map((x, axis) => x - points[i - 1]![axis]!));
    }
    return length > 0 ? length : 1;
}

/** Returns how far one unit of t carries, as the surface is released. */
function sweepOf({ kind, sweep }: SurfaceRecord, speedRange: readonly [number, number]): number {
    return kind === 'time' && sweep !== undefined ? Math.hypot(...sweep) : meanSpeed(speedRange);
}

function meanSpeed([slow, fast]: readonly [number, number]): number {
    return (slow + fast) / 2 || 1;
}

/**
 * What colours stand for where no user has chosen it: one range for all surfaces that show the same field in this picture. A
 * surface's values range over what the server tells everyone, so that people who come late, or reload, see the same colours;
 * while it plays the range only grows.
 */
export function automaticRanges(
    state: Pick<AppState, 'surfaces' | 'hiddenSurfaces' | 'valueRanges'>,
    view: Pick<ViewState, 'lookOf'>,
): AutomaticRanges {
    const ranges = new Map<string, AutomaticRange>();
    for (const [id, record] of state.surfaces.value) {
        const look = view.lookOf(id);
        if (state.hiddenSurfaces.value.has(id) || look.range !== null) continue;
        const attribute = look.colourBy === 'age' ? 't' : attributeOf(look.colourBy);
        const announced = state.valueRanges.value.get(id)?.find((each) => each.attribute === attribute);
        if (announced === undefined) continue;
        const meaning = meaningOf(look, record);
        const { low, high, least, greatest } = announced;
        ranges.set(meaning, joinedRange({ surfaces: 1, low, high, least, greatest }, ranges.get(meaning)));
    }
    return ranges;
}

/** What both cover, of the meanings that the first has. */
export function joinedRanges(own: AutomaticRanges, others: AutomaticRanges): AutomaticRanges {
    return new Map([...own].map(([meaning, range]) => [meaning, joinedRange(range, others.get(meaning))]));
}

function joinedRange(a: AutomaticRange, b: AutomaticRange = a): AutomaticRange {
    return {
        surfaces: a === b ? a.surfaces : a.surfaces + b.surfaces,
        low: Math.min(a.low, b.low),
        high: Math.max(a.high, b.high),
        least: Math.min(a.least, b.least),
        greatest: Math.max(a.greatest, b.greatest),
    };
}
