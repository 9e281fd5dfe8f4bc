// The measure: the distance between two points of the picture.
import type { Vec3 } from '../../protocol/messages.ts';
import { centreOf } from '../../scene/domain/domainAxes.ts';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { aim, type Sight } from './aiming.ts';

export interface MeasuringOptions extends Sight {
    state: AppState;
    pageView: ViewState;
}

export class Measuring implements PointerTool {
    private readonly options: MeasuringOptions;

    constructor(options: MeasuringOptions) {
        this.options = options;
    }

    /** The first click sets one end, the second the other, the third starts again. */
    click({ at }: Pointer): boolean {
        const { state, pageView } = this.options;
        const bounds = state.dataset.value?.bounds;
        if (pageView.tool.value !== 'measure' || bounds === undefined) return false;
        const ends = pageView.measured.value;
        const { point } = aim(this.options, at, ends.at(-1) ?? centreOf(bounds));
        pageView.measured.value = ends.length === 1 ? [ends[0]!, point] : [point];
        return true;
    }

    hover(): string | null {
        return this.options.pageView.tool.value === 'measure' ? 'crosshair' : null;
    }
}

export function distance(a: Vec3, b: Vec3): number {
    return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}
