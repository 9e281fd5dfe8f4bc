// Shows numbers of the surface, on demand: its area, what flows through it, and how old it is where it meets a plane or a box; each with its
// errors. The server computes them once the surface is complete, and has them over time as a file.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { shortNumber } from '../../scene/base/numbers.ts';
import { LateWaits } from '../../session/base/lateWaits.ts';
import type { MeshDownload } from '../../session/out/meshDownload.ts';
import { withUnit } from '../../session/picture/writtenNumbers.ts';
import { averagedFields, type NumberTable, readNumbers } from '../../session/surface/numberTable.ts';
import type { AppState } from '../../state/appState.ts';
import { fileName } from '../base/copyAndSave.ts';
import { lateRow } from '../base/lateRow.ts';
import { SavedFile } from '../base/savedFile.ts';
import { ModelElement } from '../base/signalElement.ts';

/** Rows of the file over time. */
const intervals = 50;

const shown: readonly { name: string; words: string; error?: string }[] = [
    { name: 'area', words: 'Area', error: 'area' },
    { name: 'flux', words: 'Flux through it', error: 'flux' },
    { name: 'tube_flux', words: 'Flux through the tube', error: 'tube_flux' },
    { name: 'tube_flux_lost_by_tracing', words: '… lost by tracing', error: 'tube_flux_lost_by_tracing' },
    {
        name: 'tube_flux_gained_by_divergence',
        words: '… gained, divergence of the data',
        error: 'tube_flux_gained_by_divergence',
    },
    { name: 'cut_length', words: 'Length of the cut' },
    { name: 'age_least', words: 'Least age there', error: 'age' },
    { name: 'age_median', words: 'Median age there', error: 'age' },
    { name: 'age_p90', words: '90 % are younger than', error: 'age' },
    { name: 'section_flux', words: 'Flux through the section', error: 'section_flux' },
    { name: 'inside_area', words: 'Area inside', error: 'inside_area' },
    { name: 'residence_median', words: 'Median time of stay', error: 'residence' },
    { name: 'residence_p90', words: '90 % stay no longer than', error: 'residence' },
    { name: 'entered', words: 'Share of the rake that enters' },
    { name: 'still_inside', words: 'Share of these still inside' },
];

export interface NumbersModel {
    state: Pick<AppState, 'activeSurface' | 'dataset' | 'displayed' | 'phase' | 'session' | 'surface'>;
    mesh: Pick<MeshDownload, 'numbers'>;
}

export class NumbersPanel extends ModelElement<NumbersModel> {
    private readonly open = signal(false);
    private readonly through = signal('');
    private readonly found = signal<{ of: string; table: NumberTable | null; fault: string } | null>(null);
    private readonly late = signal(false);
    private readonly waits = new LateWaits((late) => (this.late.value = late));
    private readonly saved = new SavedFile();
    private asked = '';
    private request: AbortController | null = null;

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
            margin: 4px 0;
            font-size: 12px;
        }
        input {
            width: 100%;
            box-sizing: border-box;
        }
        .problem {
            color: var(--warm);
        }
    `;

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.request?.abort();
        this.asked = '';
    }

    override render(): TemplateResult {
        const { state } = this.model;
        const id = state.activeSurface.value ?? '';
        const displayed = state.displayed.value.get(id);
        const complete = state.phase.value === 'final' || state.phase.value === 'coarsened';
        const of = `${id} ${displayed?.stateSum ?? ''} ${JSON.stringify(this.query())}`;
        if (this.open.value && complete && displayed !== undefined) this.ask(id, of);
        return html`<details id="numbers" @toggle=${(event: Event) => (this.open.value = (event.target as HTMLDetailsElement).open)}>
            <summary class="quiet">Numbers</summary>
            ${this.open.value ? this.contents(of, complete) : nothing}
        </details>`;
    }

    private contents(of: string, complete: boolean): TemplateResult {
        const found = this.found.value;
        const now = found?.of === of ? found : null;
        return html`<label
                >Through
                <input
                    type="text"
                    id="through"
                    placeholder="plane:0,0,0:1,0,0 or box:0,0,0:1,1,1"
                    .value=${this.through.value}
                    @change=${(event: Event) => (this.through.value = (event.target as HTMLInputElement).value.trim())}
            /></label>
            ${now === null ? html`<p class="quiet">${complete ? 'Being computed …' : 'Once the surface is complete.'}</p>` : nothing}
            ${now === null ? lateRow(this.late.value, () => this.waits.again()) : nothing}
            ${now?.fault ? html`<p class="problem" role="alert">${now.fault}</p>` : nothing}
            ${now?.table ? list(now.table, this.model.state.dataset.value?.velocity) : nothing}
            <button type="button" ?disabled=${!complete || this.saved.isAwaited} @click=${() => this.save()}>CSV over time</button>
            ${this.saved.row()}`;
    }

    /** Once a state and a place; a newer question ends the one before. */
    private ask(surface: string, of: string): void {
        if (this.asked === of) return;
        this.asked = of;
        this.request?.abort();
        const request = new AbortController();
        this.request = request;
        const answered = (table: NumberTable | null, fault: string): void => {
            if (!request.signal.aborted) this.found.value = { of, table, fault };
        };
        const { mesh, state } = this.model;
        const query = this.query();
        const numbers = (stop: AbortSignal): ReturnType<MeshDownload['numbers']> =>
            mesh.numbers(state.session.value ?? '', surface, query, stop);
        this.waits.until(numbers, request.signal).then(
            ({ text, fault }) => answered(text === null ? null : readNumbers(text), fault),
            () => answered(null, ''),
        );
    }

    private query(): Record<string, string> {
        const { dataset, surface } = this.model.state;
        const fields = surface.value === undefined ? [] : averagedFields(dataset.value, surface.value);
        return {
            ...(fields.length === 0 ? {} : { fields: fields.join('\n') }),
            ...(this.through.value === '' ? {} : { through: this.through.value }),
        };
    }

    private async save(): Promise<void> {
        const { state, mesh } = this.model;
        const { activeSurface, session, surface, dataset } = state;
        if (activeSurface.value === null || session.value === null || surface.value === undefined) return;
        const { from, to, kind } = surface.value;
        const every = Math.abs(to - from) / intervals;
        const query = this.query();
        if (every > 0) query['times'] = `${from}:${to}:${every}`;
        const [of, id] = [session.value, activeSurface.value];
        await this.saved.save(fileName(dataset.value?.name, `${kind}-numbers.csv`), async (signal) => {
            const { text, fault } = await mesh.numbers(of, id, query, signal);
            if (text !== null) return new Blob([text], { type: 'text/csv' });
            if (!signal.aborted && this.found.value !== null) this.found.value = { ...this.found.value, fault };
            return null;
        });
    }
}

/** "Mean speed", "Mean of p", "Mean of p inside". */
function means({ units }: NumberTable, velocity: string | undefined): { name: string; words: string; error?: string }[] {
    return [...units.keys()].flatMap((name) => {
        const found = /^(inside_)?mean_(.*)$/s.exec(name);
        return found === null
            ? []
            : [
                  {
                      name,
                      words: `Mean ${found[2] === velocity ? 'speed' : `of ${found[2]}`}${found[1] === undefined ? '' : ' inside'}`,
                  },
              ];
    });
}

/** The last row: "3.21 ± 0.02 m^2", and what the stored times add to that. */
function list(table: NumberTable, velocity: string | undefined): TemplateResult {
    const row = table.rows.at(-1) ?? new Map<string, number>();
    const note = table.notes.at(-1) ?? '';
    const value = (name: string, error?: string): string => {
        const off = row.get(`${error}_error`);
        const between = row.get(`${error}_interval_error`);
        const unit = table.units.get(name) ?? '';
        const rounded = (one: number): string => shortNumber(Number(one.toPrecision(2)));
        const own = off === undefined || Number.isNaN(off) ? '' : ` ± ${rounded(off)}`;
        const stored = between === undefined || Number.isNaN(between) ? '' : ` ± ${rounded(between)} (stored times)`;
        return withUnit(`${shortNumber(row.get(name) ?? Number.NaN)}${own}${stored}`, unit);
    };
    return html`<dl>
            ${[...shown, ...means(table, velocity)]
                .filter(({ name }) => Number.isFinite(row.get(name)))
                .map(
                    ({ name, words, error }) =>
                        html`<dt>${words}</dt>
                            <dd data-name=${name}>${value(name, error)}</dd>`,
                )}
        </dl>
        ${note === '' ? nothing : html`<p class="quiet" id="numbers-notes">${note}</p>`}`;
}

customElements.define('wakesurf-numbers', NumbersPanel);
