// The flow along the body, which is no surface of the session: this page's own.
import { html, nothing, type TemplateResult } from 'lit';
import type { BodyFlow } from '../../session/picture/bodyFlow.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow } from '../base/rows.ts';
import { lookStyles } from './lookStyles.ts';
import { ModelElement } from '../base/signalElement.ts';

export interface BodyModel {
    state: Pick<AppState, 'dataset'>;
    view: Pick<ViewState, 'bodyTexture'>;
    bodyFlow: Pick<BodyFlow, 'standing'>;
}

const words = {
    off: '',
    waiting: 'The flow along the body is on its way.',
    shown: 'The velocity is that a quarter of a cell off the body. Where the clock runs, the texture goes with the flow.',
    failed: 'The server did not send the flow along the body at this time.',
};

export class BodyPanel extends ModelElement<BodyModel> {
    static override styles = lookStyles;

    override render(): TemplateResult {
        const { state, view, bodyFlow } = this.model;
        const { bodyTexture } = view;
        const none = state.dataset.value?.obstacle !== true;
        const said = none ? 'There is no body in this dataset.' : words[bodyFlow.standing.value];
        return html`
            ${checkRow('Show the flow along the body', bodyTexture.value, (on) => (bodyTexture.value = on), { id: 'body-texture', disabled: none })}
            ${said === '' ? nothing : html`<p class="quiet" role="status">${said}</p>`}
        `;
    }
}

customElements.define('wakesurf-body', BodyPanel);
