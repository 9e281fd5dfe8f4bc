// How far the server has come with the surface, in words and numbers; what one could have instead of one that takes long; and how long the
// newest edit took until it was on the screen, and where that time went.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { surfaceSetRanges } from '../../protocol/generated/surface.ts';
import type { SurfaceStats } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { meshIsCoarse } from '../../session/out/exportNames.ts';
import type { MeshDownload } from '../../session/out/meshDownload.ts';
import { withUnit } from '../../session/picture/writtenNumbers.ts';
import { faster, type LessWork, progressWords, type SurfaceProgress, untilHere } from '../../session/surface/surfaceProgress.ts';
import type { AppState, SurfacePhase, Units } from '../../state/appState.ts';
import { type LatencyPart, latencyParts } from '../../state/latency.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { ModelElement } from '../base/signalElement.ts';
import { countWords, phaseWords } from '../base/words.ts';
import { downloadMesh } from '../out/meshExport.ts';

// Nobody needs these before the first picture.
void import('./openedPanels.ts');

export interface StatusModel {
    state: AppState;
    view: Pick<ViewState, 'units'>;
    edits: Pick<Edits, 'changeSurface' | 'intent'>;
    progress: Pick<SurfaceProgress, 'stop'>;
    worker: Pick<WorkerClient, 'call'>;
    mesh: MeshDownload;
}

export class StatusPanel extends ModelElement<StatusModel> {
    static override styles = css`
        :host {
            display: block;
        }
        .problem {
            margin: 8px 0 0;
            color: var(--warm);
        }
        .state {
            position: relative;
            display: flex;
            gap: 8px;
            align-items: center;
            /* Of a button, also without one: nothing that one is about to press may move. */
            min-height: 28px;
        }
        .state span {
            flex: 1;
        }
        .counts,
        .between {
            margin: 0;
        }
        .between {
            /* Of two lines, which it mostly takes: nothing moves when it comes. */
            min-height: 2.8em;
        }
        progress {
            position: absolute;
            inset: auto 0 0;
            width: 100%;
            height: 4px;
        }
        .more {
            display: flex;
            flex-wrap: wrap;
            gap: 0 12px;
            margin-top: 4px;
        }
        .final {
            color: var(--good);
        }
        .coarse,
        .coarsened,
        .doubtful,
        .empty,
        .live,
        .waiting,
        .updating,
        .stopped,
        .error {
            color: var(--warm);
        }
        /* Below the picture, where all scrolls: how far the surface is stays in sight. */
        @media (max-width: 760px) {
            .state {
                position: sticky;
                bottom: 0;
                padding: 2px 16px;
                border-top: 1px solid var(--line);
                background: var(--ground);
            }
            .state ~ * {
                padding-inline: 16px;
            }
        }
    `;

    override render(): TemplateResult {
        const { state, view } = this.model;
        const id = state.activeSurface.value;
        if (id === null) return html``;
        const displayed = state.displayed.value.get(id);
        const phase = state.phase.value;
        const outcome = state.outcomes.value.get(id);
        const trimmed = state.trimmed.value.get(id) ?? 0;
        const count = (value: number | undefined): string => (value === undefined ? '–' : countWords(value));
        const moves = state.surface.value?.kind !== 'stream' && state.dataset.value?.steady === false;
        return html`<div class="state">
                ${this.progress()}
                <span role="status" class=${phase === 'final' && isDoubtful(outcome) ? 'doubtful' : phase}>${displayed === undefined && phase === 'stopped' ? phaseWords.error : statusWords(phase, outcome, view.units.value.length)}</span>
                ${this.stop()}
            </div>
            <p class="counts quiet value">
                ${count(displayed?.cells)} quads${trimmed === 0 ? '' : ` (${countWords(trimmed)} trimmed)`}, ${count(displayed?.vertices)} vertices
            </p>
            ${
                moves
                    ? html`<p class=${isBeyond(outcome) ? 'between value doubtful' : 'between quiet value'} id="between-times">
                          ${phase === 'final' || phase === 'coarsened' ? betweenWords(outcome, view.units.value) : nothing}
                      </p>`
                    : nothing
            }
            ${phase === 'coarsened' ? this.quadLimit() : nothing}
            ${phase === 'empty' ? html`<p class="problem" id="empty-reason">${emptyWords(outcome)}</p>` : nothing}
            <wakesurf-long-pass .model=${this.model}></wakesurf-long-pass>
            <div class="more">
                <wakesurf-quality .model=${this.model}></wakesurf-quality>
                <wakesurf-numbers .model=${this.model}></wakesurf-numbers>
                <wakesurf-latency .model=${this.model}></wakesurf-latency>
            </div>
            ${
                phase === 'error' || phase === 'stopped'
                    ? html`<p class="problem">${state.surfaceErrors.value.get(id)?.text ?? ''}</p>`
                    : nothing
            }
            ${phase === 'stopped' ? this.computeIt(displayed === undefined) : nothing}`;
    }

    private computeIt(first: boolean): TemplateResult {
        if (this.model.state.role.value === 'viewer') {
            return html`<p class="problem">Anyone who can edit can have it computed.</p>`;
        }
        return html`<button type="button" id="compute" @click=${() => this.model.edits.changeSurface({})}>
            ${first ? 'Compute it' : 'Compute it again'}
        </button>`;
    }

    /** Beside what it has done. */
    private quadLimit(): TemplateResult | typeof nothing {
        const { state, edits } = this.model;
        const limit = state.surface.value?.maxQuads;
        const [, most] = surfaceSetRanges.maxQuads;
        if (limit === undefined) return nothing;
        const more = Math.min(4 * limit, most);
        return html`<p class="problem" id="coarsened">
            ${countWords(limit)} quads are too few for the separation asked for.
            ${
                state.locked.value || more === limit
                    ? nothing
                    : html`<button type="button" @click=${() => edits.changeSurface({ maxQuads: more })}>
                      Allow ${countWords(more)}
                  </button>`
            }
        </p>`;
    }

    private progress(): TemplateResult | typeof nothing {
        const now = this.model.state.progress.value;
        return now === null ? nothing : html`<progress max="1" value=${now.fraction ?? nothing} aria-label="Surface"></progress>`;
    }

    private stop(): TemplateResult | typeof nothing {
        const { state, progress } = this.model;
        const may = state.role.value !== 'viewer' && state.capabilities.value.includes('stop');
        return state.progress.value === null || !may
            ? nothing
            : html`<button type="button" @click=${() => progress.stop()}>Stop</button>`;
    }
}

function statusWords(phase: SurfacePhase, outcome: SurfaceStats | undefined, unit: string): string {
    if (phase === 'final' && outcome?.error99 !== undefined) return `${phaseWords.final}, ${errorWords(outcome, unit)}`;
    if (phase !== 'coarsened' || outcome === undefined) return phaseWords[phase];
    return `Coarsened to ${shortNumber(outcome.separation)}: raise the quad limit`;
}

/** With what to do about it. */
function emptyWords(outcome: SurfaceStats | undefined): string {
    if (outcome?.empty === undefined) return '';
    const { message, hint } = outcome.empty;
    return `${message.charAt(0).toUpperCase()}${message.slice(1)}: ${hint}.`;
}

type StatedError = Pick<SurfaceStats, 'error99' | 'uncertain' | 'vertices'>;

/** Returns whether so many vertices are uncertain that the 99th percentile of all would exceed the
 *  separation. */
function isDoubtful(stats: StatedError | undefined): boolean {
    return stats?.uncertain !== undefined && 100 * stats.uncertain > stats.vertices;
}

/** Returns words like "99 % of vertices within 0.004 m, 12 are uncertain". Nothing of a distance where too
 *  many are. */
function errorWords(stats: StatedError, unit: string): string {
    const uncertain = stats.uncertain ?? 0;
    if (isDoubtful(stats)) return `${countWords(uncertain)} of ${countWords(stats.vertices)} vertices uncertain`;
    const within = `99 % of vertices within ${withUnit(shortNumber(Number((stats.error99 ?? 0).toPrecision(2))), unit)}`;
    return uncertain === 0 ? within : `${within}, ${countWords(uncertain)} uncertain`;
}

/** The error between stored times is more than the separation, or not known for much of the surface. */
function isBeyond(stats: SurfaceStats | undefined): boolean {
    return (stats?.intervalError99 ?? 0) > (stats?.separation ?? 0) || (stats?.intervalUnresolved ?? 0) >= 0.1;
}

/** Returns words like "Between stored times: 99 % within 0.4 m; data every 0.1 s would bring it to 0.02 m". */
export function betweenWords(stats: SurfaceStats | undefined, units: Units): string {
    const { intervalError99: error, intervalUnresolved: share = 0, advisedInterval, separation = 0 } = stats ?? {};
    const short = (value: number): string => shortNumber(Number(value.toPrecision(2)));
    if (error === undefined) {
        const why = stats?.intervalPending === true ? 'being estimated' : (stats?.intervalLeftOut ?? '');
        // A frozen field has none, and who froze it knows.
        return why === '' || stats?.kind === 'stream' ? '' : `Between stored times: ${why}`;
    }
    const unresolved = share === 0 ? '' : `, ${share < 0.01 ? 'less than 1' : Math.round(100 * share)} % not resolved`;
    const advice =
        error <= separation || advisedInterval === undefined
            ? ''
            : `; data every ${withUnit(short(advisedInterval), units.time)} would bring it to ${withUnit(short(separation), units.length)}`;
    return `Between stored times: 99 % within ${withUnit(short(error), units.length)}${unresolved}${advice}`;
}

customElements.define('wakesurf-status', StatusPanel);

export interface LongPassModel {
    state: AppState;
    view: Pick<ViewState, 'lookOf' | 'units'>;
    edits: Pick<Edits, 'changeSurface' | 'intent'>;
    mesh: MeshDownload;
}

/** A surface that takes long. */
export class LongPass extends ModelElement<LongPassModel> {
    static override styles = css`
        p {
            margin: 0 0 4px;
        }
        [role='group'] {
            display: flex;
            flex-wrap: wrap;
            gap: 6px;
            margin: 0 0 8px;
        }
    `;

    override render(): TemplateResult {
        const { state, view } = this.model;
        const status = state.progress.value;
        if (status === null || status.lasting === 'briefly') return html``;
        return html`<p class="value" id="standing">${progressWords(status, state, view)}</p>
            ${status.lasting === 'long' ? this.offers() : nothing}`;
    }

    private offers(): TemplateResult {
        const { state, view, edits } = this.model;
        const intent = edits.intent.value;
        const status = state.progress.value;
        const may = intent !== null && status !== null && !state.locked.value;
        const until = may ? untilHere(intent, status, view) : null;
        return html`<p>This takes long. Instead:</p>
            <div role="group" aria-label="Instead of waiting">
                ${may ? faster(intent, view).map((less) => this.less(less, 'Compute a surface that is there sooner')) : nothing}
                ${until === null ? nothing : this.less(until, 'End the surface where the work has come to')}
                ${
                    meshIsCoarse(state)
                        ? html`<button
                              type="button"
                              title="Download the mesh that is shown; the name of the file says that it is coarse"
                              @click=${() => downloadMesh(this.model, true)}
                          >
                              As it is now
                          </button>`
                        : nothing
                }
            </div>`;
    }

    private less({ change, words }: LessWork, title: string): TemplateResult {
        return html`<button type="button" title=${title} @click=${() => this.model.edits.changeSurface(change)}>${words}</button>`;
    }
}

customElements.define('wakesurf-long-pass', LongPass);

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

/** How long the newest edit took until it was on the screen, and where that time went. */
export class LatencyPanel extends ModelElement<LatencyModel> {
    private readonly open = signal(false);

    static override styles = css`
        :host {
            display: contents;
            font-size: 12px;
        }
        details[open] {
            flex: 1 0 100%;
        }
        summary span {
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
