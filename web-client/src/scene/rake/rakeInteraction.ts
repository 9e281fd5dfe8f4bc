// Pointer and keyboard on the rakes: handles of the chosen one are dragged, others are chosen by a click, and a point can be put where the
// next click is or where typed numbers say, for those who cannot drag.
import type { Vec3 } from '../../protocol/messages.ts';
import { rounding } from '../base/numbers.ts';
import type { Pointer, PointerTool } from '../base/pointerTools.ts';
import type { ScreenPoint, View } from '../base/view.ts';
import type { Bounds } from '../domain/domainAxes.ts';
import type { RakeAim } from './rakeAim.ts';
import { type Axis, beginDrag, type Drag, type Dragged, dragged, onGrid, type Snap, towardsViewer } from './rakeDrag.ts';
import { gripOf, type Handle } from './rakeHandles.ts';
import type { RakeLayer } from './rakeLayer.ts';
import { fitted, minus, plus, type RakeShape, resized, tilted, translated, turnedBy, withPoint } from './rakeShape.ts';

/** `movedAt` is the time of the pointer or key event, on the clock of performance.now(). */
export interface RakeMove {
    shape: RakeShape;
    dragging: boolean;
    movedAt: number;
}

export interface RakeInteractionOptions {
    layer: RakeLayer;
    aim: Pick<RakeAim, 'arm' | 'arrowUnder' | 'handle' | 'setHighlighted'>;
    view: () => View;
    /** Returns what is under a canvas position: a place on a surface or a body. */
    pick: (at: ScreenPoint) => Vec3 | null;
    requestFrame: () => void;
    /** A handle has been taken or released. */
    onHold: (held: boolean) => void;
}

/** What the user may do with rakes, and what becomes of it. */
export interface RakeUser {
    /** Returns whether rakes can be changed, now. */
    mayMove: () => boolean;
    /** A user has pulled at a handle that is locked. */
    refused: () => void;
    /** Returns whether the pointer is for rakes: no other tool is chosen. */
    hasPointer: () => boolean;
    moved: (move: RakeMove) => void;
    chose: (rake: string) => void;
    /** The point has been put, or will not be. */
    placed: () => void;
}

const nothingTaken = { handle: null, axis: null };

const noOne: RakeUser = {
    mayMove: () => false,
    refused: () => undefined,
    hasPointer: () => false,
    moved: () => undefined,
    chose: () => undefined,
    placed: () => undefined,
};

export class RakeInteraction implements PointerTool {
    /** The spacing of the grid that dragged points are held to; null: none. */
    step: number | null = null;
    private readonly options: RakeInteractionOptions;
    private user = noOne;
    private drag: Drag | null = null;
    /** The axis of the arrow that is dragged. */
    private axis: Axis | null = null;
    private moved = false;
    private nudged = false;
    private placing: Handle | null = null;

    constructor(options: RakeInteractionOptions) {
        this.options = options;
    }

    /** From now on; before that, no rake can be touched. */
    connect(user: RakeUser): void {
        this.user = user;
    }

    get dragging(): boolean {
        return this.drag !== null || this.nudged;
    }

    /** Moves one handle by a step along one axis. `more`: others follow, all of them one edit, until
     *  `endNudge`. */
    nudge(handle: Handle, by: Vec3, more = false): void {
        const shape = movedHandle(this.options.layer.shape, handle, by);
        this.nudged = more;
        this.apply(shape, more, performance.now());
    }

    /** Turns the rake in the plane that faces the camera. */
    turn(angle: number, more = false): void {
        const { layer, view } = this.options;
        this.nudged = more;
        this.apply(turnedBy(layer.shape, towardsViewer(view()), angle), more, performance.now());
    }

    endNudge(): void {
        if (!this.nudged) return;
        this.nudged = false;
        this.apply(this.options.layer.shape, false, performance.now());
    }

    /** Puts the ring of attention round a handle, for example while its button has the focus. */
    highlight(handle: Handle | null): void {
        if (this.options.layer.setHighlighted(handle)) this.options.requestFrame();
    }

    /** The next click on the picture says where this handle goes; null: no longer. */
    place(handle: Handle | null): void {
        const before = this.placing;
        this.placing = handle;
        if (before !== null && handle === null) this.user.placed();
    }

    press({ at }: Pointer): boolean {
        const { layer, aim } = this.options;
        const view = this.options.view();
        const { handle, axis } = this.placing === null ? this.takenAt(at, view) : nothingTaken;
        if (handle === null) return false;
        if (!this.movable) {
            // Whoever takes hold of a handle does not mean the camera.
            this.user.refused();
            return true;
        }
        this.endNudge();
        this.axis = axis;
        if (axis === null) aim.arm(handle);
        this.drag = beginDrag(handle, layer.shape, at, view);
        this.moved = false;
        this.options.onHold(true);
        this.highlight(handle);
        return true;
    }

    hover(pointer: Pointer | null): string | null {
        if (this.placing !== null) return 'crosshair';
        const { layer } = this.options;
        const view = this.options.view();
        const { handle, axis } = pointer === null ? nothingTaken : this.takenAt(pointer.at, view);
        this.highlight(this.movable && axis === null ? handle : null);
        if (this.options.aim.setHighlighted(axis)) this.options.requestFrame();
        if (handle !== null) return this.movable ? 'grab' : 'not-allowed';
        if (pointer === null || !this.user.hasPointer()) return null;
        return layer.otherAt(pointer.at, view) === null ? null : 'pointer';
    }

    move(pointer: Pointer): void {
        if (this.drag === null) return;
        this.moved = true;
        const { shape, at, axis, words } = this.dragged(pointer, this.drag);
        this.options.layer.setGuide({ held: { handle: this.drag.handle, at }, axis, words });
        this.apply(shape, true, pointer.time);
    }

    release(pointer: Pointer, cancelled: boolean): void {
        const { drag } = this;
        if (drag === null) return;
        this.drag = null;
        const { layer } = this.options;
        this.options.onHold(false);
        layer.setGuide(null);
        // A press alone moves nothing, not even to the next point of the grid; it may mean the rake under the
        // handle.
        if (!this.moved) this.chooseAt(pointer.at);
        else this.apply(cancelled ? layer.shape : this.dragged(pointer, drag).shape, false, pointer.time);
    }

    /** The rake that was being moved is there no more. */
    abandon(): void {
        if (this.drag !== null) this.options.onHold(false);
        this.drag = null;
        this.nudged = false;
        this.options.layer.setGuide(null);
    }

    click({ at, time }: Pointer): boolean {
        if (this.placing !== null && this.movable) {
            this.put(this.placing, at, this.options.view(), time);
            return true;
        }
        return this.user.hasPointer() && this.chooseAt(at);
    }

    /** Returns whether this rake can be changed, and the pointer is for it. */
    get movable(): boolean {
        return this.user.mayMove() && this.user.hasPointer() && this.options.layer.movable;
    }

    /** The handle under a canvas position; with an axis, by the arrow there. The nearest counts. */
    private takenAt(at: ScreenPoint, view: View): { handle: Handle | null; axis: Axis | null } {
        if (!this.user.hasPointer()) return nothingTaken;
        const { layer, aim } = this.options;
        const handle = layer.handleAt(at, view);
        const arrow = this.movable ? aim.arrowUnder(at, view) : null;
        if (arrow === null) return { handle, axis: null };
        const seen = handle === null ? null : view.project(layer.positionOf(handle, view));
        const nearer = seen !== null && Math.hypot(seen.x - at.x, seen.y - at.y) < arrow.px;
        return nearer ? { handle, axis: null } : { handle: aim.handle, axis: arrow.axis };
    }

    private chooseAt(at: ScreenPoint): boolean {
        const { layer, view } = this.options;
        const other = layer.otherAt(at, view());
        if (other !== null) this.user.chose(other);
        return other !== null;
    }

    private put(handle: Handle, at: ScreenPoint, view: View, time: number): void {
        const { layer, pick } = this.options;
        const before = handle === 'middle' ? gripOf(layer.shape) : layer.positionOf(handle, view);
        let to = pick(at) ?? view.pointAtDepth(at, before);
        if (this.step !== null) to = onGrid(to, this.step);
        this.place(null);
        this.apply(movedHandle(layer.shape, handle, minus(to, before)), false, time);
    }

    private dragged(pointer: Pointer, drag: Drag): Dragged {
        const snap: Snap = { axis: this.axis ?? (pointer.shift ? 'nearest' : null), step: this.step };
        return dragged(drag, pointer.at, this.options.view(), snap);
    }

    private apply(shape: RakeShape, dragging: boolean, movedAt: number): void {
        if (shape.points.length === 0) return;
        this.options.layer.setShape(shape);
        this.options.requestFrame();
        this.user.moved({ shape, dragging, movedAt });
    }
}

/** One handle elsewhere, and with it what hangs on it. */
function movedHandle(shape: RakeShape, handle: Handle, by: Vec3): RakeShape {
    if (handle === 'middle' || (shape.kind === 'circle' && handle === 0)) return translated(shape, by);
    if (handle === 'rotate') return shape;
    const to = plus(shape.points[handle] ?? [0, 0, 0], by);
    if (shape.kind !== 'circle') return withPoint(shape, handle, to);
    return handle === 1 ? resized(shape, to) : tilted(shape, to);
}

export interface TypedPoint {
    shape: RakeShape;
    /** Where the coordinate is now, if that is not what was typed. */
    stoppedAt: number | null;
}

/** A coordinate outside the domain stops at its edge alone: the others stay, where a rake that is clipped would move along itself. */
export function withCoordinate(shape: RakeShape, handle: Handle, axis: Axis, typed: number, bounds: Bounds): TypedPoint {
    const moved = movedTo(shape, handle, axis, typed, bounds);
    const at = coordinateOf(moved, handle, axis);
    const slack = rounding(bounds[2 * axis]!, bounds[2 * axis + 1]!);
    return { shape: moved, stoppedAt: Math.abs(at - typed) > slack ? at : null };
}

function movedTo(shape: RakeShape, handle: Handle, axis: Axis, typed: number, bounds: Bounds): RakeShape {
    const [low, high] = [bounds[2 * axis]!, bounds[2 * axis + 1]!];
    const clamped = Math.min(high, Math.max(low, typed));
    if (shape.kind !== 'circle' && typeof handle === 'number') {
        // As typed, not as before plus the difference.
        const points = shape.points.map((point, i) => (i === handle ? (point.with(axis, clamped) as typeof point) : point));
        return { kind: shape.kind, points };
    }
    const before = coordinateOf(shape, handle, axis);
    let by = clamped - before;
    if (shape.kind !== 'circle') {
        // The whole rake moves, as far as all of it stays inside.
        const along = shape.points.map((point) => point[axis]);
        by = Math.max(Math.min(0, low - Math.min(...along)), Math.min(Math.max(0, high - Math.max(...along)), by));
    }
    const shift: [number, number, number] = [0, 0, 0];
    shift[axis] = by;
    return fitted(movedHandle(shape, handle, shift), bounds);
}

function coordinateOf(shape: RakeShape, handle: Handle, axis: Axis): number {
    return (typeof handle === 'number' ? shape.points[handle] : gripOf(shape))?.[axis] ?? 0;
}
