// Which session this is, and the way to the others.
import { css, html, type TemplateResult } from 'lit';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from '../base/signalElement.ts';
import type { SessionsModel } from './sessionsDialog.ts';

// After the start: only who asks for the list sees it. What fails is tried again, and told of, then.
const load = (): Promise<unknown> => import('./sessionsDialog.ts');
load().catch(() => undefined);

export interface SessionHeadModel extends SessionsModel {
    state: SessionsModel['state'] & Pick<AppState, 'notices' | 'sessionName'>;
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
        const { state } = this.model;
        const name = state.gone.value === null ? state.sessionName.value : '';
        const words = name !== '' ? name : state.gone.value === null ? '' : 'No session';
        return html`<div>
                <span class="name cut" title=${words}><span class="quiet">Session</span> <span id="session-name">${words}</span></span>
                <button type="button" aria-haspopup="dialog" @click=${() => this.open()}>Sessions</button>
            </div>
            <wakesurf-sessions .model=${this.model}></wakesurf-sessions>`;
    }

    private open(): void {
        const { state, view } = this.model;
        view.sessionsShown.value = true;
        load().then(
            () => state.notices.solved('sessions'),
            (error: unknown) => state.notices.tell('sessions', error),
        );
    }
}

customElements.define('wakesurf-session-head', SessionHead);
