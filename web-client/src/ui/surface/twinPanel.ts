// What the surface is compared with, particle by particle, and how far the two are apart.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { StatedTwin, SurfaceRecord, Twin, TwinDistance } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import { diagonal } from '../../scene/camera/cameraControls.ts';
import { changeLookWithFields } from '../../session/picture/surfaceFields.ts';
import { twinDistance, twinLag } from '../../session/picture/surfaceStyleOf.ts';
import { withUnit } from '../../session/picture/writtenNumbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { type Choice, selectRow, vectorFields } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { unitOfDuration } from '../look/colourNames.ts';

export interface TwinModel {
    state: AppState;
    view: Pick<ViewState, 'changeLook' | 'lookOf' | 'units'>;
    edits: Pick<Edits, 'actions' | 'changeSurface'>;
}

const nothingElse = 'nothing';
const moved = 'moved';
const other = 'other';

export class TwinPanel extends ModelElement<TwinModel> {
    static override styles = css`
        :host {
            display: block;
        }
        .offset {
            display: grid;
            grid-template-columns: 42px repeat(3, 1fr);
            gap: 6px;
            align-items: center;
            margin-top: 8px;
        }
        p {
            margin: 4px 0 0;
            font-size: 12px;
        }
        table {
            width: 100%;
            margin-top: 4px;
            border-collapse: collapse;
            font-size: 12px;
            text-align: right;
        }
        th {
            font-weight: normal;
        }
        select {
            max-width: 190px;
        }
    `;

    override render(): TemplateResult {
        const record = this.model.state.surface.value;
        if (record === undefined || record.kind === 'level') return html``;
        const { twin } = record;
        const choices = this.choices(record);
        const chosen = valueOf(twin, choices);
        return html`<details id="twin" ?open=${twin !== undefined}>
            <summary class="quiet">Compare</summary>
            ${selectRow(
                'twin-with',
                'Compare with',
                choices.map(({ choice }) => choice),
                chosen,
                (value) => this.compare(record, choices.find(({ choice }) => choice.value === value)?.twin),
            )}
            ${twin?.offset === undefined ? nothing : this.offset(record, twin)}
            ${twin === undefined ? nothing : this.result(record)}
        </details>`;
    }

    private choices({ accuracy, interpolation, between, dataset, kind }: SurfaceRecord): TwinChoice[] {
        const { state } = this.model;
        const stored = state.surfaceDataset.value?.grid !== 'analytic';
        const out: TwinChoice[] = [{ choice: { value: nothingElse, words: 'Nothing' }, twin: undefined }];
        const add = (value: string, words: string, twin: Twin): number => out.push({ choice: { value, words }, twin });
        if (accuracy !== 'exact') add('exact', 'Accuracy exact', { accuracy: 'exact' });
        if (stored && kind !== 'stream' && interpolation === 'linear' && state.surfaceTimes.value.length > 2) {
            for (const each of ['linear', 'cubic', 'flow'] as const) {
                if (each !== between) add(`between ${each}`, `Between stored times: ${each}`, { between: each });
            }
        }
        if (state.surfaceDataset.value?.smooth === true && interpolation === 'linear') {
            add('smooth', 'Interpolation smooth', { interpolation: 'smooth', between: 'linear' });
        }
        add(moved, 'A rake beside it', { offset: this.besides() });
        for (const each of state.datasets.value) {
            if (each.dataset !== dataset) add(`data ${each.dataset}`, isolated(each.name), { dataset: each.dataset });
        }
        return out;
    }

    /** A hundredth of the domain along the axis on which the rake reaches least. */
    private besides(): [number, number, number] {
        const { state } = this.model;
        const points = state.rakePoints.value;
        const reach = [0, 1, 2].map((axis) => {
            const along = points.map((point) => point[axis] ?? 0);
            return Math.max(...along) - Math.min(...along);
        });
        const axis = reach.indexOf(Math.min(...reach));
        const bounds = state.surfaceDataset.value?.bounds;
        const far = bounds === undefined ? 1 : Number((diagonal(bounds) / 100).toPrecision(1));
        return [0, 1, 2].map((each) => (each === axis ? far : 0)) as [number, number, number];
    }

    private offset(record: SurfaceRecord, twin: Twin): TemplateResult {
        const bounds = this.model.state.surfaceDataset.value?.bounds;
        const resolution = bounds === undefined ? 0 : resolutionOf(0, diagonal(bounds));
        return html`<div class="offset" role="group" aria-label="Offset of the rake">
            <span>Offset</span>
            ${vectorFields(
                'Offset along',
                twin.offset ?? [0, 0, 0],
                (_axis, value) => fieldNumber(value, resolution),
                (offset) => this.compare(record, { ...twin, offset: [...offset] }),
            )}
        </div>`;
    }

    private result(record: SurfaceRecord): TemplateResult {
        const outcome = this.model.state.outcomes.value.get(record.surface);
        const stated = outcome?.twin;
        if (stated === undefined) {
            const why = outcome?.intervalPending === true ? 'being compared' : (outcome?.twinLeftOut ?? '');
            return html`<p class="quiet" id="twin-result" role="status">${why === '' ? nothing : `${why[0]!.toUpperCase()}${why.slice(1)}.`}</p>`;
        }
        return html`<p id="twin-result" role="status">${this.words(stated.all)}</p>
            ${stated.ages.length > 1 ? this.ages(stated) : nothing}
            <p>
                <button type="button" @click=${() => this.colour(record, twinDistance)}>Colour by distance</button>
                <button type="button" @click=${() => this.colour(record, twinLag)}>Colour by lag</button>
            </p>`;
    }

    private words({ compared, p50, p90, p99, lag50 }: TwinDistance): string {
        const { state, view } = this.model;
        const { length } = view.units.value;
        const far = [p50, p90, p99].map((value) => short(value));
        const lag =
            lag50 === 0
                ? ''
                : ` It comes ${withUnit(short(Math.abs(lag50)), unitOfDuration(view.units.value, state.surfaceDataset.value))} ${lag50 > 0 ? 'later' : 'earlier'} at the median.`;
        const share = compared < 1 ? ` ${Math.floor(1000 * compared) / 10} % of the particles are there in both.` : '';
        return `Apart: half within ${withUnit(far[0]!, length)}, 90 % within ${withUnit(far[1]!, length)}, 99 % within ${withUnit(far[2]!, length)}.${lag}${share}`;
    }

    private ages({ ages }: StatedTwin): TemplateResult {
        return html`<table>
            <thead>
                <tr>${['to age', '50 %', '90 %', '99 %', 'later by'].map((words) => html`<th scope="col">${words}</th>`)}</tr>
            </thead>
            <tbody>
                ${ages.map(
                    ({ age, p50, p90, p99, lag50 }) =>
                        html`<tr>${[age, p50, p90, p99, lag50].map((value) => html`<td>${short(value)}</td>`)}</tr>`,
                )}
            </tbody>
        </table>`;
    }

    private colour(record: SurfaceRecord, colourBy: string): void {
        changeLookWithFields(this.model, record, { colourBy, range: null });
    }

    private compare({ surface }: SurfaceRecord, twin: Twin | undefined): void {
        void this.model.edits.actions.compare(surface, twin);
    }
}

interface TwinChoice {
    choice: Choice<string>;
    twin: Twin | undefined;
}

function short(value: number): string {
    return shortNumber(Number(value.toPrecision(2)));
}

/** What a script asked for may be several at once, or of a dataset that is not there. */
function valueOf(twin: Twin | undefined, choices: TwinChoice[]): string {
    if (twin?.offset !== undefined && Object.keys(twin).length === 1) return moved;
    const same = choices.find((each) => JSON.stringify(each.twin) === JSON.stringify(twin));
    if (same !== undefined) return same.choice.value;
    choices.push({
        choice: {
            value: other,
            words: Object.entries(twin!)
                .map(([name, value]) => `${name} ${String(value)}`)
                .join(', '),
        },
        twin,
    });
    return other;
}

customElements.define('wakesurf-twin', TwinPanel);
