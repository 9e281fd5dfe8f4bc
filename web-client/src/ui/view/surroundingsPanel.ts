// Shows what surrounds the surfaces: dark or light, shade where things touch, and in which units its numbers
// are meant.
import { css, html, type TemplateResult } from 'lit';
import { limits } from '../../protocol/generated/limits.ts';
import type { AppState, Units } from '../../state/appState.ts';
import type { Theme, ViewState } from '../../state/viewState.ts';
import { type Choice, selectRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

const themes: readonly Choice<Theme>[] = [
    { value: 'system', words: 'follow the system' },
    { value: 'dark', words: 'dark' },
    { value: 'light', words: 'light' },
];

export interface SurroundingsModel {
    state: Pick<AppState, 'dataset' | 'locked' | 'typedUnits'>;
    view: Pick<ViewState, 'contactShade' | 'theme'>;
    typeUnits: (change: Partial<Units>) => void;
}

export class SurroundingsPanel extends ModelElement<SurroundingsModel> {
    static override styles = css`
        input {
            width: 90px;
        }
        input[type='checkbox'] {
            width: auto;
        }
        label + label {
            margin-top: 6px;
        }
    `;

    override render(): TemplateResult {
        const { state, view } = this.model;
        const { lengthUnit, timeUnit } = state.dataset.value ?? {};
        return html`${this.unit('length', lengthUnit)} ${this.unit('time', timeUnit)}
            ${selectRow('theme', 'Colours of the page', themes, view.theme.value, (theme) => (view.theme.value = theme))}
        <label class="row" title="In pictures that stand still, and in figures"
            >Shade where things touch
            <input
                id="contact-shade"
                type="checkbox"
                .checked=${view.contactShade.value}
                @change=${(event: Event) => {
                    view.contactShade.value = (event.target as HTMLInputElement).checked;
                }}
            />
        </label>`;
    }

    /** @param known by the reader of the data */
    private unit(of: keyof Units, known: string | undefined): TemplateResult {
        const { state, typeUnits } = this.model;
        return html`<label class="row" title="For everyone in this session. Empty: as the data say."
            >Unit of ${of}
            <input
                id=${`${of}-unit`}
                maxlength=${limits.unitBytes}
                placeholder=${known ?? 'none'}
                ?disabled=${state.locked.value}
                .value=${state.typedUnits.value[of]}
                @change=${(event: Event) => typeUnits({ [of]: (event.target as HTMLInputElement).value.trim() })}
            />
        </label>`;
    }
}

customElements.define('wakesurf-surroundings', SurroundingsPanel);
