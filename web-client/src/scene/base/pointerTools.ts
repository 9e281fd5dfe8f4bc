// Who gets the pointer on the canvas: tools are asked in turn, and what none of them takes is left to
// the camera. Listens before the camera controls do, so that the camera stays still while a tool holds the
// pointer.
import type { ScreenPoint } from './view.ts';

export interface Pointer {
    at: ScreenPoint;
    /** The time of the event in milliseconds, on performance.now()'s clock. */
    time: number;
    shift: boolean;
}

/** One way to act on the picture with the pointer. Whatever it leaves out it does not do. */
export interface PointerTool {
    /** True takes the pointer until it is released. */
    press?(pointer: Pointer): boolean;
    /** Only while held. */
    move?(pointer: Pointer): void;
    release?(pointer: Pointer, cancelled: boolean): void;
    /** A press that no tool took has ended where it began; true: done. */
    click?(pointer: Pointer): boolean;
    /** The pointer passes over the canvas (null: it left): how the cursor should look here, if this tool
     *  cares. */
    hover?(pointer: Pointer | null): string | null;
    /** Held or passing, whichever tool has the pointer. */
    watch?(pointer: Pointer | null): void;
}

/** A hand shakes a little. */
const clickSlackPx = 4;

export class PointerTools {
    private readonly canvas: HTMLCanvasElement;
    private readonly tools: PointerTool[] = [];
    private held: { tool: PointerTool; pointerId: number } | null = null;
    private pressedAt: ScreenPoint | null = null;

    constructor(canvas: HTMLCanvasElement) {
        this.canvas = canvas;
        canvas.addEventListener('pointerdown', (event) => this.press(event));
        canvas.addEventListener('pointermove', (event) => this.move(event));
        canvas.addEventListener('pointerup', (event) => this.release(event));
        canvas.addEventListener('pointercancel', (event) => this.release(event));
        canvas.addEventListener('pointerleave', () => {
            for (const tool of this.tools) {
                tool.hover?.(null);
                tool.watch?.(null);
            }
        });
    }

    /** The first one added is asked first. */
    add(tool: PointerTool): void {
        this.tools.push(tool);
    }

    private press(event: PointerEvent): void {
        if (!event.isPrimary || event.button !== 0) return;
        const pointer = this.pointerOf(event);
        const tool = this.tools.find((each) => each.press?.(pointer) === true);
        this.pressedAt = tool === undefined ? pointer.at : null;
        if (tool === undefined) return;
        event.stopImmediatePropagation();
        this.canvas.setPointerCapture(event.pointerId);
        this.canvas.style.cursor = 'grabbing';
        this.held = { tool, pointerId: event.pointerId };
    }

    private move(event: PointerEvent): void {
        const pointer = this.pointerOf(event);
        for (const tool of this.tools) tool.watch?.(pointer);
        if (this.held === null) {
            if (event.buttons === 0) this.hover(pointer);
            return;
        }
        if (event.pointerId !== this.held.pointerId) return;
        event.stopImmediatePropagation();
        this.held.tool.move?.(pointer);
    }

    private release(event: PointerEvent): void {
        const pointer = this.pointerOf(event);
        const { held, pressedAt } = this;
        if (held !== null && event.pointerId === held.pointerId) {
            event.stopImmediatePropagation();
            this.held = null;
            held.tool.release?.(pointer, event.type === 'pointercancel');
            this.hover(pointer);
        } else if (pressedAt !== null && event.type === 'pointerup' && event.isPrimary) {
            this.pressedAt = null;
            const { x, y } = pointer.at;
            if (Math.hypot(x - pressedAt.x, y - pressedAt.y) > clickSlackPx) return;
            this.tools.find((each) => each.click?.(pointer) === true);
        }
    }

    private hover(pointer: Pointer): void {
        let cursor: string | null = null;
        // All of them, because each may have something to take back.
        for (const tool of this.tools) {
            const wish = tool.hover?.(pointer) ?? null;
            cursor ??= wish;
        }
        this.canvas.style.cursor = cursor ?? '';
    }

    private pointerOf(event: PointerEvent): Pointer {
        const box = this.canvas.getBoundingClientRect();
        return {
            at: { x: event.clientX - box.left, y: event.clientY - box.top },
            time: event.timeStamp,
            shift: event.shiftKey,
        };
    }
}
