// Notes: a click says where, a dialog asks what.
import type { Pointer, PointerTool } from '../../scene/base/pointerTools.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { aim, nothingThere, type Sight } from './aiming.ts';

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
        if (pageView.tool.value !== 'annotate' || state.dataset.value === null) return false;
        const aimed = aim(this.options, at);
        if (aimed === null) {
            pageView.besidePointer.value = { at, words: nothingThere };
            return true;
        }
        pageView.besidePointer.value = null;
        const { point, surface } = aimed;
        pageView.writeNote({ annotation: null, text: '', position: point, surface });
        return true;
    }

    hover(): string | null {
        return this.options.pageView.tool.value === 'annotate' ? 'crosshair' : null;
    }
}
