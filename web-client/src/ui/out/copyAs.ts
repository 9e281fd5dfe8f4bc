// Two small buttons below the panel: what its tab shows, as a script to copy. Where a page may not write to
// the clipboard (it may not over http from another machine) the text is shown, to be copied by hand.
//     <wakesurf-copy-as .model=${model} .calls=${() => [{ method, params }]}></wakesurf-copy-as>
import { css, html, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import { curlScript, pythonScript, type ScriptStep } from '../../session/out/scripts.ts';
import { baseUrl, readFragment } from '../../session/view/urlState.ts';
import type { AppState } from '../../state/appState.ts';
import { copyText } from '../base/copyAndSave.ts';
import { dialogStyles, ModelElement } from '../base/signalElement.ts';

const languages = { Python: pythonScript, curl: curlScript };
type Language = keyof typeof languages;
const saidForMs = 2500;

export interface CopyAsModel {
    state: Pick<AppState, 'session'>;
}

export class CopyAs extends ModelElement<CopyAsModel> {
    static override properties = { calls: { attribute: false } };
    /** Asked when a button is pressed; an empty answer: there is nothing to do yet. */
    declare calls: () => ScriptStep[];
    private readonly said = signal('');
    private readonly shown = signal('');

    static override styles = [
        dialogStyles,
        css`
            :host {
                display: flex;
                flex-wrap: wrap;
                align-items: center;
                gap: 4px 6px;
                font-size: 12px;
            }
            button {
                min-height: 24px;
                padding: 1px 8px;
                color: var(--quiet);
            }
            button:hover {
                color: var(--text);
            }
            [role='status'] {
                color: var(--good);
            }
            dialog {
                width: min(720px, 90vw);
            }
            dialog p {
                margin: 0 0 8px;
            }
            textarea {
                width: 100%;
                height: 40vh;
                margin-bottom: 8px;
                font:
                    12px / 1.4 ui-monospace,
                    monospace;
                color: inherit;
                background: var(--raised);
                border: 1px solid var(--line);
                border-radius: 6px;
                white-space: pre;
            }
        `,
    ];

    override render(): TemplateResult {
        return html`
            ${(['Python', 'curl'] as const).map(
                (language) =>
                    html`<button
                        type="button"
                        title=${`Copy a script that does the same in ${language} (without your token)`}
                        @click=${() => this.copy(language)}
                    >
                        Copy as ${language}
                    </button>`,
            )}
            <span role="status">${this.said.value}</span>
            <dialog aria-labelledby="copy-head" @close=${() => (this.shown.value = '')}>
                <p id="copy-head">
                    The browser does not let this page write to the clipboard. The text is selected: copy it yourself.
                </p>
                <textarea readonly aria-label="Script" spellcheck="false" .value=${this.shown.value}></textarea>
                <form method="dialog"><button>Close</button></form>
            </dialog>
        `;
    }

    private async copy(language: Language): Promise<void> {
        const steps = this.calls();
        if (steps.length === 0) {
            this.say('There is nothing to copy yet.');
            return;
        }
        const session = this.model.state.session.value ?? readFragment(location.hash).session ?? 'main';
        const text = languages[language]({ server: baseUrl().replace(/\/$/, ''), session }, steps);
        if (await copyText(text)) this.say(`Copied as ${language}`);
        else this.show(text);
    }

    private say(text: string): void {
        this.said.value = text;
        setTimeout(() => {
            if (this.said.value === text) this.said.value = '';
        }, saidForMs);
    }

    private show(text: string): void {
        this.shown.value = text;
        void this.updateComplete.then(() => {
            this.renderRoot.querySelector('dialog')?.showModal();
            this.renderRoot.querySelector('textarea')?.select();
        });
    }
}

customElements.define('wakesurf-copy-as', CopyAs);
