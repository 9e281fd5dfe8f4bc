// The brush of the painter: drag to reveal or erase what it touches in the picture, click to hide a part. Takes the pointer only while it
// is the chosen tool.
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { ScreenPoint } from '../../scene/base/view.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { ViewState } from '../../state/viewState.ts';

const clickRadiusPx = 6;

export function connectPainting(view: ViewState, scene: FlowScene): void {
    const isPart = (): boolean => view.brush.value.does === 'hidePart';
    const radius = (): number => (isPart() ? clickRadiusPx : view.brush.value.radiusPx);
    const paint = (at: ScreenPoint): void => {
        if (isPart()) {
            hidePart(view, scene, at);
            return;
        }
        const radiusPx = radius();
        const { size, hits } = scene.pickGrid(at, radiusPx, { throughPaint: true });
        scene.surfaces.paint({ size, hits, radiusPx }, view.brush.value.does === 'reveal');
        scene.loop.request();
    };
    scene.pointerTools.add(
        new PaintTool({
            radiusPx: () => (view.tool.value === 'paint' ? radius() : null),
            paint,
            overlay: scene.labels,
        }),
    );
}

function hidePart(view: ViewState, scene: FlowScene, at: ScreenPoint): void {
    const hit = scene.pick(at);
    if (hit === null || hit.surface === null) return;
    const { hiddenParts } = view.lookOf(hit.surface);
    view.changeLook(hit.surface, { hiddenParts: [...hiddenParts, [hit.s, hit.t]] });
}

export interface PaintToolOptions {
    /** Returns the radius of the brush in pixels of CSS; null: another tool is chosen. */
    radiusPx: () => number | null;
    paint: (at: ScreenPoint) => void;
    /** Lies over the canvas and takes the outline of the brush. */
    overlay: HTMLElement;
}

export class PaintTool implements PointerTool {
    private readonly options: PaintToolOptions;
    private readonly ring = document.createElement('div');
    private last: ScreenPoint | null = null;

    constructor(options: PaintToolOptions) {
        this.options = options;
        this.ring.className = 'brush';
        this.ring.hidden = true;
        options.overlay.append(this.ring);
    }

    press({ at }: Pointer): boolean {
        if (this.options.radiusPx() === null) return false;
        this.last = at;
        this.options.paint(at);
        return true;
    }

    /** Without gaps, however fast the pointer is. */
    move({ at }: Pointer): void {
        const from = this.last ?? at;
        const spacing = Math.max(2, (this.options.radiusPx() ?? 4) / 2);
        const steps = Math.max(1, Math.ceil(Math.hypot(at.x - from.x, at.y - from.y) / spacing));
        for (let step = 1; step <= steps; ++step) {
            const part = step / steps;
            this.options.paint({ x: from.x + part * (at.x - from.x), y: from.y + part * (at.y - from.y) });
        }
        this.last = at;
    }

    release(): void {
        this.last = null;
    }

    hover(): string | null {
        return this.options.radiusPx() === null ? null : 'crosshair';
    }

    watch(pointer: Pointer | null): void {
        const radius = this.options.radiusPx();
        this.ring.hidden = pointer === null || radius === null;
        if (pointer === null || radius === null) return;
        this.ring.style.width = this.ring.style.height = `${2 * radius}px`;
        this.ring.style.transform = `translate(${pointer.at.x - radius}px, ${pointer.at.y - radius}px)`;
    }
}
