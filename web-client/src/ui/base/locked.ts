// What is said where a control cannot be used: why, to who points at it, and the way into a copy of the session, in which it can.
import { html, type TemplateResult } from 'lit';
import type { OwnCopy } from '../../session/sessions/ownCopy.ts';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from './signalElement.ts';

/** Empty: nothing is in the way. */
function lockedWords({ locked, role }: Pick<AppState, 'locked' | 'role'>): string {
    if (!locked.value) return '';
    return role.value === 'viewer'
        ? 'Your link is for looking: only people who can edit may do this'
        : 'Not connected to the server';
}

/** Returns what a control does, or why it cannot. */
export function titleOf(state: Pick<AppState, 'locked' | 'role'>, words: string): string {
    const why = lockedWords(state);
    return why === '' ? words : `${words} (${why})`;
}

/** The way into a copy of the session, beside what cannot be done in the session itself. */
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
