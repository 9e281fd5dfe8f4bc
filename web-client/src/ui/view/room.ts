// Room for the picture: the panel folded away, and the page on the full screen.
import { keep, recall } from '../../state/browserMemory.ts';
import type { ViewState } from '../../state/viewState.ts';

const panelKey = 'panel';
const folded = 'folded';

/** Returns whether another page shows this one in a frame, as a notebook does, where there is little room. */
export function isInFrame(): boolean {
    return globalThis.top !== globalThis.self;
}

/** Sets the panel as it was when this browser was here last; at first folded in a frame. */
export function recallPanel(view: Pick<ViewState, 'panelFolded'>): void {
    view.panelFolded.value = (recall(panelKey) ?? (isInFrame() ? folded : '')) === folded;
}

export function togglePanel({ panelFolded }: Pick<ViewState, 'panelFolded'>): void {
    panelFolded.value = !panelFolded.value;
    keep(panelKey, panelFolded.value ? folded : 'open');
}

/** Some browsers, as those of small telephones, have none for pages. */
export function hasFullScreen(): boolean {
    return document.fullscreenEnabled;
}

export function turnFullScreen(): void {
    if (!hasFullScreen()) return;
    // A browser that refuses has its reasons, and says so itself.
    void (document.fullscreenElement === null ? document.documentElement.requestFullscreen() : document.exitFullscreen()).catch(
        () => undefined,
    );
}
