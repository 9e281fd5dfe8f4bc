// The measure: the distance between two points of the picture.
import type { Vec3 } from '../../protocol/messages.ts';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { aim, nothingThere, type Sight } from './aiming.ts';

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
        if (pageView.tool.value !== 'measure' || state.dataset.value === null) return false;
        const aimed = aim(this.options, at);
        if (aimed === null) {
            pageView.besidePointer.value = { at, words: nothingThere };
            return true;
        }
        const ends = pageView.measured.value;
        const first = ends.length !== 1;
        pageView.measured.value = first ? [aimed.point] : [ends[0]!, aimed.point];
        pageView.besidePointer.value = first ? { at, words: 'From here: click the other end.' } : null;
        return true;
    }

    hover(): string | null {
        return this.options.pageView.tool.value === 'measure' ? 'crosshair' : null;
    }
}

export function distance(a: Vec3, b: Vec3): number {
    return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
}
