// Pointer and keyboard on the rake's handles.
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer, PointerTool } from '../pointerTools.ts';
import type { ScreenPoint, View } from '../view.ts';
import { difference, translate } from './rakeDrag.ts';
import type { Handle, RakeWidget } from './rakeWidget.ts';

/** `movedAt` is the time of the pointer or key event, on the clock of performance.now(). */
export interface RakeMove {
    points: Vec3[];
    dragging: boolean;
    movedAt: number;
}

interface Drag {
    handle: Handle;
    start: Vec3[];
    anchor: Vec3;
    grab: ScreenPoint;
}

export interface RakeInteractionOptions {
    widget: RakeWidget;
    view: () => View;
    requestFrame: () => void;
    onMove: (move: RakeMove) => void;
    /** A handle has been taken or let go. */
    onHold: (held: boolean) => void;
}

export class RakeInteraction implements PointerTool {
    private readonly options: RakeInteractionOptions;
    private drag: Drag | null = null;

    constructor(options: RakeInteractionOptions) {
        this.options = options;
    }

    get dragging(): boolean {
        return this.drag !== null;
    }

    /** Moves one handle by a step along one axis. */
    nudge(handle: Handle, by: Vec3): void {
        const { widget } = this.options;
        const points = widget.getPoints();
        this.apply(moved(points, handle, by), false, performance.now());
    }

    /** Puts the ring of attention round a handle, for example while its button has the focus. */
    highlight(handle: Handle | null): void {
        if (this.options.widget.setHighlighted(handle)) this.options.requestFrame();
    }

    press({ at }: Pointer): boolean {
        const { widget } = this.options;
        const view = this.options.view();
        const handle = widget.handleAt(at, view);
        if (handle === null) return false;
        const anchor = widget.positionOf(handle);
        const centre = view.project(anchor) ?? at;
        // A press off the handle's centre must not make it jump.
        const grab = { x: centre.x - at.x, y: centre.y - at.y };
        this.drag = { handle, start: widget.getPoints(), anchor, grab };
        this.options.onHold(true);
        this.highlight(handle);
        return true;
    }

    hover(pointer: Pointer | null): string | null {
        const handle = pointer === null ? null : this.options.widget.handleAt(pointer.at, this.options.view());
        this.highlight(handle);
        return handle === null ? null : 'grab';
    }

    move(pointer: Pointer): void {
        if (this.drag !== null) this.apply(this.dragged(pointer, this.drag), true, pointer.time);
    }

    release(pointer: Pointer, cancelled: boolean): void {
        const { drag } = this;
        if (drag === null) return;
        this.drag = null;
        this.options.onHold(false);
        const points = cancelled ? this.options.widget.getPoints() : this.dragged(pointer, drag);
        this.apply(points, false, pointer.time);
    }

    private dragged({ at }: Pointer, drag: Drag): Vec3[] {
        const target = { x: at.x + drag.grab.x, y: at.y + drag.grab.y };
        const to = this.options.view().pointAtDepth(target, drag.anchor);
        return moved(drag.start, drag.handle, difference(to, drag.anchor));
    }

    private apply(points: Vec3[], dragging: boolean, movedAt: number): void {
        this.options.widget.setPoints(points);
        this.options.requestFrame();
        this.options.onMove({ points, dragging, movedAt });
    }
}

function moved(points: readonly Vec3[], handle: Handle, by: Vec3): Vec3[] {
    if (handle === 'middle') return translate(points, by);
    return points.map((point, i) => (i === handle ? (translate([point], by)[0] ?? point) : point));
}
