// How large a picture or a film is to be: some usual sizes, that of the page, or numbers.
import { html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import type { ScreenSize } from '../../scene/base/view.ts';

export class SizeChoice {
    private readonly id: string;
    private readonly presets: readonly ScreenSize[];
    private readonly chosen = signal('shown');
    private readonly typed = signal<ScreenSize | null>(null);

    constructor(id: string, presets: readonly ScreenSize[]) {
        this.id = id;
        this.presets = presets;
    }

    size(shown: ScreenSize): ScreenSize {
        if (this.chosen.value === 'typed') return this.typed.value ?? shown;
        return this.presets.find((preset) => words(preset) === this.chosen.value) ?? shown;
    }

    render(shown: ScreenSize): TemplateResult {
        const { id } = this;
        const chosen = this.chosen.value;
        const option = (value: string, label: string): TemplateResult =>
            html`<option value=${value} .selected=${chosen === value}>${label}</option>`;
        return html`<label
                >Size
                <select id=${`${id}-size`} @change=${(event: Event) => this.choose(event, shown)}>
                    ${option('shown', `as shown, ${words(shown)}`)}
                    ${this.presets.map((preset) => option(words(preset), words(preset)))}
                    ${option('typed', 'other')}
                </select>
            </label>
            ${
                chosen === 'typed'
                    ? html`<div class="row">${this.number('width', shown)} × ${this.number('height', shown)}</div>`
                    : nothing
            }`;
    }

    private number(side: 'width' | 'height', shown: ScreenSize): TemplateResult {
        return html`<input
            id=${`${this.id}-${side}`}
            type="number"
            min="16"
            step="1"
            aria-label=${`${side === 'width' ? 'Width' : 'Height'} in pixels`}
            .value=${String(this.size(shown)[side])}
            @change=${(event: Event) => {
                const value = (event.target as HTMLInputElement).valueAsNumber;
                this.typed.value = { ...this.size(shown), [side]: value };
            }}
        />`;
    }

    private choose(event: Event, shown: ScreenSize): void {
        const { value } = event.target as HTMLSelectElement;
        if (value === 'typed') this.typed.value = this.size(shown);
        this.chosen.value = value;
    }
}

function words({ width, height }: ScreenSize): string {
    return `${width} × ${height}`;
}
