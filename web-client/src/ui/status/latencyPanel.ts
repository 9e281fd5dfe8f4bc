// Shows how long the newest edit took until it was on the screen, and where that time went.
import { css, html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import { type LatencyPart, latencyParts } from '../../state/latency.ts';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from '../base/signalElement.ts';

const partWords: Record<LatencyPart, string> = {
    network: 'Network round trip',
    queue: 'Waiting in the queue',
    load: 'Reading the data',
    compute: 'Computing',
    encode: 'Encoding',
    decode: 'Decoding',
    draw: 'Drawing',
    rest: 'Waiting for frames',
};

export interface LatencyModel {
    state: Pick<AppState, 'latency' | 'roundTripMs'>;
}

export class LatencyPanel extends ModelElement<LatencyModel> {
    private readonly open = signal(false);

    static override styles = css`
        :host {
            display: block;
        }
        summary span {
            float: right;
            color: var(--text);
        }
        dl {
            grid-template-columns: 1fr 70px auto;
            gap: 2px 8px;
            align-items: center;
            margin: 4px 0 0;
            font-size: 12px;
        }
        summary {
            font-variant-numeric: tabular-nums;
        }
        meter {
            width: 100%;
            height: 10px;
        }
    `;

    override render(): TemplateResult {
        const sample = this.model.state.latency.value;
        const roundTrip = this.model.state.roundTripMs.value;
        return html`<details id="latency" @toggle=${(event: Event) => (this.open.value = (event.target as HTMLDetailsElement).open)}>
            <summary class="quiet">
                Edit to picture
                <span id="latency-total">${sample === null ? '–' : `${Math.round(sample.milliseconds)} ms`}</span>
            </summary>
            <dl>
                ${
                    !this.open.value
                        ? nothing
                        : sample === null
                          ? html`<dt>There and back</dt>
                          <dd></dd>
                          <dd>${roundTrip === null ? '–' : words(roundTrip)}</dd>`
                          : latencyParts.map(
                                (part) => html`<dt>${partWords[part]}</dt>
                              <dd>
                                  <meter
                                      aria-label=${partWords[part]}
                                      max=${sample.milliseconds}
                                      .value=${sample.parts[part]}
                                  ></meter>
                              </dd>
                              <dd data-part=${part}>${words(sample.parts[part])}</dd>`,
                            )
                }
            </dl>
        </details>`;
    }
}

function words(milliseconds: number): string {
    return `${milliseconds < 10 ? milliseconds.toFixed(1) : Math.round(milliseconds)} ms`;
}

customElements.define('wakesurf-latency', LatencyPanel);
