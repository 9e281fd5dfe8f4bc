// Pointer and keyboard on the rake's handles. Listens on the canvas before the camera controls do:
// a press on a handle never reaches them, so the camera stays still while a handle is dragged.
import type { PerspectiveCamera } from 'three';
import type { Vec3 } from '../protocol/messages.ts';
import {
    difference,
    dragInViewPlane,
    projectToScreen,
    type ScreenPoint,
    type ScreenSize,
    translate,
} from './rakeDrag.ts';
import type { Handle, RakeWidget } from './rakeWidget.ts';

/** `movedAt` is the time of the pointer or key event, on the clock of performance.now(). */
export interface RakeMove {
    points: Vec3[];
    dragging: boolean;
    movedAt: number;
}

interface Drag {
    pointerId: number;
    handle: Handle;
    start: Vec3[];
    anchor: Vec3;
    grab: ScreenPoint;
}

export interface RakeInteractionOptions {
    canvas: HTMLCanvasElement;
    widget: RakeWidget;
    camera: PerspectiveCamera;
    requestFrame: () => void;
    onMove: (move: RakeMove) => void;
    /** A handle has been taken or let go. */
    onHold: (held: boolean) => void;
}

export class RakeInteraction {
    private readonly options: RakeInteractionOptions;
    private drag: Drag | null = null;

    constructor(options: RakeInteractionOptions) {
        this.options = options;
        const { canvas } = options;
        canvas.addEventListener('pointerdown', (event) => this.press(event));
        canvas.addEventListener('pointermove', (event) => this.move(event));
        canvas.addEventListener('pointerup', (event) => this.release(event));
        canvas.addEventListener('pointercancel', (event) => this.release(event));
        canvas.addEventListener('pointerleave', () => this.highlight(null));
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

    private press(event: PointerEvent): void {
        const { canvas, widget, camera } = this.options;
        if (!event.isPrimary || event.button !== 0) return;
        const pointer = place(event, canvas);
        const handle = widget.handleAt(pointer, camera, sizeOf(canvas));
        if (handle === null) return;
        event.stopImmediatePropagation();
        canvas.setPointerCapture(event.pointerId);
        const anchor = widget.positionOf(handle);
        const centre = projectToScreen(anchor, camera, sizeOf(canvas)) ?? pointer;
        this.drag = {
            pointerId: event.pointerId,
            handle,
            start: widget.getPoints(),
            anchor,
            // A press off the handle's centre must not make it jump.
            grab: { x: centre.x - pointer.x, y: centre.y - pointer.y },
        };
        canvas.classList.add('dragging');
        this.options.onHold(true);
        this.highlight(handle);
    }

    private move(event: PointerEvent): void {
        const { canvas, widget, camera } = this.options;
        if (this.drag === null) {
            if (event.buttons !== 0) return;
            const handle = widget.handleAt(place(event, canvas), camera, sizeOf(canvas));
            canvas.classList.toggle('over-handle', handle !== null);
            this.highlight(handle);
            return;
        }
        if (event.pointerId !== this.drag.pointerId) return;
        event.stopImmediatePropagation();
        this.apply(this.dragged(event, this.drag), true, event.timeStamp);
    }

    private release(event: PointerEvent): void {
        const { drag } = this;
        if (drag === null || event.pointerId !== drag.pointerId) return;
        event.stopImmediatePropagation();
        this.drag = null;
        this.options.canvas.classList.remove('dragging');
        this.options.onHold(false);
        const points =
            event.type === 'pointercancel'
                ? this.options.widget.getPoints()
                : this.dragged(event, drag);
        this.apply(points, false, event.timeStamp);
    }

    private dragged(event: PointerEvent, drag: Drag): Vec3[] {
        const { canvas, camera } = this.options;
        const pointer = place(event, canvas);
        const target = { x: pointer.x + drag.grab.x, y: pointer.y + drag.grab.y };
        const to = dragInViewPlane(target, drag.anchor, camera, sizeOf(canvas));
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

function place(event: PointerEvent, canvas: HTMLCanvasElement): ScreenPoint {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
}

function sizeOf(canvas: HTMLCanvasElement): ScreenSize {
    return { width: canvas.clientWidth, height: canvas.clientHeight };
}
