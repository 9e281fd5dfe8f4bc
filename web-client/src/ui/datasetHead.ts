// Shows the dataset that is worked on and how large it is; where the server has several, a choice. Opened, another dataset is another
// session, the one in which this browser saw it last or a new one, so that no user is taken away from what they look at; added, it comes
// into this picture, with the rake and surface that the server suggests.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import type { DatasetEntry } from '../protocol/messages.ts';
import type { RecordActions } from '../session/edits/recordActions.ts';
import type { SessionList } from '../session/sessions/sessionList.ts';
import type { AppState } from '../state/appState.ts';
import { ModelElement } from './base/signalElement.ts';
import { countWords } from './base/words.ts';
import { isolated } from '../state/announcements.ts';

export interface DatasetHeadModel {
    state: Pick<AppState, 'dataset' | 'datasets' | 'locked' | 'otherDatasets' | 'role' | 'problems'>;
    edits: { actions: Pick<RecordActions, 'addDataset'> };
    sessionList: Pick<SessionList, 'enterDataset' | 'problems'>;
}

export class DatasetHead extends ModelElement<DatasetHeadModel> {
    /** Not opened yet: the arrow keys go through all of them. */
    private readonly chosen = signal<string | null>(null);

    static override styles = css`
        div {
            display: grid;
            grid-template-columns: auto auto minmax(0, 1fr);
            gap: 6px;
            margin: 4px 0 2px;
        }
        select {
            grid-column: 1 / -1;
            width: 100%;
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
        }
        ${this.others()}`;
    }

    private others(): TemplateResult | typeof nothing {
        const names = [...this.model.state.otherDatasets.value.values()].map(({ name }) => isolated(name));
        return names.length === 0
            ? nothing
            : html`<p class="quiet">Also in this picture: ${names.join(', ')}. Choose something of it to work on it.</p>`;
    }

    private name(shown: string, name: string): TemplateResult | typeof nothing {
        const { datasets, locked, role } = this.model.state;
        const others = datasets.value.filter(({ dataset }) => dataset !== shown);
        // An invitation is to this session.
        if (others.length === 0 || role.value !== 'host') return name === '' ? nothing : html`<p>${name}</p>`;
        const chosen = this.chosen.value ?? shown;
        const usable = datasets.value.some(({ dataset, steps }) => dataset === chosen && steps.ready > 0);
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
            <button
                type="button"
                title=${usable ? 'A rake and a surface of it beside what is here' : 'Open it first: it has to be imported'}
                ?disabled=${chosen === shown || chosen === '' || shown === '' || !usable || locked.value}
                @click=${() => this.add(chosen)}
            >
                Add to this picture
            </button>
        </div>`;
    }

    private async add(dataset: string): Promise<void> {
        await this.model.edits.actions.addDataset(dataset);
        // The choice is what is worked on again.
        this.chosen.value = null;
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
