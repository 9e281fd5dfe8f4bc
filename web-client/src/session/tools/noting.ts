// Notes: a click says where, a dialog asks what.
import { centreOf } from '../../scene/domain/domainAxes.ts';
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { aim, type Sight } from './aiming.ts';

export interface NotingOptions extends Sight {
    state: AppState;
    pageView: ViewState;
}

export class Noting implements PointerTool {
    private readonly options: NotingOptions;

    constructor(options: NotingOptions) {
        this.options = options;
    }

    click({ at }: Pointer): boolean {
        const { state, pageView } = this.options;
        const bounds = state.dataset.value?.bounds;
        if (pageView.tool.value !== 'annotate' || bounds === undefined) return false;
        const { point, surface } = aim(this.options, at, centreOf(bounds));
        pageView.note.value = { annotation: null, text: '', position: point, surface };
        return true;
    }

    hover(): string | null {
        return this.options.pageView.tool.value === 'annotate' ? 'crosshair' : null;
    }
}
