// What the parts of the tab "Export" share: styles, and the choice of a size, which is a usual one, that of the page, or numbers.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import type { ScreenSize } from '../../scene/base/view.ts';
import { numberField, selectRow } from '../base/rows.ts';

export const exportStyles = css`
    :host {
        display: block;
    }
    .row,
    .check {
        margin-top: 6px;
    }
    div.row {
        justify-content: flex-start;
        flex-wrap: wrap;
    }
    select {
        max-width: 100%;
    }
    input.number {
        width: 84px;
        text-align: right;
        font-variant-numeric: tabular-nums;
    }
    .check {
        gap: 6px;
    }
    .check input {
        width: 16px;
        height: 16px;
    }
    .checks {
        display: grid;
        grid-template-columns: 1fr 1fr;
    }
    button {
        min-width: 68px;
    }
    progress {
        width: 100%;
    }
    p[role='alert'] {
        color: var(--warm);
    }
`;

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
        const sizes = [
            { value: 'shown', words: `as shown, ${words(shown)}` },
            ...this.presets.map((preset) => ({ value: words(preset), words: words(preset) })),
            { value: 'typed', words: 'other' },
        ];
        return html`${selectRow(`${id}-size`, 'Size', sizes, chosen, (value) => this.choose(value, shown))}
            ${
                chosen === 'typed'
                    ? html`<div class="row">${this.number('width', shown)} × ${this.number('height', shown)}</div>`
                    : nothing
            }`;
    }

    private number(side: 'width' | 'height', shown: ScreenSize): TemplateResult {
        return numberField({
            ...{ id: `${this.id}-${side}`, label: `${side === 'width' ? 'Width' : 'Height'} in pixels`, min: 16 },
            shown: String(this.size(shown)[side]),
            change: (value) => void (this.typed.value = { ...this.size(shown), [side]: Math.round(value) }),
        });
    }

    private choose(value: string, shown: ScreenSize): void {
        if (value === 'typed') this.typed.value = this.size(shown);
        this.chosen.value = value;
    }
}

function words({ width, height }: ScreenSize): string {
    return `${width} × ${height}`;
}
