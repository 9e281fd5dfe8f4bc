// Dark or light.
import { css, html, type TemplateResult } from 'lit';
import type { Theme } from '../state/viewState.ts';
import type { AppModel } from './appModel.ts';
import { sharedStyles } from './sharedStyles.ts';
import { SignalElement } from './signalElement.ts';

const themes: readonly { theme: Theme; words: string }[] = [
    { theme: 'system', words: 'as the system' },
    { theme: 'dark', words: 'dark' },
    { theme: 'light', words: 'light' },
];

export class SurroundingsPanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
            label {
                display: flex;
                justify-content: space-between;
                align-items: center;
            }
        `,
    ];

    override render(): TemplateResult {
        const { view } = this.model;
        return html`<label
            >Colours of the page
            <select id="theme" @change=${this.choose}>
                ${themes.map(
                    ({ theme, words }) =>
                        html`<option value=${theme} .selected=${theme === view.theme.value}>${words}</option>`,
                )}
            </select>
        </label>`;
    }

    private choose(event: Event): void {
        const { value } = event.target as HTMLSelectElement;
        this.model.view.theme.value = themes.find(({ theme }) => theme === value)?.theme ?? 'system';
    }
}

customElements.define('wakesurf-surroundings', SurroundingsPanel);
