// The panel at the side: what is shown, how it may be changed, and how far the server has come.
import { css, html, nothing, type TemplateResult } from 'lit';
import { shortNumber } from '../scene/ticks.ts';
import type { AppModel } from './appModel.ts';
import './rakePanel.ts';
import { sharedStyles } from './sharedStyles.ts';
import { SignalElement } from './signalElement.ts';
import { countWords, latencyWords, phaseWords } from './statusWords.ts';
import './surfacePanel.ts';

export class Panel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
            :host {
                display: block;
                overflow-y: auto;
                padding: 14px 16px;
                background: var(--ground);
                border-left: 1px solid var(--line);
            }
            h1 {
                margin: 0;
                font-size: 17px;
                letter-spacing: 0.01em;
            }
            h2 {
                margin: 18px 0 8px;
                padding-top: 12px;
                border-top: 1px solid var(--line);
                font-size: 13px;
                font-weight: 600;
            }
            p {
                margin: 2px 0 0;
            }
            .quiet {
                color: var(--quiet);
            }
            .problem {
                margin-top: 8px;
                color: var(--warm);
            }
            dl {
                display: grid;
                grid-template-columns: auto 1fr;
                gap: 3px 12px;
                margin: 0;
            }
            dt {
                color: var(--quiet);
            }
            dd {
                margin: 0;
                text-align: right;
                font-variant-numeric: tabular-nums;
            }
            .final {
                color: var(--good);
            }
            .coarse,
            .live,
            .waiting,
            .updating,
            .error {
                color: var(--warm);
            }
        `,
    ];

    override render(): TemplateResult {
        const { state } = this.model;
        const dataset = state.dataset.value;
        const none = state.surface.value === undefined;
        return html`
            <h1>wakesurf</h1>
            ${dataset === null
                ? nothing
                : html`<p>${dataset.name}</p>
                      <p class="quiet">
                          ${countWords(dataset.points)} points, ${dataset.times.length}
                          ${dataset.times.length === 1 ? 'time-step' : 'time-steps'}
                      </p>`}
            ${state.role.value === 'viewer'
                ? html`<p class="quiet" id="role">This link is for looking on: it cannot change anything.</p>`
                : nothing}
            <section aria-labelledby="surface-head" ?hidden=${none}>
                <h2 id="surface-head">Surface</h2>
                <wakesurf-surface .model=${this.model}></wakesurf-surface>
            </section>
            <section aria-labelledby="rake-head" ?hidden=${none}>
                <h2 id="rake-head">Rake</h2>
                <wakesurf-rake .model=${this.model}></wakesurf-rake>
            </section>
            <section aria-labelledby="status-head" ?hidden=${none}>
                <h2 id="status-head">Status</h2>
                ${this.status()}
            </section>
        `;
    }

    private status(): TemplateResult {
        const { state } = this.model;
        const id = state.activeSurface.value ?? '';
        const displayed = state.displayed.value.get(id);
        const error = state.surfaceErrors.value.get(id);
        const phase = state.phase.value;
        return html`<dl>
                <dt>Surface</dt>
                <dd class=${phase}><span role="status">${phaseWords[phase]}</span></dd>
                <dt>Quads</dt>
                <dd>${displayed === undefined ? '–' : countWords(displayed.cells)}</dd>
                <dt>Vertices</dt>
                <dd>${displayed === undefined ? '–' : countWords(displayed.vertices)}</dd>
                <dt>Separation</dt>
                <dd>${shortNumber(state.surface.value?.separation ?? Number.NaN)}</dd>
                <dt>Edit to picture</dt>
                <dd>${latencyWords(state.latencyMs.value)}</dd>
            </dl>
            ${phase === 'error' ? html`<p class="problem">${error?.text ?? ''}</p>` : nothing}`;
    }
}

customElements.define('wakesurf-panel', Panel);
