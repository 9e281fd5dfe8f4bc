// What a level surface is a level set of: a field, and a value by a slider over the field's range, or typed.
import { css, html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { DatasetDescription } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { describedRange, levelFields, levelOf } from '../../session/edits/levelFields.ts';
import type { AppState } from '../../state/appState.ts';
import { sharedStyles } from '../base/sharedStyles.ts';
import { SignalElement } from '../base/signalElement.ts';

const sliderSteps = 500;

export interface LevelModel {
    state: Pick<AppState, 'dataset' | 'outcomes' | 'surface'>;
    edits: Pick<Edits, 'changeSurface' | 'intent' | 'remark'>;
}

export class LevelPanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: LevelModel;

    static override styles = [
        sharedStyles,
        css`
            :host {
                display: block;
            }
            .row {
                display: flex;
                justify-content: space-between;
                align-items: center;
                gap: 8px;
                margin-top: 6px;
            }
            select {
                max-width: 190px;
            }
            input[type='number'] {
                width: 8em;
                text-align: right;
                font-variant-numeric: tabular-nums;
            }
            .quiet {
                margin: 4px 0 0;
                color: var(--quiet);
                font-size: 12px;
            }
        `,
    ];

    override render(): TemplateResult {
        const { state, edits } = this.model;
        const dataset = state.dataset.value;
        const intent = edits.intent.value;
        if (dataset === null || intent?.field == null || intent.level === null) return html``;
        const { field, level } = intent;
        const range = this.range(dataset, field);
        const names = levelFields(dataset);
        // A field that is no more is still what the surface is asked for.
        const choices = names.includes(field) ? names : [field, ...names];
        return html`
            <label class="row" for="level-field">
                <span>Field</span>
                <select id="level-field" @change=${this.fieldChanged}>
                    ${choices.map((name) => html`<option value=${name} .selected=${live(name === field)}>${fieldWords(name, dataset)}</option>`)}
                </select>
            </label>
            <label class="row" for="level-value">
                <span>Level</span>
                <input id="level-value" type="number" step="any" .value=${live(this.text(level, range))} @change=${this.levelTyped} />
            </label>
            ${
                range === null
                    ? nothing
                    : html`<input
                              id="level"
                              type="range"
                              aria-label="Level"
                              min=${range[0]}
                              max=${range[1]}
                              step=${(range[1] - range[0]) / sliderSteps}
                              .value=${live(String(level))}
                              @input=${this.levelSlid}
                          />
                          <p class="quiet" id="level-range">${shortNumber(range[0])} to ${shortNumber(range[1])} in the data.</p>`
            }
            <p class="quiet" id="surface-remark" role="status" ?hidden=${edits.remark.value === null}>${edits.remark.value}</p>
        `;
    }

    /** What the server has seen at the time that is shown; else what is known of the field. */
    private range(dataset: DatasetDescription, field: string): readonly [number, number] | null {
        const { state } = this.model;
        const record = state.surface.value;
        const [low, high] = state.outcomes.value.get(record?.surface ?? '')?.fieldRange ?? [];
        const told = record?.field === field && low !== undefined && high !== undefined && low < high;
        return told ? [low, high] : describedRange(dataset, field);
    }

    private text(level: number, range: readonly [number, number] | null): string {
        return range === null ? String(level) : fieldNumber(level, resolutionOf(0, range[1] - range[0]));
    }

    private readonly fieldChanged = (event: Event): void => {
        const dataset = this.model.state.dataset.value;
        const field = (event.target as HTMLSelectElement).value;
        if (dataset !== null) this.model.edits.changeSurface(levelOf(dataset, field));
    };

    private readonly levelSlid = (event: Event): void => {
        this.model.edits.changeSurface({ level: (event.target as HTMLInputElement).valueAsNumber });
    };

    /** What is no number is put back. */
    private readonly levelTyped = (event: Event): void => {
        const level = (event.target as HTMLInputElement).valueAsNumber;
        if (Number.isFinite(level)) this.model.edits.changeSurface({ level });
        else this.requestUpdate();
    };
}

function fieldWords(name: string, { velocity }: DatasetDescription): string {
    if (name === velocity) return `${name} (speed)`;
    if (name === 'q_criterion') return 'Vortices (Q)';
    return name === 'vorticity' ? 'Vorticity (magnitude)' : name;
}

customElements.define('wakesurf-level', LevelPanel);
