// All rakes of the session in the scene; one of them is chosen and has handles.
import { Group } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Layer, ScreenPoint, View } from '../base/view.ts';
import type { DrawnRake, HeldHandle } from './drawnRake.ts';
import { RakeCurve } from './rakeCurve.ts';
import { axisLine, curveUnder, type Handle, handleUnder, labelPlace, positionOf } from './rakeHandles.ts';
import type { RakeShape } from './rakeShape.ts';
import { placeUnder } from './rakePlace.ts';
import { RakeWidget } from './rakeWidget.ts';
import type { Axis } from './snapping.ts';
import { distance } from './vec3.ts';
import { beside, Labels } from '../base/labels.ts';

/** Describes what is shown while a handle is moved. */
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
