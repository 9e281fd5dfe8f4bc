// One rake in the scene: its curve and, where it is the chosen one, its handles.
import { Group } from 'three';
import type { Vec3 } from '../../protocol/messages.ts';
import type { View } from '../base/view.ts';
import type { DrawnRake, HeldHandle } from './drawnRake.ts';
import { type HandleSprite, HandleSprites, markOf } from './handleSprites.ts';
import { RakeCurve } from './rakeCurve.ts';
import { type Handle, handlesOf, hasPointHandles, positionOf } from './rakeHandles.ts';
import { curveOf, middleOf, type RakeShape } from './rakeShape.ts';

const handleRadiusPx = 11;
const smallRadiusPx = 9;
/** Small and without colour: nothing to take hold of. */
const lockedRadiusPx = 6;
const lockedColour = '#7d8896';
const dotRadiusPx = 4;
const smallDotRadiusPx = 2.5;
/** More would hide the rake behind its points. */
const mostDots = 64;

/** White on both sides, so that it stands out whatever its colour is. */
const chosenStyle = { widthPx: 8, opacity: 1, haloPx: 1.1 };
const otherStyle = { widthPx: 4.5, opacity: 0.9, haloPx: 0 };

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
        const every = Math.ceil(points.length / mostDots);
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
