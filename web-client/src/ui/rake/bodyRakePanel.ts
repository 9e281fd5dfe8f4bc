// A rake that stands off a body: how far, along what is clicked, a sharp edge or the outline of a patch.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { fieldNumber, resolutionOf } from '../../scene/base/numbers.ts';
import { BodyRakes } from '../../session/tools/bodyRakes.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { type Patch, patchId } from '../../state/bodyPatches.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, numberRow, selectRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

/** Loaded with the panel, after the first picture. */
export { BodyRakes };

export interface BodyRakesModel {
    state: Pick<AppState, 'dataset'>;
    view: Pick<ViewState, 'bodyWay' | 'tool'>;
    bodyRakes: BodyRakes;
}

export class BodyRakePanel extends ModelElement<BodyRakesModel> {
    private readonly patch = signal('');
    private readonly refused = signal('');

    static override styles = css`
        .buttons {
            display: flex;
            gap: 6px;
            margin-block: 8px;
        }
        .buttons button {
            flex: 1;
        }
    `;

    override render(): TemplateResult {
        const { state, view, bodyRakes } = this.model;
        const dataset = state.dataset.value;
        if (dataset === null) return html``;
        const { clicked } = view.bodyWay.value;
        const off = bodyRakes.off.value;
        const [least, most] = bodyRakes.offSpan.value;
        const alongEdge = bodyRakes.alongEdge.value;
        const ask = alongEdge ? 'Click a sharp edge of a body.' : 'Click points on a body, one after the other.';
        const told = alongEdge ? 'The edge is followed.' : `${clicked.length} of its points are set.`;
        return html`
            ${numberRow('Off the body by', {
                ...{ id: 'body-rake-off', min: least, max: most, shown: fieldNumber(off, resolutionOf(0, off)) },
                change: (value) => void (bodyRakes.typedOff.value = value),
            })}
            ${checkRow('Follow a sharp edge', alongEdge, (on) => (bodyRakes.alongEdge.value = on), { id: 'body-rake-edge' })}
            <p class="quiet" role="status" id="body-rake-told">${clicked.length === 0 ? ask : told}</p>
            <div class="buttons">
                <button type="button" id="body-rake-end" title="Or press Enter" ?disabled=${!bodyRakes.canEnd} @click=${() => void bodyRakes.end()}>${alongEdge ? 'Make the rake' : 'End the line'}</button>
                <button type="button" id="body-rake-cancel" title="Or press Esc" @click=${() => (view.tool.value = 'none')}>Cancel</button>
            </div>
            ${this.outline(dataset.patches ?? [])}
        `;
    }

    private outline(patches: readonly Patch[]): TemplateResult | typeof nothing {
        if (patches.length === 0) return nothing;
        const chosen = patches.find((each) => patchId(each) === this.patch.value) ?? patches[0]!;
        const choices = patches.map((each) => ({ value: patchId(each), words: isolated(each.name) }));
        return html`
            ${selectRow('body-rake-patch', 'Or a patch', choices, patchId(chosen), (id) => {
                this.patch.value = id;
                this.refused.value = '';
            })}
            <div class="buttons">
                <button type="button" id="body-rake-outline" ?disabled=${!this.model.bodyRakes.canMake.value} @click=${() => (this.refused.value = this.model.bodyRakes.outline(chosen) ?? '')}>
                    Rake along its outline
                </button>
            </div>
            ${this.refused.value === '' ? nothing : html`<p class="quiet" role="status">${this.refused.value}</p>`}
        `;
    }
}

customElements.define('wakesurf-body-rake', BodyRakePanel);
