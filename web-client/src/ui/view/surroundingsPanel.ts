// What surrounds the surfaces: dark or light, and in which units its numbers are meant.
import { css, html, type TemplateResult } from 'lit';
import type { Theme, Units, ViewState } from '../../state/viewState.ts';
import { sharedStyles } from '../base/sharedStyles.ts';
import { SignalElement } from '../base/signalElement.ts';

const themes: readonly { theme: Theme; words: string }[] = [
    { theme: 'system', words: 'follow the system' },
    { theme: 'dark', words: 'dark' },
    { theme: 'light', words: 'light' },
];

export interface SurroundingsModel {
    view: Pick<ViewState, 'theme' | 'units'>;
}

export class SurroundingsPanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: SurroundingsModel;

    static override styles = [
        sharedStyles,
        css`
            input {
                width: 90px;
            }
            label + label {
                margin-top: 6px;
            }
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
                >Unit of length
                <input id="length-unit" maxlength="12" placeholder="none" .value=${view.units.value.length} @change=${(event: Event) => this.setUnit('length', event)} />
            </label>
            <label
                >Unit of time
                <input id="time-unit" maxlength="12" placeholder="none" .value=${view.units.value.time} @change=${(event: Event) => this.setUnit('time', event)} />
            </label>
            <label
            >Colours of the page
            <select id="theme" @change=${this.choose}>
                ${themes.map(
                    ({ theme, words }) => html`<option value=${theme} .selected=${theme === view.theme.value}>${words}</option>`,
                )}
            </select>
        </label>`;
    }

    private setUnit(of: keyof Units, event: Event): void {
        const { units } = this.model.view;
        units.value = { ...units.value, [of]: (event.target as HTMLInputElement).value.trim() };
    }

    private choose(event: Event): void {
        const { value } = event.target as HTMLSelectElement;
        this.model.view.theme.value = themes.find(({ theme }) => theme === value)?.theme ?? 'system';
    }
}

customElements.define('wakesurf-surroundings', SurroundingsPanel);
