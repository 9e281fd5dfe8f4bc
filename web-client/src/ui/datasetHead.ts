// Shows the dataset and how large it is; where the server has several, a choice. Another dataset is another
// session, the one in which this browser saw it last or a new one, so that no user is taken away from what
// they look at.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import type { DatasetEntry } from '../protocol/messages.ts';
import type { SessionList } from '../session/sessions/sessionList.ts';
import type { AppState } from '../state/appState.ts';
import { ModelElement } from './base/signalElement.ts';
import { countWords } from './base/words.ts';
import { isolated } from '../state/announcements.ts';

export interface DatasetHeadModel {
    state: Pick<AppState, 'dataset' | 'datasets' | 'role' | 'problems'>;
    sessionList: Pick<SessionList, 'enterDataset' | 'problems'>;
}

export class DatasetHead extends ModelElement<DatasetHeadModel> {
    /** Not opened yet: the arrow keys go through all of them. */
    private readonly chosen = signal<string | null>(null);

    static override styles = css`
        div {
            display: flex;
            gap: 6px;
            margin: 4px 0 2px;
        }
        select {
            flex: 1;
            min-width: 0;
        }
        p {
            margin: 2px 0 0;
            overflow-wrap: anywhere; /* names of folders have no blanks */
        }
    `;

    override render(): TemplateResult {
        const dataset = this.model.state.dataset.value;
        return html`${this.name(dataset?.dataset ?? '', dataset?.name ?? '')}
        ${
            dataset === null
                ? nothing
                : html`<p class="quiet">
                  ${dataset.points > 0 ? `${countWords(dataset.points)} points` : 'an analytic flow'},
                  ${dataset.times.length} ${dataset.times.length === 1 ? 'time-step' : 'time-steps'}${
                      dataset.steady && dataset.points > 0 ? ': the flow stands still' : ''
                  }
              </p>`
        }`;
    }

    private name(shown: string, name: string): TemplateResult | typeof nothing {
        const { datasets, role } = this.model.state;
        const others = datasets.value.filter(({ dataset }) => dataset !== shown);
        // An invitation is to this session.
        if (others.length === 0 || role.value !== 'host') return name === '' ? nothing : html`<p>${name}</p>`;
        const chosen = this.chosen.value ?? shown;
        return html`<div>
            <select id="dataset" aria-label="Dataset" @change=${this.choose}>
                ${shown === '' ? html`<option value="">Choose a dataset</option>` : nothing}
                ${datasets.value.map(
                    (each) =>
                        html`<option value=${each.dataset} .selected=${each.dataset === chosen}>${optionWords(each, datasets.value)}</option>`,
                )}
            </select>
            <button type="button" ?disabled=${chosen === shown || chosen === ''} @click=${() => this.open(chosen)}>
                Open
            </button>
        </div>`;
    }

    /** A notice, because the list, which says what is refused, may be closed. */
    private async open(dataset: string): Promise<void> {
        const { sessionList, state } = this.model;
        const name = state.datasets.value.find((each) => each.dataset === dataset)?.name ?? dataset;
        await sessionList.enterDataset(dataset, name);
        const refused = sessionList.problems.all.value.get('action');
        if (refused !== undefined) state.problems.say('session.create', refused);
    }

    private choose(event: Event): void {
        this.chosen.value = (event.target as HTMLSelectElement).value;
    }
}

/** Files of the same name are told apart by what the server calls them; and how much there is, before it is
 *  opened. */
function optionWords({ dataset, name, steps, state }: DatasetEntry, all: readonly DatasetEntry[]): string {
    const which = all.filter((each) => each.name === name).length > 1 ? [dataset] : [];
    const times = steps.total > 1 ? [`${steps.total} time-steps`] : [];
    const about = [...which, ...times, ...(state === 'ready' ? [] : [state])];
    return about.length === 0 ? isolated(name) : `${isolated(name)} (${about.join(', ')})`;
}

customElements.define('wakesurf-dataset-head', DatasetHead);
