// Rakes that stand off a body: along a line that is drawn on it, click by click, along a sharp edge of it or the outline of a patch. Loaded after
// the first picture.
import { computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals-core';
import { limits } from '../../protocol/generated/limits.ts';
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { ScreenPoint } from '../../scene/base/view.ts';
import { minus, type RakeShape } from '../../scene/rake/rakeShape.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { PickHit } from '../../scene/surface/pickHit.ts';
import type { AppState } from '../../state/appState.ts';
import { type Patch, patchSpans } from '../../state/bodyPatches.ts';
import { newBodyRake, type ViewState } from '../../state/viewState.ts';
import type { RecordActions } from '../edits/recordActions.ts';
import { gridOf } from '../base/gridOf.ts';
import type { Triangles } from './bodyEdges.ts';
import { liesOn, outlineOf, simplified, standOff, wayAlong, type WayPoint } from './bodyWay.ts';
import { sharpEdgeNear } from './sharpEdge.ts';

export interface BodyRakesOptions {
    state: Pick<AppState, 'allPatchesShown' | 'dataset' | 'datasets' | 'locked' | 'role'>;
    view: Pick<ViewState, 'besidePointer' | 'bodyWay' | 'chosenThing' | 'tool'>;
    scene: Pick<FlowScene, 'body' | 'pickGrid' | 'view'> & { pointerTools: Pick<FlowScene['pointerTools'], 'add'> };
    actions: Pick<RecordActions, 'newRake'>;
}

/** Of the domain's diagonal: how far a rake stands off, unless someone says so. */
const usuallyOff = 0.005;
const leastOff = 1e-6;
/** Of how far it stands off: so exactly it follows the body. */
const exactness = 0.05;
/** So far beside the pointer, in pixels, an edge and a body are found: what is sharp is often at the rim of what is seen. */
const edgeWithinPx = 12;
/** A rake of more is tedious to change. */
const mostPoints = Math.min(200, limits.rakePoints);

export class BodyRakes implements PointerTool {
    /** Null: as usual. */
    readonly typedOff = signal<number | null>(null);
    readonly off: ReadonlySignal<number>;
    /** The least and the most that it can be. */
    readonly offSpan: ReadonlySignal<readonly [number, number]>;
    /** A click takes the sharp edge there: it is no point of a line. */
    readonly alongEdge = signal(false);
    /** Rakes can be made, and none is being made. */
    readonly canMake: ReadonlySignal<boolean>;
    private readonly making = signal(false);
    private readonly options: BodyRakesOptions;
    private clicked: Vec3[] = [];
    private way: WayPoint[] = [];
    /** From the first point. */
    private towards: Vec3 = [0, 0, 0];

    constructor(options: BodyRakesOptions) {
        this.options = options;
        const { state, view, scene } = options;
        const part = (of: number): number => Number((of * diagonalOf(state.dataset.value)).toPrecision(2));
        this.off = computed(() => this.typedOff.value ?? part(usuallyOff));
        this.offSpan = computed(() => [part(leastOff), part(1)]);
        this.canMake = computed(() => !state.locked.value && !this.making.value);
        scene.pointerTools.add(this);
        // What was drawn and typed is of one body.
        const body = computed(() => {
            const id = state.dataset.value?.dataset;
            return `${id} ${gridOf(state.datasets.value.find(({ dataset }) => dataset === id)?.values)}`;
        });
        effect(() => {
            void body.value;
            untracked(() => {
                this.typedOff.value = null;
                this.putAway();
            });
        });
        // The tool is in the hand for as long as its settings are seen.
        effect(() => {
            if (view.chosenThing.value === newBodyRake) view.tool.value = 'bodyRake';
            else if (view.tool.peek() === 'bodyRake') view.tool.value = 'none';
        });
        effect(() => {
            if (view.tool.value === 'bodyRake') return;
            this.clear();
            if (view.chosenThing.peek() === newBodyRake) view.chosenThing.value = null;
        });
        effect(() => {
            void this.off.value;
            this.show();
        });
        effect(() => {
            void this.alongEdge.value;
            untracked(() => this.clear());
        });
        // A connection that is lost may come back.
        effect(() => {
            if (state.role.value === 'viewer' && view.tool.value === 'bodyRake') this.putAway();
        });
    }

    /** There is a line. */
    get canEnd(): boolean {
        return this.options.view.bodyWay.value.way.length > 1 && this.canMake.value;
    }

    click({ at }: Pointer): boolean {
        const { view, scene } = this.options;
        if (view.tool.value !== 'bodyRake') return false;
        const say = (words: string): void => void (view.besidePointer.value = { at, words });
        const hit = this.hitAt(at, this.alongEdge.value ? edgeWithinPx : 0);
        const body = this.shown();
        if (hit === null || body === null) {
            say('There is no body here. Click on one.');
            return true;
        }
        const eye = scene.view().outside;
        const before = this.clicked.at(-1);
        if ((this.alongEdge.value || before === undefined) && !liesOn(body, hit.point, eye)) {
            say('There is no body of this dataset here.');
            return true;
        }
        if (this.alongEdge.value) {
            const within = edgeWithinPx * scene.view().worldPerPx(hit.point);
            const edge = sharpEdgeNear(body, hit.point, eye, within, isStepped(this.options.state.dataset.value));
            [this.clicked, this.way] = typeof edge === 'string' ? [[], []] : [[hit.point], edge];
            say(typeof edge === 'string' ? edge : 'Enter makes the rake, or click another edge.');
            this.show();
            return true;
        }
        if (before === undefined) {
            this.clicked = [hit.point];
            this.towards = minus(eye, hit.point);
            say('Click the next point.');
        } else {
            const piece = wayAlong(body, before, hit.point, eye, this.way.at(-1)?.off ?? this.towards);
            if (piece === null) {
                say('No way leads here along the body, as it is seen. Click elsewhere.');
                return true;
            }
            this.way = [...this.way.slice(0, -1), ...piece];
            this.clicked = [...this.clicked, hit.point];
            say('Enter ends the line, or click on.');
        }
        this.show();
        return true;
    }

    hover(): string | null {
        return this.options.view.tool.value === 'bodyRake' ? 'crosshair' : null;
    }

    /** Makes the rake of the line that was drawn. */
    end(): Promise<void> {
        return this.make(this.way);
    }

    /** Says why there is none in words; null: it is being made. */
    outline(patch: Patch): string | null {
        const { state, scene } = this.options;
        const all = state.allPatchesShown.value;
        const span = patchSpans(state.dataset.value, all).get(patch);
        const body = scene.body.triangles;
        if (span === undefined || body === null) return 'Show the patch in the picture first, under Body.';
        const indices = body.indices.subarray(6 * span[0], 6 * span[1]);
        const eye = scene.view().outside;
        const middle = middleOf(state.dataset.value!);
        const isWall = patch.kind === 'wall';
        const way = outlineOf({ positions: body.positions, indices }, (at) => minus(isWall ? eye : middle, at), !isWall);
        if (typeof way === 'string') return way;
        void this.make(way);
        return null;
    }

    /** The nearest of what is seen round a place, if that is a body. */
    private hitAt(at: ScreenPoint, radius: number): PickHit | null {
        const { corner, size, hits } = this.options.scene.pickGrid(at, radius, {});
        const apart = (i: number): number => Math.hypot(corner.x + (i % size) - at.x, corner.y + Math.floor(i / size) - at.y);
        const seen = hits.flatMap((hit, i) => (hit === null ? [] : [{ hit, apart: apart(i) }]));
        const hit = seen.sort((a, b) => a.apart - b.apart)[0]?.hit;
        return hit?.surface === null ? hit : null;
    }

    private async make(way: readonly WayPoint[]): Promise<void> {
        if (!this.canMake.value) return;
        const off = this.off.value;
        const shape: RakeShape = { kind: 'polyline', points: simplified(standOff(way, off), exactness * off, mostPoints) };
        this.making.value = true;
        const isMade = await this.options.actions.newRake(shape);
        this.making.value = false;
        if (isMade) this.putAway();
    }

    private putAway(): void {
        const { tool } = this.options.view;
        if (tool.value === 'bodyRake') tool.value = 'none';
    }

    private shown(): Triangles | null {
        const body = this.options.scene.body.triangles;
        return body === null ? null : { ...body, indices: body.shown };
    }

    private show(): void {
        this.options.view.bodyWay.value = { clicked: this.clicked, way: standOff(this.way, this.off.value) };
    }

    private clear(): void {
        if (this.clicked.length === 0) return;
        [this.clicked, this.way] = [[], []];
        this.options.view.besidePointer.value = null;
        this.show();
    }
}

function diagonalOf(dataset: DatasetDescription | null): number {
    const bounds = dataset?.bounds ?? [0, 0, 0, 0, 0, 0];
    return Math.hypot(...[0, 1, 2].map((k) => bounds[2 * k + 1]! - bounds[2 * k]!));
}

/** Its body is where a mask of the grid says, in the grid's boxes. */
function isStepped(dataset: DatasetDescription | null): boolean {
    return (dataset?.grid === 'uniform' || dataset?.grid === 'rectilinear') && (dataset.patches ?? []).length === 0;
}

function middleOf({ bounds }: DatasetDescription): Vec3 {
    return [0, 1, 2].map((k) => (bounds[2 * k]! + bounds[2 * k + 1]!) / 2) as unknown as Vec3;
}
