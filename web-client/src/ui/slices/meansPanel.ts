// Means over time: which there are, and a form to make others.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import type { Mean } from '../../protocol/generated/mean.ts';
import type { DatasetDescription } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { Means, MeanWish } from '../../session/means.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { checkRow, typedNumber } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { fieldWords } from '../../session/picture/surfaceOwner.ts';

export interface MeansModel {
    state: Pick<AppState, 'dataset' | 'locked'>;
    means: Pick<Means, 'status' | 'make' | 'remove' | 'cancel'>;
}

const derived = ['vorticity', 'q_criterion'];
const numbers = [
    { id: 'from', words: 'From', hint: 'the first' },
    { id: 'to', words: 'To', hint: 'the last' },
    { id: 'period', words: 'Period', hint: 'none' },
    { id: 'phases', words: 'Phases', hint: 'by itself' },
] as const;

export class MeansPanel extends ModelElement<MeansModel> {
    private readonly chosen = signal<ReadonlySet<string>>(new Set());
    /** Of what was typed last. */
    private readonly refusal = signal('');

    static override styles = css`
        form {
            display: grid;
            grid-template-columns: auto minmax(0, 1fr) auto minmax(0, 1fr);
            gap: 6px;
            align-items: center;
        }
        form input:not([type='checkbox']) {
            min-width: 0;
            width: 100%;
        }
        ul {
            margin: 0 0 8px;
        }
        .all {
            grid-column: 1 / 5;
        }
        li {
            display: grid;
            grid-template-columns: minmax(0, 1fr) auto;
            gap: 6px;
            align-items: center;
            margin-top: 4px;
        }
        li span {
            overflow-wrap: anywhere;
        }
    `;

    override render(): TemplateResult {
        const { state } = this.model;
        const dataset = state.dataset.value;
        const made = dataset?.means ?? [];
        const locked = state.locked.value;
        if (dataset === null) return html``;
        return html`
            ${
                made.length === 0
                    ? nothing
                    : html`<ul aria-label="Means over time">
                          ${made.map((mean) => this.row(mean, locked))}
                      </ul>`
            }
            ${locked ? nothing : this.form(dataset)}
        `;
    }

    private row(mean: Mean, locked: boolean): TemplateResult {
        const words = meanWords(mean);
        const { name } = mean.fields[0]!;
        return html`<li>
            <span>${isolated(words)}</span>
            ${
                locked
                    ? nothing
                    : html`<button type="button" aria-label=${`Remove ${words}`} ?disabled=${this.model.means.status.value?.making === true} @click=${() => void this.model.means.remove(name)}>✕</button>`
            }
        </li>`;
    }

    private form(dataset: DatasetDescription): TemplateResult {
        const { means } = this.model;
        const making = means.status.value?.making === true;
        const chosen = this.chosen.value;
        const choose = (name: string, on: boolean): void => {
            const next = new Set(chosen);
            if (on) next.add(name);
            else next.delete(name);
            this.chosen.value = next;
        };
        return html`<form @submit=${this.submitted}>
            <div class="all" role="group" aria-label="What is averaged">
                ${averaged(dataset).map((name) =>
                    checkRow(fieldWords(name, dataset), chosen.has(name), (on) => choose(name, on), { disabled: making }),
                )}
            </div>
            ${numbers.map(
                ({ id, words, hint }) => html`<label for=${`mean-${id}`}>${words}</label>
                    <input id=${`mean-${id}`} name=${id} inputmode="decimal" placeholder=${hint} ?disabled=${making} />`,
            )}
            <label for="mean-label">Label</label>
            <input id="mean-label" name="label" placeholder="none" maxlength="32" ?disabled=${making} />
            <span></span>
            ${
                making
                    ? html`<button type="button" id="mean-cancel" @click=${() => means.cancel()}>Cancel</button>`
                    : html`<button id="mean-make" ?disabled=${!averaged(dataset).some((name) => chosen.has(name))}>Make</button>`
            }
            <p class="quiet all" role="status">${this.refusal.value || means.status.value?.words}</p>
        </form>`;
    }

    private readonly submitted = (event: Event): void => {
        event.preventDefault();
        const given = new FormData(event.target as HTMLFormElement);
        const offered = new Set(averaged(this.model.state.dataset.value!));
        const wish = wishOf(
            [...this.chosen.value].filter((name) => offered.has(name)),
            (name) => textOf(given.get(name)),
        );
        this.refusal.value = typeof wish === 'string' ? wish : '';
        if (typeof wish !== 'string') void this.model.means.make(wish);
    };
}

function textOf(given: FormDataEntryValue | null): string {
    return typeof given === 'string' ? given : '';
}

/** What was left empty is left to the server. Words: why one is no number. */
export function wishOf(fields: readonly string[], text: (name: string) => string): MeanWish | string {
    const wish: MeanWish = { fields: [...fields] };
    for (const { id } of numbers) {
        const typed = typedNumber(text(id));
        if (typeof typed === 'string') return typed;
        if (typed !== null) wish[id] = typed;
    }
    const label = text('label').trim();
    return label === '' ? wish : { ...wish, label };
}

/** The velocity first; not what was made here. */
function averaged({ fields, velocity, surfaceFields }: DatasetDescription): string[] {
    const scalars = fields.filter(
        ({ components, family, mean, stored }) => components === 1 && !family && !mean && stored !== false,
    );
    return [velocity, ...scalars.map(({ name }) => name), ...derived.filter((name) => surfaceFields.includes(name))];
}

function meanWords({ fields, from, to, steps, period, phases }: Mean): string {
    const over = `${shortNumber(from)} to ${shortNumber(to)}, ${steps} time-steps`;
    const by = period === undefined ? '' : `, ${phases} phases of ${shortNumber(period)}`;
    return `${fields.map(({ name }) => name).join(', ')}: ${over}${by}`;
}

customElements.define('wakesurf-means', MeansPanel);
