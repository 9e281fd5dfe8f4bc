// A slice through three points that are clicked, one after the other.
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import { centroid } from '../../scene/slices/planeSection.ts';
import { cross, distance, minus, unit } from '../../scene/rake/rakeShape.ts';
import type { ViewState } from '../../state/viewState.ts';
import { aim, nothingThere, type Sight } from './pointTools.ts';

export interface SlicePointsOptions extends Sight {
    view: Pick<ViewState, 'besidePointer' | 'slicePoints' | 'tool'>;
    add: (origin: Vec3, normal: Vec3) => void;
}

const words = ['Click a second point.', 'Click a third point.'];
/** The sine of the smallest angle at which two of them are seen from the third that tells a plane. */
const leastSine = 1e-3;

export class SlicePoints implements PointerTool {
    private readonly options: SlicePointsOptions;

    constructor(options: SlicePointsOptions) {
        this.options = options;
    }

    click({ at }: Pointer): boolean {
        const { view, add } = this.options;
        if (view.tool.value !== 'slice') return false;
        const aimed = aim(this.options, at);
        const say = (said: string): void => void (view.besidePointer.value = { at, words: said });
        if (aimed === null) {
            say(nothingThere);
            return true;
        }
        const points = [...view.slicePoints.value, aimed.point];
        if (points.length < 3) {
            view.slicePoints.value = points;
            say(words[points.length - 1]!);
            return true;
        }
        const normal = normalOf(points);
        if (normal === null) {
            say('The three points lie on one line. Click another third point.');
            return true;
        }
        view.tool.value = 'none';
        view.slicePoints.value = [];
        add(centroid(points), normal);
        return true;
    }

    hover(): string | null {
        const { view } = this.options;
        if (view.tool.value === 'slice') return 'crosshair';
        if (view.slicePoints.value.length > 0) view.slicePoints.value = [];
        return null;
    }
}

/** Null where no plane is told: two are the same, or all are on one line. */
function normalOf([a, b, c]: readonly Vec3[]): Vec3 | null {
    const [p, q] = [minus(b!, a!), minus(c!, a!)];
    const across = cross(p, q);
    const isFlat = Math.hypot(...across) <= leastSine * distance(a!, b!) * distance(a!, c!);
    return isFlat ? null : unit(across);
}
