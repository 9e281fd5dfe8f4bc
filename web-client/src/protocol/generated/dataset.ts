// Made by protocol/api/generate from dataset.schema.json: do not edit.
import { flag, list, members, number, oneOf, optional, orNull, point, text, whole } from '../checks.ts';
import { type Vec3 } from '../vec3.ts';
import { latticeCheck, problemCheck, type Lattice, type Problem } from './shared.ts';

/** how far the import is */
export const datasetStates = ['ready', 'importing', 'failed', 'stopped', 'incomplete'] as const;
export type DatasetState = (typeof datasetStates)[number];
export const datasetStateCheck = oneOf(datasetStates);

/** Time-steps. */
export interface Steps {
    /** that can be used */
    ready: number;
    /** that there will be */
    total: number;
}

export const stepsCheck = members<Steps>({ ready: whole, total: whole });

/** A dataset in a list. */
export interface DatasetEntry {
    /** its id */
    dataset: string;
    /** for people */
    name: string;
    /** how far the import is */
    state: DatasetState;
    /** its time-steps */
    steps: Steps;
    /** of the import */
    progress?: number;
    /** that the import will still take (s) */
    remaining?: number;
    /** why the import failed or ended early */
    error?: Problem;
}

export const datasetEntryCheck = members<DatasetEntry>({
    dataset: text,
    name: text,
    state: datasetStateCheck,
    steps: stepsCheck,
    progress: optional(number),
    remaining: optional(number),
    error: optional(problemCheck),
});

/** A field of a dataset. */
export interface Field {
    /** as in the files */
    name: string;
    /** 3: a vector */
    components: number;
    /** where the files have it */
    source: 'point' | 'cell';
    /** least and largest value, of a vector's length; null: unknown */
    range: [number | null, number | null];
    /** as in the files */
    unit?: string;
}

export const fieldCheck = members<Field>({
    name: text,
    components: whole,
    source: oneOf(['point', 'cell']),
    range: list(orNull(number), 2),
    unit: optional(text),
});

/** What a dataset is. */
export interface Dataset {
    /** its id */
    dataset: string;
    /** for people */
    name: string;
    /** what read the files */
    reader: string;
    /** kind of grid */
    grid: 'uniform' | 'rectilinear' | 'curvilinear' | 'unstructured' | 'analytic';
    /** x0, x1, y0, y1, z0, z1 (the dataset's unit of length) */
    bounds: [number, number, number, number, number, number];
    /** of the grid */
    points: number;
    /** of the grid */
    cells: number;
    /** of the time-steps (the dataset's unit of time) */
    times: number[];
    /** it does not change in time */
    steady: boolean;
    /** all of them */
    fields: Field[];
    /** name of the field that particles follow */
    velocity: string;
    /** this field is the velocity because */
    why: string;
    /** there is an obstacle in the flow */
    obstacle: boolean;
    /** of a time-step in memory (bytes) */
    bytesPerStep: number;
    /** of the grid (the dataset's unit of length) */
    finestSpacing: number;
    /** of the frames of its surfaces */
    lattice: Lattice;
    /** what `fields` of surface.set may name */
    surfaceFields: string[];
    /** something to know about the data, for people */
    note?: string;
    /** half: kept with 16 bits a number */
    precision?: 'half';
    /** points along x, y, z */
    dimensions?: [number, number, number];
    /** of a uniform grid (the dataset's unit of length) */
    spacing?: Vec3;
}

export const datasetCheck = members<Dataset>({
    dataset: text,
    name: text,
    reader: text,
    grid: oneOf(['uniform', 'rectilinear', 'curvilinear', 'unstructured', 'analytic']),
    bounds: list(number, 6),
    points: whole,
    cells: whole,
    times: list(number),
    steady: flag,
    fields: list(fieldCheck),
    velocity: text,
    why: text,
    obstacle: flag,
    bytesPerStep: whole,
    finestSpacing: number,
    lattice: latticeCheck,
    surfaceFields: list(text),
    note: optional(text),
    precision: optional(oneOf(['half'])),
    dimensions: optional(list(whole, 3)),
    spacing: optional(point),
});

/** resident: in memory */
export const stepStates = ['resident', 'loading', 'cold'] as const;
export type StepState = (typeof stepStates)[number];
export const stepStateCheck = oneOf(stepStates);

/** Which time-steps are in memory. */
export interface CacheStatus {
    /** its id */
    dataset: string;
    /** one state a time-step; none of a built-in flow */
    steps: StepState[];
    /** in memory (bytes) */
    bytes: number;
    /** that may be in memory (bytes) */
    budget: number;
}

export const cacheStatusCheck = members<CacheStatus>({ dataset: text, steps: list(stepStateCheck), bytes: whole, budget: whole });

/** What dataset.list answers. */
export interface DatasetListResult {
    /** all of them */
    datasets: DatasetEntry[];
}

/** Parameters of dataset.describe. */
export interface DatasetDescribeParams {
    /** an id from dataset.list */
    dataset: string;
}

/** Parameters of dataset.open. */
export interface DatasetOpenParams {
    /** an id from dataset.list */
    dataset: string;
    /** patience; 0: no waiting (ms) */
    timeoutMs?: number;
    /** on a WebSocket: $/progress with this token tells how far the work is */
    workDoneToken?: string | number;
}

/** Parameters of cache.status. */
export interface CacheStatusParams {
    /** an id from dataset.list */
    dataset: string;
}

/** Parameters of probe.sample. */
export interface ProbeSampleParams {
    /** an id from dataset.list */
    dataset: string;
    /** where (the dataset's unit of length) */
    points: Vec3[];
    /** in the dataset's range (the dataset's unit of time) */
    time: number;
    /** the velocity's name or scalars; left out: the velocity */
    fields?: string[];
}

/** What probe.sample answers. */
export interface ProbeSampleResult {
    /** by the name of a field, one a point; null: none there */
    values: Record<string, (number | null | Vec3)[]>;
    /** which points are in the fluid */
    inside: boolean[];
}
