// Shows how the body looks: the field that colours it, lines of equal values, the flow along it.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { BodyFields } from '../../session/picture/bodyFields.ts';
import { canCome, colourByField, colourFields, qCriterion, vorticity } from '../../session/picture/surfaceStyleOf.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { hasBoundary, type Patch, patchId, showsPatch } from '../../state/bodyPatches.ts';
import { toggled } from '../../state/pageView.ts';
import { type BodyLook } from '../../state/bodyLook.ts';
import { colourMaps } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import { fileName } from '../base/copyAndSave.ts';
import { checkRow, type Choice, pairRow, selectRow } from '../base/rows.ts';
import { SavedFile } from '../base/savedFile.ts';
import { ModelElement } from '../base/signalElement.ts';
import { mapNames } from './colourNames.ts';
import { lookStyles } from './lookStyles.ts';

export interface BodyModel {
    state: Pick<AppState, 'dataset'>;
    view: Pick<ViewState, 'body'>;
    bodyFields: Pick<BodyFields, 'file' | 'span' | 'status'>;
}

const kindWords: Record<Patch['kind'], string> = { wall: '', side: ' (in a side)', other: ' (no wall)' };
const place = 'Values are those a quarter of a cell off the body, or a whole one where cells of a grid are in it.';
const shear = ' At a wall at which the fluid rests, vorticity is the shear rate: times the viscosity, the wall shear stress.';
const flowing = ' Where the clock runs, the texture goes with the flow.';

export class BodyPanel extends ModelElement<BodyModel> {
    private readonly saved = new SavedFile();

    static override styles = [
        lookStyles,
        css`
            .patches {
                max-height: 30vh;
                overflow-y: auto;
            }
        `,
    ];

    override render(): TemplateResult {
        const { state, view, bodyFields } = this.model;
        const dataset = state.dataset.value;
        const choices = this.choices();
        const { colourBy } = view.body.value;
        // A look may have been made for other data.
        const isThere = choices.some(({ value }) => value === colourBy);
        const body = { ...view.body.value, colourBy: isThere ? colourBy : 'constant' };
        if (!hasBoundary(dataset)) return html`<p class="quiet">There is no body in this dataset.</p>`;
        const span = bodyFields.span.value;
        return html`
            ${selectRow('body-colour-by', 'Colour the body by', choices, body.colourBy, (by) => this.colourBy(by))}
            ${body.colourBy === 'constant' ? nothing : this.colours(body, span?.colours ?? [0, 1])}
            ${checkRow('Show the flow along the body', body.texture, (texture) => this.change({ texture }), { id: 'body-texture' })}
            ${this.said(body)} ${this.patches(dataset?.patches ?? [])}
            <div class="buttons">
                <button type="button" id="body-save" title="for ParaView, with the values shown" ?disabled=${this.saved.isAwaited} @click=${() => void this.save()}>Save as .vtp</button>
            </div>
            ${this.saved.row()}
        `;
    }

    private patches(patches: readonly Patch[]): TemplateResult | typeof nothing {
        if (patches.length === 0) return nothing;
        const body = this.model.view.body.value;
        const rows = patches.map((patch) => {
            const words = `${isolated(patch.name)}${kindWords[patch.kind]}`;
            const id = patchId(patch);
            const change = (): void => this.change({ patches: [...toggled(new Set(body.patches), id)] });
            return checkRow(words, showsPatch(body, patch), change, { title: `${patch.triangles} triangles` });
        });
        return html`<h3>Patches</h3>
            <div class="patches" role="group" aria-label="Patches">${rows}</div>`;
    }

    private choices(): Choice<string>[] {
        const dataset = this.model.state.dataset.value;
        return [
            { value: 'constant', words: 'Grey' },
            ...colourFields(dataset).map(({ name }) => ({ value: colourByField(name), words: isolated(name) })),
            { value: 'speed', words: 'Speed' },
            ...(canCome(dataset, vorticity) ? [{ value: vorticity, words: 'Vorticity (magnitude)' }] : []),
            ...(canCome(dataset, qCriterion) ? [{ value: qCriterion, words: 'Vortices (Q)' }] : []),
        ];
    }

    private colours(body: BodyLook, range: readonly [number, number]): TemplateResult {
        const maps = colourMaps.map((map) => ({ value: map, words: mapNames[map] }));
        const locked = body.range !== null;
        return html`
            ${selectRow('body-map', 'Colours', maps, this.model.bodyFields.span.value?.map ?? 'viridis', (map) => this.change({ map }))}
            ${pairRow('body-range', 'Range', range, (pair) => this.change({ range: pair }))}
            ${checkRow(locked ? 'Range locked at' : 'Lock the range', locked, (on) => this.change({ range: on ? range : null }), { id: 'body-lock' })}
            ${checkRow('Inverted', body.invert, (invert) => this.change({ invert }), { id: 'body-invert' })}
            ${checkRow('Lines of equal values', body.contours, (contours) => this.change({ contours }), { id: 'body-contours' })}
        `;
    }

    private said(body: BodyLook): TemplateResult | typeof nothing {
        const { span, status } = this.model.bodyFields;
        const none = body.colourBy !== 'constant' && span.value === null ? ' The field has no value there.' : '';
        const words = {
            off: '',
            waiting: 'The values along the body are on their way.',
            shown: `${place}${body.colourBy === vorticity ? shear : ''}${body.texture ? flowing : ''}${none}`,
            failed: 'The server did not send the values along the body at this time.',
        }[status.value];
        return words === '' ? nothing : html`<p class="quiet" role="status">${words}</p>`;
    }

    private save(): Promise<void> {
        const { bodyFields, state } = this.model;
        return this.saved.save(fileName(state.dataset.value?.name, 'body.vtp'), (signal) => bodyFields.file(signal));
    }

    private colourBy(colourBy: string): void {
        this.change({ colourBy, range: null, map: null });
    }

    private change(change: Partial<BodyLook>): void {
        const { view } = this.model;
        view.body.value = { ...view.body.value, ...change };
    }
}

customElements.define('wakesurf-body', BodyPanel);
