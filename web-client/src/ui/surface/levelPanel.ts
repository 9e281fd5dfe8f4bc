// Shows what a level surface is a level set of: a field, and a value by a slider over the field's range, or
// typed.
import { signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { DatasetDescription } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { describedRange, levelFields, levelOf } from '../../session/edits/defaults.ts';
import { numberRow, selectRow } from '../base/rows.ts';
import type { AppState } from '../../state/appState.ts';
import type { Families, FamilyChoice } from '../../session/surface/families.ts';
import { fieldWords } from '../../session/picture/surfaceOwner.ts';

const sliderSteps = 500;

const inflows: readonly [FamilyChoice, string][] = [
    ['x', 'Inflow: x'],
    ['y', 'Inflow: y'],
    ['z', 'Inflow: z'],
];

export interface LevelModel {
    state: Pick<AppState, 'dataset' | 'outcomes' | 'rakes' | 'surface'>;
    edits: Pick<Edits, 'changeSurface' | 'intent' | 'remark'>;
    families: Families;
}

/** Rows of the surface's panel. */
export class LevelRows {
    private readonly model: LevelModel;
    private readonly source = signal<FamilyChoice | null>(null);

    constructor(model: LevelModel) {
        this.model = model;
    }

    rows(): TemplateResult {
        const { state, edits } = this.model;
        const dataset = state.dataset.value;
        const intent = edits.intent.value;
        if (dataset === null || intent?.field == null || intent.level === null) return html``;
        const { field, level } = intent;
        const range = this.range(dataset, field);
        const names = levelFields(dataset);
        // A field that is no more is still what the surface is asked for.
        const all = names.includes(field) ? names : [field, ...names];
        const choices = all.map((name) => ({ value: name, words: fieldWords(name, dataset) }));
        return html`
            ${selectRow('level-field', 'Field', choices, field, (name) => edits.changeSurface(levelOf(dataset, name)))}
            ${numberRow('Level', {
                ...{ id: 'level-value', shown: this.text(level, range) },
                change: (typed) => edits.changeSurface({ level: typed }),
            })}
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
            ${this.family()}
        `;
    }

    /** A scalar that the flow carries, whose level sets are stream surfaces. */
    private family(): TemplateResult {
        const { families, state } = this.model;
        const rakes = [...state.rakes.value.values()].map(({ rake, name }): [FamilyChoice, string] => [
            { rake },
            `Rake: ${name}`,
        ]);
        const sources = [...rakes, ...inflows];
        const status = families.status.value;
        const making = status?.making === true;
        const choose = (event: Event): void => {
            this.source.value = sources[(event.target as HTMLSelectElement).selectedIndex]?.[0] ?? null;
        };
        return html`<details id="family">
            <summary>Make a family…</summary>
            <label class="row" for="family-from">
                <select id="family-from" ?disabled=${making} @change=${choose}>
                    ${sources.map(([, words]) => html`<option>${words}</option>`)}
                </select>
                <button type="button" @click=${() => (making ? families.cancel() : void families.make(this.source.value ?? sources[0]![0]))}>
                    ${making ? 'Cancel' : 'Make it'}
                </button>
            </label>
            <p class="quiet" role="status">${status?.words}</p>
        </details>`;
    }

    /** Returns what the server has seen at the time that is shown; else what is known of the field. */
    private range(dataset: DatasetDescription, field: string): readonly [number, number] | null {
        const { state } = this.model;
        const record = state.surface.value;
        const [low, high] = state.outcomes.value.get(record?.surface ?? '')?.fieldRange ?? [];
        const announced = record?.field === field && low !== undefined && high !== undefined && low < high;
        return announced ? [low, high] : describedRange(dataset, field);
    }

    private text(level: number, range: readonly [number, number] | null): string {
        return range === null ? String(level) : fieldNumber(level, resolutionOf(0, range[1] - range[0]));
    }

    private readonly levelSlid = (event: Event): void => {
        this.model.edits.changeSurface({ level: (event.target as HTMLInputElement).valueAsNumber });
    };
}
