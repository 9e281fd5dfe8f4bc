// What is shown: the dataset and how large it is; where the server has several, a choice. Another dataset is another session,
// so that nobody is taken away from what they look at.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { DatasetEntry } from '../protocol/messages.ts';
import { showFragment, writeFragment } from '../session/view/urlState.ts';
import type { AppModel } from './base/appModel.ts';
import { sharedStyles } from './base/sharedStyles.ts';
import { SignalElement } from './base/signalElement.ts';
import { countWords } from './base/statusWords.ts';

export class DatasetHead extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
            select {
                width: 100%;
                margin: 4px 0 2px;
            }
            p {
                margin: 2px 0 0;
            }
            .quiet {
                color: var(--quiet);
            }
        `,
    ];

    override render(): TemplateResult {
        const dataset = this.model.state.dataset.value;
        return html`${this.name(dataset?.dataset ?? '', dataset?.name ?? '')}
        ${dataset === null
            ? nothing
            : html`<p class="quiet">
                  ${dataset.points > 0 ? `${countWords(dataset.points)} points` : 'a flow by formula'},
                  ${dataset.times.length} ${dataset.times.length === 1 ? 'time-step' : 'time-steps'}
              </p>`}`;
    }

    private name(shown: string, name: string): TemplateResult | typeof nothing {
        const { datasets, role } = this.model.state;
        const others = datasets.value.filter(({ dataset }) => dataset !== shown);
        // Whoever was invited was so to this session.
        if (others.length === 0 || role.value !== 'host') return name === '' ? nothing : html`<p>${name}</p>`;
        return html`<select id="dataset" aria-label="Dataset" @change=${this.open}>
            ${shown === '' ? html`<option value="">Choose a dataset</option>` : nothing}
            ${datasets.value.map(
                (each) => html`<option value=${each.dataset} .selected=${each.dataset === shown}>${optionWords(each, datasets.value)}</option>`,
            )}
        </select>`;
    }

    private open(event: Event): void {
        const dataset = (event.target as HTMLSelectElement).value;
        if (dataset === '') return;
        showFragment(writeFragment(null, dataset));
        location.reload();
    }
}

/** Files of the same name are told apart by what the server calls them. */
function optionWords({ dataset, name }: DatasetEntry, all: readonly DatasetEntry[]): string {
    return all.filter((each) => each.name === name).length > 1 ? `${name} (${dataset})` : name;
}

customElements.define('wakesurf-dataset-head', DatasetHead);
