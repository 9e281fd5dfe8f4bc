// The plot below the picture: what it is of, its quantities with their values under the pointer, its lines or its table, and its files.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { shortNumber } from '../../scene/base/numbers.ts';
import { centreOf } from '../../scene/domain/domainAxes.ts';
import type { Vec3 } from '../../protocol/messages.ts';
import { timeInName } from '../../session/out/exportNames.ts';
import { coordinateField, withUnit } from '../../session/picture/writtenNumbers.ts';
import { columnsOf, type Plot, titleOf } from '../../session/plots/plot.ts';
import { lineColours } from '../../session/plots/plotAxes.ts';
import { plotCsv } from '../../session/plots/plotCsv.ts';
import { plotSvg } from '../../session/plots/plotSvg.ts';
import { mostSeries, Plots, type PlotsOptions } from '../../session/plots/plots.ts';
import type { Quantity } from '../../session/plots/quantities.ts';
import type { Playback } from '../../session/time/playback.ts';
import { isolated } from '../../state/announcements.ts';
import type { PlotOf } from '../../state/viewState.ts';
import { fileName, saveFile } from '../base/copyAndSave.ts';
import { lateRow } from '../base/lateRow.ts';
import { vectorFields } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import './plotChart.ts';
import type { PlotChosen, PlotPointed } from './plotChart.ts';

/** Loaded with the dock. */
export { Plots };

export interface PlotDockModel {
    state: PlotsOptions['state'];
    view: PlotsOptions['view'];
    plots: Plots;
    playback: Pick<Playback, 'goTo' | 'mode'>;
}

const kinds: readonly { of: PlotOf; words: string; file: string }[] = [
    { of: 'rake', words: 'Along the rake', file: 'rake' },
    { of: 'line', words: 'Along a line', file: 'line' },
    { of: 'point', words: 'Over time at a point', file: 'history' },
    { of: 'surface', words: 'Of the surface over time', file: 'surface' },
];

export class PlotDock extends ModelElement<PlotDockModel> {
    private readonly pointed = signal<number | null>(null);
    private readonly asTable = signal(false);

    static override styles = css`
        :host {
            display: grid;
            grid-template: auto auto minmax(0, 1fr) / minmax(0, 1fr);
            height: 264px;
            padding: 6px 10px 4px;
            background: var(--ground);
            border-top: 1px solid var(--line);
        }
        .head,
        .place {
            display: flex;
            align-items: center;
            gap: 6px;
        }
        .place {
            margin-top: 6px;
        }
        .place input {
            width: 74px;
        }
        .place .to {
            margin-left: 6px;
        }
        .quantities {
            display: flex;
            flex: 1;
            gap: 4px;
            min-width: 0;
            overflow-x: auto;
            scrollbar-width: thin;
        }
        .quantities label {
            /* Holds its box, which would lie over what is beside the list where that is scrolled. */
            position: relative;
            display: flex;
            flex: none;
            align-items: center;
            gap: 6px;
            min-height: 28px;
            padding: 2px 9px;
            border: 1px solid var(--line);
            border-radius: 14px;
            color: var(--quiet);
            white-space: nowrap;
            cursor: pointer;
        }
        .quantities label:has(:checked) {
            background: var(--raised);
            color: var(--text);
        }
        .quantities label:has(:focus-visible) {
            outline: 2px solid var(--accent);
            outline-offset: -2px;
        }
        .quantities input {
            position: absolute;
            opacity: 0;
            width: 1px;
            margin: 0;
        }
        .dash {
            width: 14px;
            height: 3px;
            border-radius: 2px;
            background: var(--line);
        }
        .value {
            min-width: 5ch;
        }
        [aria-pressed='true'] {
            border-color: var(--accent);
            color: var(--accent);
        }
        .body {
            position: relative;
            min-height: 0;
            margin-top: 4px;
        }
        wakesurf-plot-chart {
            width: 100%;
            height: 100%;
        }
        .notes {
            position: absolute;
            left: 80px;
            top: 12px;
            margin: 0;
            padding: 1px 8px;
            border-radius: 6px;
            background: var(--raised);
            pointer-events: none;
        }
        .at {
            position: absolute;
            right: 20px;
            top: 12px;
            margin: 0;
            padding: 1px 8px;
            border-radius: 6px;
            background: var(--raised);
            pointer-events: none;
        }
        .fault {
            display: grid;
            place-content: center;
            height: 100%;
            margin: 0;
            text-align: center;
        }
        progress {
            position: absolute;
            right: 0;
            top: 0;
            width: 90px;
        }
        .table {
            height: 100%;
            overflow: auto;
        }
        table {
            border-collapse: collapse;
            font-variant-numeric: tabular-nums;
        }
        th,
        td {
            padding: 2px 12px;
            text-align: right;
            white-space: nowrap;
        }
        th {
            position: sticky;
            top: 0;
            background: var(--ground);
            font-weight: 600;
        }
        tr:nth-child(even) td {
            background: var(--raised);
        }
        @media (max-width: 760px) {
            :host {
                height: 274px;
            }
            .head {
                flex-wrap: wrap;
            }
            .quantities {
                order: 1;
                flex-basis: 100%;
            }
            .head select {
                flex: 1 1 0;
                min-width: 0;
            }
            .head button {
                padding-inline: 6px;
            }
            .place {
                display: grid;
                grid-template-columns: auto repeat(3, minmax(0, 1fr));
                gap: 4px 6px;
            }
            .place input {
                width: 100%;
            }
            .place .to {
                margin: 0;
            }
        }
    `;

    override render(): TemplateResult {
        const { view, plots } = this.model;
        const of = view.plot.value;
        if (of === null) return html``;
        const plot = plots.plot.value;
        return html`<div class="head">
                <select
                    id="plot-of"
                    aria-label="Plot"
                    @change=${(event: Event) => (view.plot.value = (event.target as HTMLSelectElement).value as PlotOf)}
                >
                    ${kinds.map((each) => html`<option value=${each.of} .selected=${each.of === of}>${each.words}</option>`)}
                </select>
                <div class="quantities" role="group" aria-label="Quantities">${this.quantities(plot)}</div>
                <button
                    type="button"
                    aria-pressed=${this.asTable.value ? 'true' : 'false'}
                    ?disabled=${plot === null}
                    @click=${() => (this.asTable.value = !this.asTable.value)}
                >
                    Table
                </button>
                <button type="button" title="Save the numbers" ?disabled=${plot === null} @click=${() => this.save('csv')}>CSV</button>
                <button type="button" title="Save the plot as a picture of lines" ?disabled=${plot === null} @click=${() => this.save('svg')}>
                    SVG
                </button>
                <button type="button" aria-label="Close the plot" @click=${() => plots.close()}>✕</button>
            </div>
            <div>${this.place(of)} ${lateRow(plots.late.value, () => plots.retry())}</div>
            <div class="body">${plot === null ? html`<p class="quiet fault" role="status">${plots.fault.value}</p>` : this.body(plot)}</div>`;
    }

    private quantities(plot: Plot | null): TemplateResult[] {
        const { plots } = this.model;
        const drawn = plots.drawn.value.map(({ name }) => name);
        const full = drawn.length >= mostSeries;
        return plots.quantities.value.map(({ name, unit }: Quantity) => {
            const index = drawn.indexOf(name);
            const at = this.pointed.value;
            const value = at === null || index < 0 ? undefined : plot?.series.find((each) => each.name === name)?.values[at];
            const words = name.replaceAll('_', ' ');
            return html`<label title=${titleOf({ name, unit })}
                ><input
                    type="checkbox"
                    name="quantity"
                    value=${name}
                    .checked=${index >= 0}
                    ?disabled=${index < 0 ? full : drawn.length === 1}
                    @change=${(event: Event) => plots.choose(name, (event.target as HTMLInputElement).checked)}
                /><span class="dash" data-line=${index < 0 ? nothing : index}></span>${isolated(words)}${
                    value === undefined ? nothing : html` <span class="value">${numberWords(value, unit)}</span>`
                }</label
            >`;
        });
    }

    private place(of: PlotOf): TemplateResult {
        const { state, view } = this.model;
        const written = (axis: number, value: number): string => coordinateField(state, axis, value);
        const bounds = state.dataset.value?.bounds;
        if (bounds === undefined || (of !== 'line' && of !== 'point')) return html`<div></div>`;
        if (of === 'point') {
            return html`<div class="place" role="group" aria-label="Point">
                <span class="quiet">At</span> ${vectorFields(
                    'Point',
                    view.probeHeld.value ?? centreOf(bounds),
                    written,
                    (point) => {
                        view.probeHeld.value = point;
                    },
                )}
            </div>`;
        }
        const centre = centreOf(bounds);
        const [a = centre, b = a] = view.measured.value;
        const moved = (ends: readonly Vec3[]): void => void (view.measured.value = ends);
        return html`<div class="place" role="group" aria-label="Line">
            <span class="quiet">From</span> ${vectorFields('From', a, written, (point) => moved([point, b]))}
            <span class="quiet to">to</span> ${vectorFields('To', b, written, (point) => moved([a, point]))}
        </div>`;
    }

    private body(plot: Plot): TemplateResult {
        const { plots, state, playback } = this.model;
        if (this.asTable.value) return table(plot);
        const now = plots.clock;
        const choosable = now !== null && !state.locked.value && playback.mode.value !== 'none';
        const progress = plots.progress.value;
        return html`<wakesurf-plot-chart
                role="img"
                aria-label=${`${plot.title}: ${plot.series.map(({ name }) => name).join(', ')}. The table has the numbers.`}
                title=${choosable ? 'A click sets the clock; dragging across enlarges, a double click shows all' : 'Dragging across enlarges, a double click shows all'}
                .plot=${plot}
                .now=${now}
                .choosable=${choosable}
                @plot-pointed=${({ detail }: PlotPointed) => this.point(detail)}
                @plot-chosen=${({ detail }: PlotChosen) => playback.goTo(detail)}
            ></wakesurf-plot-chart>
            ${this.at(plot)} ${progress === null ? nothing : html`<progress aria-label="Sampled" max="1" .value=${progress}></progress>`}
            ${plot.notes.length === 0 ? nothing : html`<p class="quiet notes" role="status">${plot.notes.join(' ')}</p>`}`;
    }

    private point(index: number | null): void {
        this.pointed.value = index;
        this.model.plots.point(index);
    }

    private at({ x }: Plot): TemplateResult | typeof nothing {
        const value = x.values[this.pointed.value ?? -1];
        if (value === undefined) return nothing;
        return html`<p class="quiet at value">${x.name} ${numberWords(value, x.unit)}</p>`;
    }

    private save(kind: 'csv' | 'svg'): void {
        const { plots, state, view } = this.model;
        const plot = plots.plot.value;
        const chosen = kinds.find(({ of }) => of === view.plot.value);
        if (plot === null || chosen === undefined) return;
        const time = plot.places.find(({ name }) => name === 'time')?.values[0];
        const of = time === undefined ? chosen.file : `${chosen.file}-${timeInName(time)}`;
        const content = kind === 'csv' ? plotCsv(plot) : plotSvg(plot);
        const type = kind === 'csv' ? 'text/csv' : 'image/svg+xml';
        saveFile(new Blob([content], { type }), fileName(state.dataset.value?.name, `${of}.${kind}`));
    }

    protected override updated(): void {
        // Through the object model: the content security policy forbids style attributes.
        for (const dash of this.renderRoot.querySelectorAll<HTMLElement>('.dash')) {
            const index = dash.dataset['line'];
            dash.style.background = index === undefined ? '' : lineColours[Number(index) % lineColours.length]!;
        }
    }
}

function numberWords(value: number, unit: string): string {
    return Number.isNaN(value) ? '–' : withUnit(shortNumber(value), unit);
}

function table(plot: Plot): TemplateResult {
    const columns = columnsOf(plot);
    return html`<div class="table" tabindex="0" role="region" aria-label=${plot.title}>
        <table>
            <thead>
                <tr>
                    ${columns.map((column) => html`<th scope="col">${titleOf(column)}</th>`)}
                </tr>
            </thead>
            <tbody>
                ${plot.x.values.map(
                    (_, i) => html`<tr>
                        ${columns.map(({ values }) => html`<td>${numberWords(values[i]!, '')}</td>`)}
                    </tr>`,
                )}
            </tbody>
        </table>
    </div>`;
}

customElements.define('wakesurf-plot-dock', PlotDock);
