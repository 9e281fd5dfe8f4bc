// Made by protocol/api/generate from dataset.schema.json: do not edit.
import { flag, list, members, number, oneOf, optional, orNull, point, text, tuple, whole } from '../checks.ts';
import type { Vec3 } from '../vec3.ts';
import { type Family, familyCheck } from './family.ts';
import { type Lattice, type Problem, latticeCheck, problemCheck } from './shared.ts';
import { type SurfaceKind, surfaceKindCheck } from './surface.ts';

/** state of the import */
export const datasetStates = ['ready', 'importing', 'failed', 'stopped', 'incomplete'] as const;
export type DatasetState = (typeof datasetStates)[number];
export const datasetStateCheck = oneOf(datasetStates);

/** Numbers of time-steps. */
export interface Steps {
    /** time-steps that can be used */
    ready: number;
    /** time-steps that there will be after the import */
    total: number;
}

export const stepsCheck = members<Steps>({ ready: whole, total: whole });

/** A dataset as a list shows it. */
export interface DatasetEntry {
    /** id of the dataset */
    dataset: string;
    /** display name */
    name: string;
    /** state of the import */
    state: DatasetState;
    /** numbers of time-steps */
    steps: Steps;
    /** progress of the import */
    progress?: number;
    /** time that the import still needs (s) */
    remaining?: number;
    /** what the values that are stored are told from others by; left out for a built-in flow */
    values?: string;
    /**
     * of a dataset that failed because it is not clear which field is the velocity: what `velocity` of dataset.open
     * may be
     */
    velocities?: string[];
    /** names of the families of stream surfaces that are kept with its data; left out if there are none */
    families?: string[];
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
    values: optional(text),
    velocities: optional(list(text)),
    families: optional(list(text)),
    error: optional(problemCheck),
});

/** A field of a dataset. */
export interface Field {
    /** name of the field in the files */
    name: string;
    /** number of components; 3: a vector */
    components: number;
    /** whether the files have the values at points or in cells */
    source: 'point' | 'cell';
    /** smallest and largest value (for a vector, of its magnitude); null: unknown */
    range: [number | null, number | null];
    /** unit of the values, as stated in the files */
    unit?: string;
    /** true: a family of stream surfaces, which was made from the velocity by family.make */
    family?: boolean;
    /** false: imports leave it out, as they do masks and arrays that the velocity is made of; surfaces cannot carry it */
    stored?: boolean;
}

export const fieldCheck = members<Field>({
    name: text,
    components: whole,
    source: oneOf(['point', 'cell']),
    range: list(orNull(number), 2),
    unit: optional(text),
    family: optional(flag),
    stored: optional(flag),
});

/** The description of a dataset. */
export interface Dataset {
    /** id of the dataset */
    dataset: string;
    /** display name */
    name: string;
    /** name of the reader that read the files */
    reader: string;
    /** kind of grid */
    grid: 'uniform' | 'rectilinear' | 'curvilinear' | 'unstructured' | 'analytic';
    /** bounding box: x0, x1, y0, y1, z0, z1 (the dataset's unit of length) */
    bounds: [number, number, number, number, number, number];
    /** number of points of the grid */
    points: number;
    /** number of cells of the grid */
    cells: number;
    /** times of the time-steps (the dataset's unit of time) */
    times: number[];
    /** true: the flow does not change in time */
    steady: boolean;
    /** all fields */
    fields: Field[];
    /** name of the field that particles follow */
    velocity: string;
    /** why this field was taken as the velocity */
    why: string;
    /** true: there is an obstacle in the flow */
    obstacle: boolean;
    /** memory that one time-step takes (bytes) */
    bytesPerStep: number;
    /** smallest spacing of the grid (the dataset's unit of length) */
    finestSpacing: number;
    /** lattice of the frames of its surfaces */
    lattice: Lattice;
    /** true: surface.set accepts `interpolation` smooth */
    smooth: boolean;
    /** names that `fields` of surface.set accepts */
    surfaceFields: string[];
    /** families of stream surfaces, which are among its fields; left out if there are none */
    families?: Family[];
    /** a remark about the data, for people */
    note?: string;
    /** unit of lengths and coordinates; left out if the files do not state it */
    lengthUnit?: string;
    /** unit of times; left out if the files do not state it */
    timeUnit?: string;
    /** half: the values are stored with 16 bits each */
    precision?: 'half';
    /** number of points along x, y and z */
    dimensions?: [number, number, number];
    /** spacing of a uniform grid along x, y and z (the dataset's unit of length) */
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
    smooth: flag,
    surfaceFields: list(text),
    families: optional(list(familyCheck)),
    note: optional(text),
    lengthUnit: optional(text),
    timeUnit: optional(text),
    precision: optional(oneOf(['half'])),
    dimensions: optional(list(whole, 3)),
    spacing: optional(point),
});

/** Parameters to begin a surface with, as surface.set takes them. */
export interface SuggestedSurface {
    /**
     * stream: streamlines of the field frozen at `from`; path: particles released together at `from`; streak:
     * particles released continuously from `from` on; time: a patch of particles released at `from`; level: where
     * `field` has the value `level`, at the time that is shown between `from` and `to`
     */
    kind: SurfaceKind;
    /** where the surface starts (the dataset's unit of time) */
    from: number;
    /** where it ends (the dataset's unit of time) */
    to: number;
    /** longest edge allowed (the dataset's unit of length) */
    separation: number;
    /** of a time surface: the patch is the rake swept along this vector (the dataset's unit of length) */
    sweep?: Vec3;
}

export const suggestedSurfaceCheck = members<SuggestedSurface>({
    kind: surfaceKindCheck,
    from: number,
    to: number,
    separation: number,
    sweep: optional(point),
});

/** A line to release particles from, as rake.set takes it. */
export interface SuggestedRake {
    /** kind of rake */
    kind: 'line';
    /** both ends of the line (the dataset's unit of length) */
    points: [Vec3, Vec3];
    /** initial number of seeds */
    seeds: number;
}

export const suggestedRakeCheck = members<SuggestedRake>({ kind: oneOf(['line']), points: list(point, 2), seeds: whole });

/** resident: in memory, or a part of it is; loading: being read; cold: not in memory */
export const stepStates = ['resident', 'loading', 'cold'] as const;
export type StepState = (typeof stepStates)[number];
export const stepStateCheck = oneOf(stepStates);

/** how much of a time-step is in memory, and how much is being read */
export type StepHeld = [number, number];
export const stepHeldCheck = tuple<StepHeld>([whole, whole]);

/** the index of a time-step, how many bytes of it are in memory now, and how many are being read */
export type HeldChange = [number, number, number];
export const heldChangeCheck = tuple<HeldChange>([whole, whole, whole]);

/** the index of a time-step, and its state now */
export type StepChange = [number, StepState];
export const stepChangeCheck = tuple<StepChange>([whole, stepStateCheck]);

/** Which time-steps are in memory, and how much of each. */
export interface CacheStatus {
    /** id of the dataset */
    dataset: string;
    /** state of each time-step; empty for a built-in flow */
    steps: StepState[];
    /**
     * of the velocity of each time-step, how many bytes are in memory and how many are being read, as [resident,
     * loading]: all or none, or a part where large time-steps are read by brick
     */
    held: StepHeld[];
    /** of a time-step that is in memory as a whole, in `held` (bytes) */
    bytesPerStep: number;
    /** memory that the time-steps take (bytes) */
    bytes: number;
    /** memory that the time-steps may take (bytes) */
    budget: number;
}

export const cacheStatusCheck = members<CacheStatus>({
    dataset: text,
    steps: list(stepStateCheck),
    held: list(stepHeldCheck),
    bytesPerStep: whole,
    bytes: whole,
    budget: whole,
});

/** What dataset.list answers. */
export interface DatasetListResult {
    /** all datasets */
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
    /** how long to wait, at most; 0: do not wait (ms) */
    timeoutMs?: number;
    /**
     * velocity of files in which it is not clear, by name: a vector, three scalars `u,v,w`, or a momentum and its
     * density; empty: by the names of the fields. For editors; it is kept beside the imported data. `velocities` of a
     * dataset that failed lists what could be meant
     */
    velocity?: string;
    /** on a WebSocket: $/progress reports the progress of the work with this token */
    workDoneToken?: string | number;
}

/** Parameters of dataset.suggest. */
export interface DatasetSuggestParams {
    /** an id from dataset.list */
    dataset: string;
}

/** What dataset.suggest answers. */
export interface DatasetSuggestResult {
    /** the rake */
    rake: SuggestedRake;
    /** one of each kind that the data allow: a single time-step of an unsteady flow allows stream surfaces only */
    surfaces: SuggestedSurface[];
    /** what was chosen and why, for people */
    why: string;
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
    /** points to sample (the dataset's unit of length) */
    points: Vec3[];
    /** simulation time, in the dataset's range (the dataset's unit of time) */
    time: number;
    /** name of the velocity, or names of scalar fields; if left out, the velocity */
    fields?: string[];
}

/** What probe.sample answers. */
export interface ProbeSampleResult {
    /** for each field, by its name, one value for each point; null: there is no value at that point */
    values: Record<string, (number | null | Vec3)[]>;
    /** for each point, whether it is in the fluid */
    inside: boolean[];
}
