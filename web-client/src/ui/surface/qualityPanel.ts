// Shows how good the surface is, on demand: what was approximated, why particles went no further, what it
// took.
import { css, html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import type { SurfaceStats, Terminations } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { ModelElement } from '../base/signalElement.ts';
import { countWords } from '../base/words.ts';

const reasons: readonly { reason: keyof Terminations; words: string }[] = [
    { reason: 'time', words: 'Reached the end time' },
    { reason: 'domain', words: 'Left the domain' },
    { reason: 'obstacle', words: 'Reached the body' },
    { reason: 'stagnation', words: 'Came to rest' },
    { reason: 'budget', words: 'Stopped by the quad limit' },
];

export interface QualityModel {
    state: Pick<AppState, 'activeSurface' | 'displayed'>;
    worker: Pick<WorkerClient, 'call'>;
}

export class QualityPanel extends ModelElement<QualityModel> {
    private readonly open = signal(false);
    private readonly stats = signal<SurfaceStats | null>(null);
    /** The state that the statistics were last asked for. */
    private requestedState = '';
    private asking = false;

    static override styles = css`
        :host {
            display: contents;
            font-size: 12px;
        }
        details[open] {
            flex: 1 0 100%;
        }
        dl {
            grid-template-columns: 1fr auto;
            gap: 2px 8px;
            margin: 4px 0 0;
            font-size: 12px;
        }
    `;

    override render(): TemplateResult {
        const { state } = this.model;
        const id = state.activeSurface.value ?? '';
        const displayed = state.displayed.value.get(id);
        if (this.open.value && displayed !== undefined) this.ask(id, displayed.stateSum);
        const stats = this.stats.value;
        return html`<details id="quality" @toggle=${(event: Event) => (this.open.value = (event.target as HTMLDetailsElement).open)}>
            <summary class="quiet">Quality</summary>
            ${stats === null || stats.surface !== id ? nothing : this.list(stats)}
        </details>`;
    }

    private list(stats: SurfaceStats): TemplateResult {
        const share = stats.vertices > 0 ? (100 * stats.approximated) / stats.vertices : 0;
        const row = (words: string, value: string, name: string): TemplateResult =>
            html`<dt>${words}</dt>
                <dd data-name=${name}>${value}</dd>`;
        return html`<dl>
            ${row('Approximated vertices', `${share.toFixed(share < 10 ? 1 : 0)} %`, 'approximated')}
            ${stats.error99 === undefined ? nothing : row('Off the true surface, 99 % within', shortNumber(stats.error99), 'error99')}
            ${stats.uncertain === undefined ? nothing : row('Uncertain vertices', countWords(stats.uncertain), 'uncertain')}
            ${stats.torn === undefined ? nothing : row('Torn cells', countWords(stats.torn), 'torn')}
            ${row('Longest edge', `${shortNumber(stats.maxEdge / stats.separation)} × separation`, 'maxEdge')}
            ${reasons
                .filter(({ reason }) => stats.terminated[reason] > 0)
                .map(({ reason, words }) => row(words, countWords(stats.terminated[reason]), reason))}
            ${row('Particle steps', countWords(stats.vertexSteps), 'vertexSteps')}
            ${row('Computed in', `${shortNumber(1000 * (stats.seconds['total'] ?? 0))} ms`, 'seconds')}
            ${row('Memory', `${shortNumber(stats.peakBytes / 2 ** 20)} MiB`, 'peakBytes')}
        </dl>`;
    }

    /** Once a state, and one question at a time: while a surface plays, the next comes with the answer to the
     *  last. */
    private ask(surface: string, stateSum: number): void {
        const wanted = `${surface} ${stateSum}`;
        if (this.asking || this.requestedState === wanted) return;
        this.requestedState = wanted;
        this.asking = true;
        const answered = (stats: SurfaceStats | null): void => {
            this.asking = false;
            this.stats.value = stats;
            // Another state may be there by now.
            if (this.isConnected) this.requestUpdate();
        };
        this.model.worker.call('surface.stats', { surface }).then(answered, () => answered(null));
    }
}

customElements.define('wakesurf-quality', QualityPanel);
