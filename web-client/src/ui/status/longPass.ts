// A surface that takes long: how far it is, and what one could have instead.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { Edits } from '../../session/edits/edits.ts';
import { meshIsCoarse } from '../../session/out/exportNames.ts';
import type { MeshDownload } from '../../session/out/meshDownload.ts';
import { faster, type LessWork, standingWords, untilHere } from '../../session/surface/surfaceProgress.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement } from '../base/signalElement.ts';
import { downloadMesh } from '../out/meshExport.ts';

export interface LongPassModel {
    state: AppState;
    view: Pick<ViewState, 'lookOf' | 'units'>;
    edits: Pick<Edits, 'changeSurface' | 'intent'>;
    mesh: MeshDownload;
}

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
        const standing = state.progress.value;
        if (standing === null || standing.lasting === 'briefly') return html``;
        return html`<p class="value" id="standing">${standingWords(standing, state, view)}</p>
            ${standing.lasting === 'long' ? this.offers() : nothing}`;
    }

    private offers(): TemplateResult {
        const { state, view, edits } = this.model;
        const intent = edits.intent.value;
        const standing = state.progress.value;
        const may = intent !== null && standing !== null && !state.locked.value;
        const until = may ? untilHere(intent, standing, view) : null;
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
