// The edges of the domain. They are the ground of the picture: nothing of them lies over what is in the
// domain. Those nearest to the eye, which would cross it, are pale.
import type { Color } from 'three';
import type { View } from '../base/view.ts';
import { tintOf, WideLines } from '../base/wideLines.ts';
import { type Bounds, boxEdges, centreOf, edgesBeforeBox } from './domainAxes.ts';

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
