// Lays out the groups of a look, and does what all of them do.
import { css, type CSSResultGroup } from 'lit';
import type { AppState } from '../../state/appState.ts';
import type { SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement } from '../base/signalElement.ts';

export const lookStyles = css`
    .row {
        min-height: 30px;
    }
    .row select {
        min-width: 168px;
    }
    .row input.number {
        width: 168px;
    }
    .check {
        min-height: 28px;
    }
    .pair {
        display: grid;
        grid-template-columns: 1fr auto 1fr;
        gap: 8px;
        align-items: center;
        margin: 2px 0 4px;
    }
    .quiet {
        margin: 2px 0 6px;
        font-size: 12px;
    }
    .buttons {
        display: grid;
        grid-auto-flow: column;
        grid-auto-columns: 1fr;
        gap: 6px;
        margin: 6px 0;
    }
    button[aria-pressed='true'] {
        border-color: var(--accent);
        background: var(--accent);
        color: var(--ground);
    }
`;

/** What a group takes whose settings are those of the selected surface. */
export interface LookGroupModel {
    state: Pick<AppState, 'activeSurface'>;
    view: Pick<ViewState, 'changeLook' | 'lookOf'>;
}

/** Settings of the selected surface's look. */
export abstract class LookGroup<Model extends LookGroupModel> extends ModelElement<Model> {
    static override styles: CSSResultGroup = lookStyles;

    protected get look(): SurfaceLook {
        return this.model.view.lookOf(this.model.state.activeSurface.value);
    }

    protected change(change: Partial<SurfaceLook>): void {
        const id = this.model.state.activeSurface.value;
        if (id !== null) this.model.view.changeLook(id, change);
    }
}
