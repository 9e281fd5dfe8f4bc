// The handles of the chosen slice: one in its middle moves the plane along its normal, one on a stem turns it about its middle. The border of
// the plane is drawn with them, so that it is seen which slice they belong to.
import { Color, Group } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer, PointerTool } from '../base/pointerTools.ts';
import type { Layer, ScreenPoint, View } from '../base/view.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';
import { HandleSprites } from '../rake/handleSprites.ts';
import { alongLine, onBall, towardsViewer, unitAxis } from '../rake/rakeDrag.ts';
import { hitRadiusPx } from '../rake/rakeHandles.ts';
import { dot, minus, plus, times, unit } from '../rake/rakeShape.ts';
import { type Box, centroid, planeSection, spanAcross } from './planeSection.ts';

export interface SlicePlane {
    origin: Vec3;
    /** Of any length above 0. */
    normal: Vec3;
}

export interface SliceHandlesOptions {
    view: () => View;
    requestFrame: () => void;
    /** A handle has been taken or released. */
    onHold: (held: boolean) => void;
    /** Returns whether the chosen slice can be changed, and the pointer is for it. */
    mayMove: () => boolean;
    moved: (plane: SlicePlane, at: ScreenPoint) => void;
    released: () => void;
}

export type SliceHandle = 'move' | 'turn';

interface Drag {
    handle: SliceHandle;
    /** From the pointer to the handle's centre: a press off the centre must not make it jump. */
    grab: ScreenPoint;
    pressed: ScreenPoint;
    /** The middle of the plane when it was taken, which a turn goes about. */
    middle: Vec3;
    normal: Vec3;
    tip: Vec3;
    /** Of the plane that the stem is on: 1 where its normal points. */
    side: 1 | -1;
}

const colour = '#8fd3ff';
const stemPx = 64;
const [moveRadiusPx, turnRadiusPx] = [11, 10];
const widthPx = 1.5;
/** A plane that only grazes a corner of the domain shows nothing. */
const inset = 5e-4;

export class SliceHandles implements Layer, PointerTool {
    readonly object = new Group();
    readonly notForFigures = true;
    private readonly options: SliceHandlesOptions;
    private readonly sprites = new HandleSprites(33);
    private readonly lines = new WideLines({ width: widthPx, hidden: false });
    private box: Box = [];
    private plane: SlicePlane | null = null;
    private section: Vec3[] = [];
    private drag: Drag | null = null;
    private highlighted: SliceHandle | null = null;

    constructor(options: SliceHandlesOptions) {
        this.options = options;
        this.lines.object.renderOrder = 31;
        this.object.add(this.lines.object, this.sprites.object);
    }

    /** @param plane null: no slice is chosen */
    set(plane: SlicePlane | null, box: Box): void {
        [this.plane, this.box] = [plane, box];
        this.section = plane === null ? [] : planeSection(box, plane.origin, plane.normal);
        if (plane === null) this.drag = null;
        this.options.requestFrame();
    }

    update(view: View): void {
        const at = this.placed(view);
        this.object.visible = at !== null && this.options.mayMove();
        if (at === null) return;
        const sprite = (handle: SliceHandle) => ({ at: at[handle], highlighted: this.highlighted === handle });
        this.sprites.set(
            [
                { ...sprite('move'), mark: 'middle', radiusPx: moveRadiusPx },
                { ...sprite('turn'), mark: 'tilt', radiusPx: turnRadiusPx },
            ],
            colour,
        );
        this.sprites.update(view, at.move);
        const border = this.section.flatMap((corner, i) => [...corner, ...this.section[(i + 1) % this.section.length]!]);
        const tint = tintOf(new Color(colour));
        this.lines.set(
            [...border, ...at.move, ...at.turn],
            [...this.section, 0].flatMap(() => tint),
        );
        this.lines.update(view);
    }

    /** Where a handle is on the canvas; null where it is not seen. */
    handleOnScreen(handle: SliceHandle): ScreenPoint | null {
        const view = this.options.view();
        const at = this.placed(view);
        return at === null ? null : view.project(at[handle]);
    }

    press({ at }: Pointer): boolean {
        const view = this.options.view();
        const handle = this.under(at, view);
        const placed = this.placed(view);
        if (handle === null || placed === null || this.plane === null) return false;
        const centre = view.project(placed[handle]) ?? at;
        this.drag = {
            ...{ handle, pressed: at, grab: { x: centre.x - at.x, y: centre.y - at.y } },
            ...{ middle: placed.move, normal: unit(this.plane.normal), tip: placed.turn, side: placed.side },
        };
        this.options.onHold(true);
        return true;
    }

    move(pointer: Pointer): void {
        if (this.drag === null) return;
        const view = this.options.view();
        const plane = this.drag.handle === 'move' ? this.shifted(this.drag, pointer, view) : turned(this.drag, pointer, view);
        if (plane !== null) this.options.moved(plane, pointer.at);
    }

    release(): void {
        this.drag = null;
        this.options.onHold(false);
        this.options.released();
    }

    hover(pointer: Pointer | null): string | null {
        const handle = pointer === null ? null : this.under(pointer.at, this.options.view());
        if (handle !== this.highlighted) this.options.requestFrame();
        this.highlighted = handle;
        return handle === null ? null : 'grab';
    }

    /** Along the normal; the domain's ends stop it. */
    private shifted({ middle, normal, grab, pressed }: Drag, { at }: Pointer, view: View): SlicePlane | null {
        const target = { x: at.x + grab.x, y: at.y + grab.y };
        // Seen along its normal, up and down are nearer and further.
        const upwards = (pressed.y - at.y) * view.worldPerPx(middle) * (dot(normal, towardsViewer(view)) < 0 ? 1 : -1);
        const to = alongLine(middle, normal, target, view) ?? plus(middle, times(normal, upwards));
        // Past the point where the normal vanishes in the distance there is no such place.
        if (view.project(to) === null) return null;
        const [low, high] = spanWithin(this.box, normal);
        const height = Math.min(high, Math.max(low, dot(to, normal)));
        return { origin: plus(middle, times(normal, height - dot(middle, normal))), normal: this.plane!.normal };
    }

    private placed(view: View): (Record<SliceHandle, Vec3> & Pick<Drag, 'side'>) | null {
        if (this.plane === null || this.section.length === 0) return null;
        const middle = this.drag?.handle === 'turn' ? this.drag.middle : centroid(this.section);
        const normal = unit(this.plane.normal);
        // On the side that is seen.
        const side = this.drag?.side ?? (dot(normal, towardsViewer(view)) < 0 ? -1 : 1);
        return { move: middle, turn: plus(middle, times(normal, side * stemPx * view.worldPerPx(middle))), side };
    }

    private under(at: ScreenPoint, view: View): SliceHandle | null {
        const placed = this.options.mayMove() ? this.placed(view) : null;
        if (placed === null) return null;
        const px = (handle: SliceHandle): number => {
            const seen = view.project(placed[handle]);
            return seen === null ? Infinity : Math.hypot(seen.x - at.x, seen.y - at.y);
        };
        const nearer = px('move') <= px('turn') ? 'move' : 'turn';
        return px(nearer) <= hitRadiusPx ? nearer : null;
    }
}

/** About the middle, like a ball; with Shift to the nearest axis. */
function turned({ middle, tip, side, grab }: Drag, { at, shift }: Pointer, view: View): SlicePlane | null {
    const target = { x: at.x + grab.x, y: at.y + grab.y };
    const radius = Math.hypot(...minus(tip, middle));
    const direction = unit(minus(onBall({ centre: middle, radius, anchor: tip }, target, view), middle));
    if (direction.every((each) => each === 0)) return null;
    const axis = ([0, 1, 2] as const).reduce((best, k) => (Math.abs(direction[k]) > Math.abs(direction[best]) ? k : best));
    return { origin: middle, normal: shift ? unitAxis(axis) : times(direction, side) };
}

/** The heights along a normal of length one at which a plane shows something of the box. */
export function spanWithin(box: Box, normal: Vec3): [number, number] {
    const [low, high] = spanAcross(box, normal);
    return [low + inset * (high - low), high - inset * (high - low)];
}
