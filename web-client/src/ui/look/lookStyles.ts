// How the controls of a look are laid out, and the rows that recur in them.
import { css, html, type TemplateResult } from 'lit';
import { fieldNumber, resolutionOf } from '../../scene/base/numbers.ts';

export const lookStyles = css`
    .row {
        display: flex;
        justify-content: space-between;
        align-items: center;
        gap: 8px;
        min-height: 30px;
    }
    .row select,
    .row input[type='number'] {
        width: 168px;
        box-sizing: border-box;
    }
    .check {
        display: flex;
        align-items: center;
        gap: 8px;
        min-height: 28px;
    }
    .check input {
        margin: 0;
        accent-color: var(--accent);
    }
    .pair {
        display: grid;
        grid-template-columns: 1fr auto 1fr;
        gap: 8px;
        align-items: center;
        margin: 2px 0 4px;
    }
    .pair input {
        width: 100%;
        min-width: 0;
        text-align: right;
        font-variant-numeric: tabular-nums;
        appearance: textfield;
    }
    .pair input::-webkit-inner-spin-button {
        appearance: none;
    }
    .value {
        font-variant-numeric: tabular-nums;
    }
    .quiet {
        margin: 2px 0 6px;
        color: var(--quiet);
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

export function checkRow(
    id: string,
    words: string,
    checked: boolean,
    change: (on: boolean) => void,
    disabled = false,
): TemplateResult {
    return html`<label class="check" for=${id}>
        <input
            id=${id}
            type="checkbox"
            .checked=${checked}
            ?disabled=${disabled}
            @change=${(event: Event) => change((event.target as HTMLInputElement).checked)}
        />${words}
    </label>`;
}

export interface SliderRow {
    id: string;
    words: string;
    value: number;
    /** The value in words. */
    shown: string;
    low: number;
    high: number;
    step: number;
    change: (value: number) => void;
}

export function sliderRow({ id, words, value, shown, low, high, step, change }: SliderRow): TemplateResult {
    return html`<label class="row" for=${id}><span>${words}</span><span class="value">${shown}</span></label>
        <input
            id=${id}
            type="range"
            min=${low}
            max=${high}
            step=${step}
            .value=${String(value)}
            @input=${(event: Event) => change((event.target as HTMLInputElement).valueAsNumber)}
        />`;
}

export interface Choice<Value extends string> {
    value: Value;
    words: string;
    disabled?: boolean;
}

export function selectRow<Value extends string>(
    id: string,
    words: string,
    choices: readonly Choice<Value>[],
    chosen: string,
    change: (value: Value) => void,
): TemplateResult {
    const changed = (event: Event): void => {
        const { value } = event.target as HTMLSelectElement;
        const choice = choices.find((each) => each.value === value);
        if (choice !== undefined) change(choice.value);
    };
    return html`<label class="row" for=${id}
        ><span>${words}</span>
        <select id=${id} @change=${changed}>
            ${choices.map(
                (each) =>
                    html`<option value=${each.value} ?disabled=${each.disabled} .selected=${each.value === chosen}>
                        ${each.words}
                    </option>`,
            )}
        </select></label
    >`;
}

/** Two numbers, from and to; `change` gets them only when they make a span. */
export function pairRow(
    id: string,
    words: string,
    [low, high]: readonly [number, number],
    disabled: boolean,
    change: (pair: [number, number]) => void,
): TemplateResult {
    const shown = (value: number): string => fieldNumber(value, resolutionOf(low, high));
    const field = (part: 'from' | 'to', value: number): TemplateResult => html`<input
        id=${`${id}-${part}`}
        type="number"
        step="any"
        aria-label=${`${words} ${part}`}
        .value=${shown(value)}
        ?disabled=${disabled}
        @change=${(event: Event) => {
            const input = event.target as HTMLInputElement;
            const pair: [number, number] = part === 'from' ? [input.valueAsNumber, high] : [low, input.valueAsNumber];
            if (pair[0] <= pair[1]) change(pair);
            else input.value = shown(value);
        }}
    />`;
    return html`<div class="pair" role="group" aria-label=${words}>
        ${field('from', low)} <span aria-hidden="true">to</span> ${field('to', high)}
    </div>`;
}
