// Made by protocol/api/generate from family.schema.json: do not edit.
import { list, members, number, oneOf, optional, point, text, whole } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';
import { type RakeKind, rakeKindCheck } from './rake.ts';
import { type Accuracy, accuracyCheck } from './surface.ts';

/**
 * where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane; curve: it is
 * the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface through the curve
 */
export const familySources = ['inflow', 'plane', 'curve'] as const;
export type FamilySource = (typeof familySources)[number];
export const familySourceCheck = oneOf(familySources);

/** What came of a family at one time-step. */
export interface FamilyStep {
    /** index of the time-step */
    index: number;
    /** its time (the dataset's unit of time) */
    time: number;
    /** number of nodes */
    nodes: number;
    /** nodes whose way leads to the source: only these have a value */
    reached: number;
    /** nodes that are at rest, or come to rest */
    atRest: number;
    /** nodes in an obstacle, or whose way ends at one */
    obstacle: number;
    /** nodes that were followed for `length` without an end, as where the flow turns in circles */
    lost: number;
    /** nodes whose way leaves the domain beside the source, and nodes without a velocity */
    outside: number;
    /** smallest and largest value */
    range: [number, number];
}

export const familyStepCheck = members<FamilyStep>({
    index: whole,
    time: number,
    nodes: whole,
    reached: whole,
    atRest: whole,
    obstacle: whole,
    lost: whole,
    outside: whole,
    range: list(number, 2),
});

/** A family of stream surfaces of a dataset, with what it was made from. */
export interface Family {
    /** name of the field: letters, digits, and _ - . */
    name: string;
    /**
     * where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane; curve: it
     * is the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface through the
     * curve
     */
    from: FamilySource;
    /** of inflow and plane: x, y, z or the field that was taken there */
    scalar?: string;
    /** of a plane: a point of it (the dataset's unit of length) */
    point?: Vec3;
    /** of a plane: its normal (the dataset's unit of length) */
    normal?: Vec3;
    /** of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle */
    rakeKind?: RakeKind;
    /** of a curve: its points; the ends of a line or a polyline are continued straight */
    points?: Vec3[];
    /** how accurately particles are traced and vertices inserted */
    accuracy: Accuracy;
    /** how far nodes were followed at most (the dataset's unit of length) */
    length: number;
    /** version of the program that made it */
    version: string;
    /** the time-steps it was made for; at others it has no value */
    steps: FamilyStep[];
}

export const familyCheck = members<Family>({
    name: text,
    from: familySourceCheck,
    scalar: optional(text),
    point: optional(point),
    normal: optional(point),
    rakeKind: optional(rakeKindCheck),
    points: optional(list(point)),
    accuracy: accuracyCheck,
    length: number,
    version: text,
    steps: list(familyStepCheck),
});

/** Parameters of family.make. */
export interface FamilyMakeParams {
    /** an id from dataset.list */
    dataset: string;
    /** name of the field, which no other field may have: letters, digits, and _ - . */
    name: string;
    /**
     * where the scalar is given; inflow: on the boundary through which the flow enters; plane: on a plane; curve: it
     * is the distance from a curve, in the plane of the curve, so that the level 0 is the stream surface through the
     * curve
     */
    from: FamilySource;
    /** of inflow and plane: x, y or z, or a scalar field of the dataset; empty: y */
    scalar?: string;
    /** of a plane: a point of it (the dataset's unit of length) */
    point?: Vec3;
    /**
     * of a plane: its normal, of any length; the plane counts where the flow passes it the way that most of it does
     * (the dataset's unit of length)
     */
    normal?: Vec3;
    /** of a curve: what the points are, as of a rake: a line, a polyline in one plane, or a circle */
    rakeKind?: RakeKind;
    /** of a curve: its points; the ends of a line or a polyline are continued straight */
    points?: Vec3[];
    /** the nearest time-step is taken; if left out, the first one (the dataset's unit of time) */
    time?: number;
    /** how accurately particles are traced and vertices inserted */
    accuracy?: Accuracy;
    /** how far a node is followed at most; if left out, ten diagonals of the domain (the dataset's unit of length) */
    length?: number;
    /** on a WebSocket: $/progress reports the progress of the work with this token */
    workDoneToken?: string | number;
}

/** Parameters of family.remove. */
export interface FamilyRemoveParams {
    /** an id from dataset.list */
    dataset: string;
    /** name of the field: letters, digits, and _ - . */
    name: string;
}
