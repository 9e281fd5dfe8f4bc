// The probe's place and values in numbers, and the distance that was measured.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { FieldDescription, Vec3 } from '../../protocol/messages.ts';
import { centreOf } from '../../scene/domain/domainAxes.ts';
import { shortNumber, valueNumber } from '../../scene/base/numbers.ts';
import type { FlowScene } from '../../scene/scene.ts';
import { distance, nothingThere, type Probing } from '../../session/tools/pointTools.ts';
import { coordinateField, timeWords, withUnit } from '../../session/picture/writtenNumbers.ts';
import type { PlotOf, ProbeReading, SeenPlace, ViewState } from '../../state/viewState.ts';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from '../base/signalElement.ts';
import { ageName, colourTitle } from '../look/colourNames.ts';
import { vectorFields } from '../base/rows.ts';
import { isolated } from '../../state/announcements.ts';

export interface ProbeModel {
    state: Pick<AppState, 'dataset' | 'surfaces' | 'outcomes'>;
    view: ViewState;
    scene: Pick<FlowScene, 'surfaces'>;
    probing: Pick<Probing, 'probeThere'>;
}

export class ProbePanel extends ModelElement<ProbeModel> {
    static override styles = css`
        .vector {
            display: grid;
            grid-template-columns: repeat(3, 1fr);
            gap: 6px;
        }
        dl,
        p {
            margin: 6px 0;
        }
    `;

    override render(): TemplateResult {
        const { state, view, probing } = this.model;
        const bounds = state.dataset.value?.bounds;
        if (bounds === undefined) return html``;
        const reading = view.probe.value;
        const written = (axis: number, value: number): string => coordinateField(state, axis, value);
        return html`
            <div class="vector" role="group" aria-label="Probe">
                ${vectorFields('Probe', view.probePlace.value ?? centreOf(bounds), written, (point) => {
                    view.tool.value = 'probe';
                    probing.probeThere(point);
                })}
            </div>
            ${
                reading === null
                    ? html`<p class="quiet" id="probe-hint">
                          ${
                              view.probeMissed.value
                                  ? `${nothingThere} Or type where.`
                                  : 'Choose Probe over the picture and point at a surface, the body or a rake, or type where.'
                          }
                      </p>`
                    : this.reading(reading)
            }
            ${reading === null ? nothing : this.plotButton('point', 'Plot over time here')} ${this.measured()}
        `;
    }

    private plotButton(of: PlotOf, words: string): TemplateResult {
        const { view } = this.model;
        return html`<button
            type="button"
            class="plot"
            @click=${() => {
                if (of === 'point') view.probeHeld.value = view.probePlace.value;
                view.plot.value = of;
            }}
        >
            ${words}
        </button>`;
    }

    private reading({ inside, time, values, on }: ProbeReading): TemplateResult {
        if (!inside) {
            return html`<p class="quiet">There is no flow at this point: it is outside the domain or inside the body.</p>`;
        }
        const fields = this.model.state.dataset.value?.fields ?? [];
        return html`<dl id="probe-values">
            ${on === null ? nothing : this.onSurface(on, time)}
            ${values.map(({ name, value }) => {
                const { unit, range } = fields.find((field) => field.name === name) ?? noField;
                return html`<dt>${isolated(name)}${unit === undefined ? '' : ` (${isolated(unit)})`}</dt>
                    <dd data-field=${name}>${valueWords(value, range)}</dd>`;
            })}
            <dt>at</dt>
            <dd>t = ${timeWords(this.model.state, this.model.view, time)}</dd>
        </dl>`;
    }

    /** What is seen there comes first. */
    private onSurface({ surface, s, t, scalar }: SeenPlace, time: number): TemplateResult | typeof nothing {
        const { state, view, scene } = this.model;
        const record = state.surfaces.value.get(surface);
        const span = scene.surfaces.spanOf(surface);
        if (record === undefined || span === null) return nothing;
        const { style, colours } = span;
        const age = style.tIsRelease ? time - t : t;
        const title = colourTitle(style, state.dataset.value, record.kind, view.units.value);
        const shown = style.source === 's' ? s : style.source === 'age' ? age : scalar;
        const error = state.outcomes.value.get(surface)?.error99;
        const isAge = style.source === 'age' || record.kind === 'level';
        return html`${
            style.source === 'constant'
                ? nothing
                : html`<dt>${title}</dt><dd id="probe-colour">${valueWords(shown, colours)}</dd>`
        }
            ${isAge ? nothing : html`<dt>${ageName(record.kind)}</dt><dd>${withUnit(shortNumber(age), record.kind === 'time' ? '' : view.units.value.time)}</dd>`}
            ${
                error === undefined
                    ? nothing
                    : html`<dt>surface within</dt><dd>${withUnit(shortNumber(Number(error.toPrecision(2))), view.units.value.length)}, 99 % of it</dd>`
            }`;
    }

    private measured(): TemplateResult | typeof nothing {
        const { measured } = this.model.view;
        const [a, b] = measured.value;
        if (a === undefined || b === undefined) return nothing;
        const along = b.map((value, i) => shortNumber(value - a[i]!));
        return html`<dl id="measured">
                <dt>Distance</dt>
                <dd>${withUnit(shortNumber(distance(a, b)), this.model.view.units.value.length)}</dd>
                <dt>along x, y, z</dt>
                <dd>${along.join(', ')}</dd>
            </dl>
            ${this.plotButton('line', 'Plot along it')}
            <button type="button" @click=${() => (measured.value = [])}>Clear the measurement</button>`;
    }
}

const noField: Partial<Pick<FieldDescription, 'unit' | 'range'>> = {};

function valueWords(value: number | Vec3 | null, range: FieldDescription['range'] | undefined): string {
    if (value === null) return '–';
    if (typeof value === 'number') return valueNumber(value, range);
    return `${valueNumber(Math.hypot(...value), range)} (${value.map((each) => shortNumber(each)).join(', ')})`;
}

customElements.define('wakesurf-probe', ProbePanel);
