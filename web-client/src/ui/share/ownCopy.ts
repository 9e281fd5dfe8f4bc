// The way into a copy of the session, beside what cannot be done in the session itself.
import { html, type TemplateResult } from 'lit';
import type { OwnCopy } from '../../session/sessions/ownCopy.ts';
import { ModelElement } from '../base/signalElement.ts';

export class OwnCopyButton extends ModelElement<Pick<OwnCopy, 'possible' | 'begin'>> {
    override render(): TemplateResult {
        return html`<button
            type="button"
            title="The same rakes and surfaces at the same time, in a session of your own: what you do there, nobody else sees"
            ?disabled=${!this.model.possible.value}
            @click=${() => this.model.begin()}
        >
            Continue in a copy
        </button>`;
    }
}

customElements.define('wakesurf-own-copy', OwnCopyButton);
