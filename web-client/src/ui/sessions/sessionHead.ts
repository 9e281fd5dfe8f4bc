// Which session this is, and the way to the others.
import { css, html, type TemplateResult } from 'lit';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from '../base/signalElement.ts';
import type { SessionsModel } from './sessionsDialog.ts';

// After the start: only who asks for the list sees it.
void import('./sessionsDialog.ts');

export interface SessionHeadModel extends SessionsModel {
    state: SessionsModel['state'] & Pick<AppState, 'sessionName'>;
}

export class SessionHead extends ModelElement<SessionHeadModel> {
    static override styles = css`
        div {
            display: flex;
            gap: 8px;
            align-items: center;
            margin: 4px 0 2px;
        }
        .name {
            flex: 1;
            min-width: 0;
        }
    `;

    override render(): TemplateResult {
        const { state, view } = this.model;
        const name = state.gone.value === null ? state.sessionName.value : '';
        const words = name !== '' ? name : state.gone.value === null ? '' : 'No session';
        return html`<div>
                <span class="name cut" title=${words}><span class="quiet">Session</span> <span id="session-name">${words}</span></span>
                <button type="button" aria-haspopup="dialog" @click=${() => (view.sessionsShown.value = true)}>Sessions</button>
            </div>
            <wakesurf-sessions .model=${this.model}></wakesurf-sessions>`;
    }
}

customElements.define('wakesurf-session-head', SessionHead);
