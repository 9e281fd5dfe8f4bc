// Shows where the chosen rake is in depth, and what aims it: a line from the rake down to the floor of the
// domain with its print there, and at the handle that was used last an arrow along each axis, which moves it
// along that axis alone.
import { Group } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Layer, ScreenPoint, View } from '../base/view.ts';
import { type HandleSprite, HandleSprites } from './handleSprites.ts';
import { RakeCurve } from './rakeCurve.ts';
import { type Handle, handlesOf } from './rakeHandles.ts';
import { axisColours, type RakeLayer } from './rakeLayer.ts';
import { distance, middleOf, plus, type RakeShape, times } from './rakeShape.ts';
import { type Axis, unitAxis } from './rakeDrag.ts';

const arrowPx = 78;
/** Clear of the handle it starts at. */
const startPx = 16;
const longerPx = [1, 1.35, 1.7, 2.05].map((times) => times * arrowPx);
/** Between the middles of a tip and a handle, whose areas are so large together. */
const clearPx = 35;
const tipRadiusPx = 8;
const tipHitPx = 13;
/** An arrow that points at the eye cannot be followed. */
const leastPx = 26;

const shaftStyle = { widthPx: 4, opacity: 0.95, dashPx: 0, haloPx: 0 };
const dropStyle = { colour: '#ffffff', widthPx: 3, opacity: 0.55, dashPx: 9, haloPx: 0 };

export interface Arrow {
    axis: Axis;
    from: Vec3;
    tip: Vec3;
}

export class RakeAim implements Layer {
    readonly object = new Group();
    readonly notForFigures = true;
    private readonly layer: RakeLayer;
    private readonly mayMove: () => boolean;
    private readonly shafts = axisColours.map(() => new RakeCurve());
    private readonly drop = new RakeCurve();
    private readonly tips = new HandleSprites(21);
    private armed: { rake: string | null; handle: Handle } = { rake: null, handle: 'middle' };
    private highlighted: Axis | null = null;
    private floor = 0;

    /** @param mayMove  whether there is anything to aim: without it, only the line to the floor is shown */
    constructor(layer: RakeLayer, mayMove: () => boolean) {
        this.layer = layer;
        this.mayMove = mayMove;
        this.shafts.forEach((shaft, axis) => shaft.setStyle({ ...shaftStyle, colour: axisColours[axis]! }));
        this.drop.setStyle(dropStyle);
        this.object.add(...this.shafts.map((shaft) => shaft.object), this.drop.object, this.tips.object);
    }

    /** @param floor  lowest z of the domain */
    setFloor(floor: number): void {
        this.floor = floor;
    }

    /** The arrows stand at this handle from now on, until another rake is chosen. */
    arm(handle: Handle): void {
        this.armed = { rake: this.layer.chosenId, handle };
    }

    /** Returns what the arrows move. */
    get handle(): Handle {
        const { kind, points } = this.layer.shape;
        const { rake, handle } = this.armed;
        const isPoint = typeof handle === 'number' && handle < points.length && (kind === 'line' || kind === 'polyline');
        return rake === this.layer.chosenId && isPoint ? handle : 'middle';
    }

    arrows(view: View): Arrow[] {
        if (!this.layer.movable || this.layer.shape.points.length < 2 || !this.mayMove()) return [];
        const handles = handlesOf(this.layer.shape).map((handle) => view.project(this.layer.positionOf(handle, view)));
        return arrowsAt(this.layer.positionOf(this.handle, view), view, handles);
    }

    /** The arrow whose tip is under a canvas position, and how far from its middle that is. */
    arrowUnder(pointer: ScreenPoint, view: View): { axis: Axis; px: number } | null {
        let nearest: { axis: Axis; px: number } | null = null;
        for (const { axis, tip } of this.arrows(view)) {
            const at = view.project(tip);
            const px = at === null ? Infinity : Math.hypot(at.x - pointer.x, at.y - pointer.y);
            if (px <= (nearest?.px ?? tipHitPx)) nearest = { axis, px };
        }
        return nearest;
    }

    setHighlighted(axis: Axis | null): boolean {
        const changed = axis !== this.highlighted;
        this.highlighted = axis;
        return changed;
    }

    update(view: View): void {
        const arrows = this.arrows(view);
        const { shape } = this.layer;
        this.shafts.forEach((shaft, axis) => {
            const arrow = arrows.find((each) => each.axis === axis);
            shaft.setPoints(arrow === undefined ? [] : [arrow.from, arrow.tip]);
            if (arrow !== undefined) shaft.update(view, arrow.from);
        });
        const tips = arrows.map(({ axis, tip }): HandleSprite => ({
            ...{ at: tip, mark: 'point', radiusPx: tipRadiusPx, highlighted: axis === this.highlighted },
            colour: axisColours[axis],
        }));
        this.tips.set(tips, '#ffffff');
        this.tips.update(view, middleOf(shape));
        this.drop.setPoints(dropLine(shape, this.floor));
        this.drop.update(view, middleOf(shape));
    }
}

/** @param handles where others are: a finger must be able to take the tip alone */
function arrowsAt(from: Vec3, view: View, handles: readonly (ScreenPoint | null)[] = []): Arrow[] {
    const start = view.project(from);
    if (start === null) return [];
    const px = view.worldPerPx(from);
    return ([0, 1, 2] as const).flatMap((axis) => {
        const tipAt = (length: number): Vec3 => plus(from, times(unitAxis(axis), length * px));
        const isClear = (length: number): boolean => {
            const at = view.project(tipAt(length));
            return handles.every((each) => each === null || at === null || Math.hypot(each.x - at.x, each.y - at.y) > clearPx);
        };
        // Of a rake that is short on the screen, beyond it.
        const tip = tipAt(longerPx.find(isClear) ?? arrowPx);
        const end = view.project(tip);
        if (end === null || Math.hypot(end.x - start.x, end.y - start.y) < leastPx) return [];
        return [{ axis, from: plus(from, times(unitAxis(axis), startPx * px)), tip }];
    });
}

/** From the first point down, along the print of the rake on the floor, and up to the last; of others, from
 *  the middle down. */
export function dropLine(shape: RakeShape, floor: number): Vec3[] {
    const { kind, points } = shape;
    const [first, last] = [points[0], points.at(-1)];
    if (first === undefined || last === undefined) return [];
    const below = (point: Vec3): Vec3 => [point[0], point[1], floor];
    if (kind !== 'line' && kind !== 'polyline') return [middleOf(shape), below(middleOf(shape))];
    // Of an upright rake only what is below it.
    if (distance(below(first), below(last)) <= 1e-6 * distance(first, last)) {
        const lowest = points.reduce((low, point) => (point[2] < low[2] ? point : low), first);
        return [lowest, below(lowest)];
    }
    return [first, ...points.map(below), last];
}
