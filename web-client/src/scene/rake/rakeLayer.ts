// All rakes of the session in the scene: the curve of each and, of the chosen one, its handles; and where on a rake a pointer is, on its
// curve or on the disc of a round one.
import { Group } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { beside, Labels } from '../base/labels.ts';
import type { Layer, ScreenPoint, View } from '../base/view.ts';
import { type HandleSprite, HandleSprites, markOf } from './handleSprites.ts';
import { RakeCurve } from './rakeCurve.ts';
import type { Axis } from './rakeDrag.ts';
import {
    axisLine,
    curveUnder,
    type Handle,
    handlesOf,
    handleUnder,
    hasPointHandles,
    labelPlace,
    positionOf,
} from './rakeHandles.ts';
import { circleOf, curveOf, distance, dot, middleOf, minus, normalOf, plus, type RakeShape, times, unit } from './rakeShape.ts';

/** What is shown while a handle is moved. */
export interface Guide {
    held: HeldHandle;
    axis: { axis: Axis; from: Vec3 } | null;
    words: string;
}

export const axisColours = ['#ff8a80', '#7ee2a8', '#8ab8ff'] as const;
const nothing: RakeShape = { kind: 'line', points: [] };

export class RakeLayer implements Layer {
    readonly object = new Group();
    private readonly widgets = new Map<string, RakeWidget>();
    private readonly axis = new RakeCurve();
    private readonly labels: RakeLabels;
    private chosen: RakeWidget | null = null;
    private bounds: readonly number[] = [-1, 1, -1, 1, -1, 1];
    private guide: Guide | null = null;
    private highlighted: Handle | null = null;

    constructor(labels: HTMLElement) {
        this.labels = new RakeLabels(labels);
        this.axis.setPoints([]);
        this.object.add(this.axis.object);
    }

    setBounds(bounds: readonly number[]): void {
        this.bounds = bounds;
    }

    setRakes(rakes: readonly DrawnRake[]): void {
        const ids = new Set(rakes.map(({ rake }) => rake));
        for (const [id, widget] of this.widgets) if (!ids.has(id)) this.remove(id, widget);
        this.chosen = null;
        for (const rake of rakes) {
            const widget = this.widgets.get(rake.rake) ?? this.create(rake.rake);
            widget.set(rake);
            if (rake.chosen) this.chosen = widget;
        }
    }

    get chosenId(): string | null {
        return this.chosen?.rake?.rake ?? null;
    }

    /** Returns the shape of the chosen rake. */
    get shape(): RakeShape {
        return this.chosen?.shape ?? nothing;
    }

    setShape(shape: RakeShape): void {
        this.chosen?.setShape(shape);
    }

    get drawn(): readonly DrawnRake[] {
        return [...this.widgets.values()].flatMap(({ rake }) => rake ?? []);
    }

    /** The chosen rake can be moved: it is not locked, and no other user moves it. */
    get movable(): boolean {
        const rake = this.chosen?.rake;
        return rake?.holder === null && !rake.locked;
    }

    /** Where a handle of the chosen rake is drawn. */
    positionOf(handle: Handle, view: View): Vec3 {
        if (this.guide?.held.handle === handle) return this.guide.held.at;
        return positionOf(handle, this.shape, view);
    }

    handleAt(pointer: ScreenPoint, view: View): Handle | null {
        return this.chosen?.rake?.holder != null ? null : handleUnder(pointer, this.shape, view);
    }

    /** The rake whose curve is nearest to a canvas position, unless that is the chosen one. */
    otherAt(pointer: ScreenPoint, view: View): string | null {
        let nearest: string | null = null;
        let nearestPx = Number.POSITIVE_INFINITY;
        for (const [id, widget] of this.widgets) {
            const px = curveUnder(pointer, widget.shape, view);
            if (px !== null && px < nearestPx) [nearest, nearestPx] = [id, px];
        }
        return nearest === this.chosen?.rake?.rake ? null : nearest;
    }

    /** The place of a rake, or of the disc of a round one, that is seen at a canvas position; null: none
     *  is. */
    pointUnder(pointer: ScreenPoint, view: View): Vec3 | null {
        let nearest: Vec3 | null = null;
        for (const { shape } of this.widgets.values()) {
            const point = placeUnder(pointer, shape, view);
            if (point === null || (nearest !== null && distance(view.eye, point) >= distance(view.eye, nearest))) continue;
            nearest = point;
        }
        return nearest;
    }

    /** Puts the ring of attention round a handle. */
    setHighlighted(handle: Handle | null): boolean {
        const changed = handle !== this.highlighted;
        this.highlighted = handle;
        return changed;
    }

    setGuide(guide: Guide | null): void {
        this.guide = guide;
        const axis = guide?.axis ?? null;
        this.axis.setPoints(axis === null ? [] : axisLine(axis.from, axis.axis, this.bounds));
        if (axis === null) return;
        this.axis.setStyle({ colour: axisColours[axis.axis], widthPx: 4, opacity: 0.9, dashPx: 12, haloPx: 0 });
    }

    /** Brings the drawn objects in line with rakes and camera; called before every frame. */
    update(view: View): void {
        const { guide, highlighted, chosen } = this;
        for (const widget of this.widgets.values()) {
            const own = widget === chosen;
            widget.update(view, own ? (guide?.held ?? null) : null, own ? highlighted : null);
        }
        if (guide !== null) this.axis.update(view, guide.held.at);
        this.labels.show([...this.holders(view), ...this.remarks(view), ...this.snapWords(view)]);
    }

    private holders(view: View): { at: ScreenPoint; words: string; colour: string }[] {
        return this.drawn.flatMap(({ holder, shape }) => {
            const points = holder?.points ?? shape.points;
            const at = labelPlace({ kind: shape.kind, points }, view);
            return holder === null || at === null ? [] : [{ at, words: `${holder.name} is moving this`, colour: holder.colour }];
        });
    }

    private remarks(view: View): { at: ScreenPoint; words: string; colour: string }[] {
        return this.drawn.flatMap(({ holder, shape, remark, colour }) => {
            const at = holder !== null || remark === '' ? null : labelPlace(shape, view);
            return at === null ? [] : [{ at, words: remark, colour }];
        });
    }

    private snapWords(view: View): { at: ScreenPoint; words: string; colour: string }[] {
        const { guide } = this;
        const at = guide === null || guide.words === '' ? null : view.project(guide.held.at);
        if (guide === null || at === null) return [];
        const colour = guide.axis === null ? '#ffffff' : axisColours[guide.axis.axis];
        return [{ at, words: guide.words, colour }];
    }

    private create(id: string): RakeWidget {
        const widget = new RakeWidget();
        this.widgets.set(id, widget);
        this.object.add(widget.object);
        return widget;
    }

    private remove(id: string, widget: RakeWidget): void {
        this.widgets.delete(id);
        this.object.remove(widget.object);
        widget.dispose();
    }
}

interface RakeLabel {
    at: ScreenPoint;
    words: string;
    colour: string;
}

/** Clear of the handle and of the finger on it. */
const clearancePx = { x: 18, y: 34 };

export class RakeLabels {
    private readonly labels: Labels;

    constructor(layer: HTMLElement) {
        this.labels = new Labels(layer);
    }

    show(labels: readonly RakeLabel[]): void {
        this.labels.begin();
        for (const { at, words, colour } of labels) {
            const place = { x: at.x + clearancePx.x, y: at.y - clearancePx.y };
            this.labels.place(place, words, 'rake-label', beside).style.borderLeftColor = colour;
        }
        this.labels.end();
    }
}

const handleRadiusPx = 11;
const smallRadiusPx = 9;
/** Small and without colour: nothing to take hold of. */
const lockedRadiusPx = 6;
const lockedColour = '#7d8896';
const dotRadiusPx = 4;
const smallDotRadiusPx = 2.5;
/** More would hide the rake behind its points. */
const maxDots = 64;

/** White on both sides, so that it stands out whatever its colour is. */
const chosenStyle = { widthPx: 8, opacity: 1, haloPx: 1.1 };
const otherStyle = { widthPx: 4.5, opacity: 0.9, haloPx: 0 };

/** One rake in the scene. */
export class RakeWidget {
    readonly object = new Group();
    private readonly curve = new RakeCurve();
    private readonly ghost = new RakeCurve();
    private readonly stem = new RakeCurve();
    private readonly dots = new HandleSprites(11);
    private readonly handles = new HandleSprites(20);
    private drawn: DrawnRake | null = null;
    private middle: Vec3 = [0, 0, 0];

    constructor() {
        const { curve, ghost, stem, dots, handles } = this;
        this.object.add(ghost.object, curve.object, stem.object, dots.object, handles.object);
    }

    get shape(): RakeShape {
        return this.drawn?.shape ?? { kind: 'line', points: [] };
    }

    get rake(): DrawnRake | null {
        return this.drawn;
    }

    set(rake: DrawnRake): void {
        const before = this.drawn;
        this.drawn = rake;
        if (before?.shape !== rake.shape) this.setCurve(rake);
        else if (before.chosen !== rake.chosen || before.colour !== rake.colour) this.setDots(rake);
        const { chosen, colour, holder } = rake;
        const dashPx = holder === null ? 0 : 10;
        this.curve.setStyle(chosen && holder === null ? { ...chosenStyle, colour, dashPx } : { ...otherStyle, colour, dashPx });
        this.ghost.setPoints(holder?.points === undefined ? [] : curveOf({ kind: rake.shape.kind, points: holder.points }));
        this.ghost.setStyle({ ...otherStyle, colour: holder?.colour ?? colour, dashPx: 10 });
        this.stem.setStyle({ ...otherStyle, colour: '#ffffff', widthPx: 3, opacity: 0.7, dashPx: 0 });
    }

    /** While one is moved: the same rake, elsewhere. */
    setShape(shape: RakeShape): void {
        if (this.drawn !== null) this.set({ ...this.drawn, shape });
    }

    update(view: View, held: HeldHandle | null, highlighted: Handle | null): void {
        for (const each of [this.curve, this.ghost, this.stem, this.dots, this.handles]) each.update(view, this.middle);
        const { drawn, shape } = this;
        const shown = drawn !== null && drawn.chosen && drawn.holder === null ? handlesOf(shape) : [];
        const at = (handle: Handle): Vec3 => (held?.handle === handle ? held.at : positionOf(handle, shape, view));
        const sprites = shown.map((handle): HandleSprite => ({
            at: at(handle),
            mark: markOf(handle, shape.kind === 'circle'),
            radiusPx: drawn?.locked === true ? lockedRadiusPx : handle === 'rotate' ? smallRadiusPx : handleRadiusPx,
            highlighted: handle === highlighted,
        }));
        this.handles.set(sprites, drawn?.locked === true ? lockedColour : (drawn?.colour ?? '#ffffff'));
        this.stem.setPoints(shown.includes('rotate') ? [this.middle, at('rotate')] : []);
    }

    dispose(): void {
        for (const each of [this.curve, this.ghost, this.stem, this.dots, this.handles]) each.dispose();
    }

    private setCurve(rake: DrawnRake): void {
        this.middle = middleOf(rake.shape);
        this.curve.setPoints(curveOf(rake.shape));
        this.setDots(rake);
    }

    /** At the ends of a rake that is not chosen, and at every point of a list, which has no handles for
     *  them. */
    private setDots({ shape, chosen, colour }: DrawnRake): void {
        const { points, kind } = shape;
        const every = Math.ceil(points.length / maxDots);
        const list = !hasPointHandles(shape);
        let dotted: readonly Vec3[] = [];
        if (list) dotted = points.filter((_, i) => i % every === 0);
        else if (!chosen && kind !== 'circle') dotted = points.filter((_, i) => i === 0 || i === points.length - 1);
        const radiusPx = list ? smallDotRadiusPx : dotRadiusPx;
        this.dots.set(
            dotted.map((at): HandleSprite => ({ at, mark: 'dot', radiusPx, highlighted: false })),
            colour,
        );
    }
}

/** Another user who moves a rake just now. */
export interface RakeHolder {
    name: string;
    colour: string;
    /** Where they have it, if they say so. */
    points?: readonly Vec3[];
}

export interface DrawnRake {
    rake: string;
    shape: RakeShape;
    colour: string;
    chosen: boolean;
    /** Cannot be moved, from here. */
    locked: boolean;
    holder: RakeHolder | null;
    /** Words beside it; empty: none. */
    remark: string;
}

/** A handle that is not where the shape has it, because it is held. */
export interface HeldHandle {
    handle: Handle;
    at: Vec3;
}

/** Seen more from the edge than this, a disc is a line. */
const flattest = 0.02;

/** Null where the pointer is not on it. */
export function placeUnder(pointer: ScreenPoint, shape: RakeShape, view: View): Vec3 | null {
    const [eye, further] = view.sightLine(pointer);
    const sight = unit(minus(further, eye));
    if (curveUnder(pointer, shape, view) !== null) return nearestOfCurve(curveOf(shape), eye, sight);
    return shape.kind === 'circle' ? placeOnDisc(shape, eye, sight) : null;
}

function placeOnDisc(shape: RakeShape, eye: Vec3, sight: Vec3): Vec3 | null {
    const circle = circleOf(shape);
    const normal = normalOf(circle);
    const slope = dot(normal, sight);
    if (Math.abs(slope) < flattest) return null;
    const point = plus(eye, times(sight, dot(normal, minus(circle.centre, eye)) / slope));
    return distance(point, circle.centre) <= circle.radius ? point : null;
}

/** The point of a curve that is nearest to a line of sight. */
function nearestOfCurve(curve: readonly Vec3[], eye: Vec3, sight: Vec3): Vec3 | null {
    let nearest: Vec3 | null = null;
    let least = Number.POSITIVE_INFINITY;
    for (let i = 1; i < curve.length; ++i) {
        const point = nearestOfPiece(curve[i - 1]!, curve[i]!, eye, sight);
        const away = minus(point, eye);
        const beside = distance(away, times(sight, dot(away, sight)));
        if (beside < least) [nearest, least] = [point, beside];
    }
    return nearest;
}

function nearestOfPiece(a: Vec3, b: Vec3, eye: Vec3, sight: Vec3): Vec3 {
    const along = minus(b, a);
    const from = minus(a, eye);
    // Of both, what is across the line of sight.
    const across = minus(along, times(sight, dot(along, sight)));
    const beside = minus(from, times(sight, dot(from, sight)));
    const squared = dot(across, across);
    const part = squared > 0 ? Math.min(1, Math.max(0, -dot(beside, across) / squared)) : 0;
    return plus(a, times(along, part));
}
