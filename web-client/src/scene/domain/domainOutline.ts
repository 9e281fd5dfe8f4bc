// The box of the domain with numbers and names along three of its edges. The numbers are DOM text
// over the canvas: sharp at any size and readable by assistive tools.
import type { Color, Object3D } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import { type AxisEdge, type Bounds, boxEdges, centreOf, clampedToPicture, edgesBeforeBox, labelledEdges } from './domainAxes.ts';
import { type Cover, isCovered, Labels } from '../base/labels.ts';
import type { Layer, ScreenPoint, ScreenSize, View } from '../base/view.ts';
import { niceTicks, type Ticks } from '../base/numbers.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';

const axisNames = ['x', 'y', 'z'];
const pxPerTick = 52;
const tickGapPx = 14;
const nameGapPx = 40;
/** Numbers with less room between them would run into each other, as where two axes meet. */
const clearancePx = { x: 8, y: 13 };
/** About half of what a sign of a number and of a name takes. */
const halfSignPx = 3.5;
const halfNameSignPx = 4.6;
const halfHeightPx = 8;
/** At the right are buttons, and at the lower left the scale of lengths. */
const buttonsPx = 96;
const scaleCover = { width: 150, height: 42 };
/** Where along an axis its name is looked for a place. */
const nameParts = [0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8];

interface PlacedWords extends ScreenPoint {
    halfWidth: number;
}

export class DomainOutline implements Layer {
    private readonly lines: BoxLines;
    private readonly bounds: Bounds;
    private readonly labels: Labels | null;
    private unit = '';
    private placed: PlacedWords[] = [];
    private size: ScreenSize = { width: 0, height: 0 };
    private placedFor = '';
    private cover: Cover | null = null;

    /** @param layer of the numbers and names; null: it has none */
    constructor(bounds: Bounds, layer: HTMLElement | null, colour: Color) {
        this.bounds = bounds;
        this.labels = layer === null ? null : new Labels(layer);
        this.lines = new BoxLines(bounds, colour);
    }

    get object(): Object3D {
        return this.lines.object;
    }

    /** Places the labels for the present camera, unless they are there already: text is costly to lay out. */
    update(view: View): void {
        this.lines.update(view);
        if (this.labels === null) return;
        const eye = view.outside;
        const project = (point: Vec3): ScreenPoint | null => view.project(point);
        const drawn = JSON.stringify([eye, view.size, project(this.corner(0)), project(this.corner(1))]);
        if (drawn === this.placedFor) return;
        this.placedFor = drawn;
        this.labels.begin();
        this.placed = [];
        this.size = view.size;
        const { width, height } = view.size;
        const edges = labelledEdges(this.bounds, eye, project, { width: width - buttonsPx, height });
        for (const axis of edges) {
            // Where the bar of colours or other numbers lie over the best, another.
            const edge = axis.find((each) => this.numbersOf(each, project).length >= 2) ?? axis[0];
            if (edge !== undefined) this.labelEdge(edge, project);
        }
        this.labels.end();
    }

    setColour(colour: Color): void {
        this.lines.setColour(colour);
    }

    /** Sets the unit of lengths, behind the names of the axes; empty: unknown. */
    setUnit(unit: string): void {
        this.unit = unit;
        this.placedFor = '';
    }

    /** Where no words are to be. */
    setCover(cover: Cover | null): void {
        if (cover === this.cover) return;
        this.cover = cover;
        this.placedFor = '';
    }

    private corner(end: 0 | 1): Vec3 {
        const [x, y, z] = [this.bounds[end], this.bounds[2 + end], this.bounds[4 + end]];
        return [x ?? 0, y ?? 0, z ?? 0];
    }

    dispose(): void {
        this.lines.dispose();
        this.labels?.dispose();
    }

    private labelEdge(edge: AxisEdge, project: (point: Vec3) => ScreenPoint | null): void {
        const [a, b] = [project(edge.from), project(edge.to)];
        if (a === null || b === null) return;
        // First, because a number less is no loss.
        const name = axisNames[edge.axis] ?? '';
        const { shared } = this.ticksOf(edge, a, b);
        const words = [name, this.unit === '' ? '' : `(${this.unit})`, shared].filter((each) => each !== '').join(' ');
        for (const part of nameParts) {
            const at = { x: a.x + part * (b.x - a.x), y: a.y + part * (b.y - a.y) };
            const place = this.roomFor(at, edge.outward, nameGapPx, words.length * halfNameSignPx);
            if (place === null) continue;
            this.place(place, words, `axis-name axis-${name}`);
            break;
        }
        for (const { label, at } of this.numbersOf(edge, project)) {
            const place = this.roomFor(at, edge.outward, tickGapPx, label.length * halfSignPx);
            if (place !== null) this.place(place, label, 'tick');
        }
    }

    private ticksOf({ axis, from, to }: AxisEdge, a: ScreenPoint, b: ScreenPoint): Ticks {
        const lengthPx = Math.hypot(b.x - a.x, b.y - a.y);
        // An axis seen end-on has no room for numbers.
        return lengthPx < 30 ? { ticks: [], shared: '' } : niceTicks(from[axis], to[axis], Math.min(8, lengthPx / pxPerTick));
    }

    /** Returns the numbers for which there is room. */
    private numbersOf(edge: AxisEdge, project: (point: Vec3) => ScreenPoint | null): { label: string; at: ScreenPoint }[] {
        const [a, b] = [project(edge.from), project(edge.to)];
        if (a === null || b === null) return [];
        return this.ticksOf(edge, a, b).ticks.flatMap(({ value, label }) => {
            const point: Vec3 = [...edge.from];
            point[edge.axis] = value;
            const at = project(point);
            return at === null || this.roomFor(at, edge.outward, tickGapPx, label.length * halfSignPx) === null
                ? []
                : [{ label, at }];
        });
    }

    /** Returns where words beside a place have room; null: something else is there. */
    private roomFor(at: ScreenPoint, outward: ScreenPoint, gapPx: number, halfWidth: number): PlacedWords | null {
        const place = clampedToPicture({ x: at.x + outward.x * gapPx, y: at.y + outward.y * gapPx }, at, this.size, halfWidth);
        const words = { ...place, halfWidth };
        const half = { width: halfWidth, height: halfHeightPx };
        const scale = { ...scaleCover, right: this.size.width - scaleCover.width, bottom: 0 };
        if ([this.cover, scale].some((cover) => cover !== null && isCovered(place, half, cover, this.size))) return null;
        return this.placed.some((other) => collide(other, words)) ? null : words;
    }

    private place(words: PlacedWords, text: string, className: string): void {
        this.placed.push(words);
        this.labels?.place(words, text, className);
    }
}

function collide(a: PlacedWords, b: PlacedWords): boolean {
    const across = clearancePx.x + a.halfWidth + b.halfWidth;
    return Math.abs(a.x - b.x) < across && Math.abs(a.y - b.y) < clearancePx.y;
}

const width = 1.1;
const paleOpacity = 0.3;

export class BoxLines {
    private readonly lines = new WideLines({ width, hidden: false, early: true });
    private readonly bounds: Bounds;
    private colour: Color;

    constructor(bounds: Bounds, colour: Color) {
        this.bounds = bounds;
        this.colour = colour;
        this.lines.set(boxEdges(bounds), new Array<number>(48).fill(1));
        this.object.position.set(...centreOf(bounds));
        // Before everything else, which then covers it.
        this.object.renderOrder = -2000;
    }

    get object(): WideLines['object'] {
        return this.lines.object;
    }

    setColour(colour: Color): void {
        this.colour = colour;
    }

    update(view: View): void {
        this.lines.update(view);
        const before = edgesBeforeBox(this.bounds, view.outside);
        this.lines.tint(before.flatMap((pale) => tintOf(this.colour, pale ? paleOpacity : 1)));
    }

    dispose(): void {
        this.lines.dispose();
    }
}
