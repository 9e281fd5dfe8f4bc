// The notes of the session in full, and the dialog in which they are written.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { AnnotationRecord } from '../../protocol/messages.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Calls } from '../../session/base/calls.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement } from '../base/signalElement.ts';

export interface NotesModel {
    state: Pick<AppState, 'annotations' | 'role'>;
    view: Pick<ViewState, 'writeNote'>;
    calls: Pick<Calls, 'try'>;
    scene: Pick<FlowScene, 'controls' | 'loop'>;
}

export class NotesPanel extends ModelElement<NotesModel> {
    static override styles = css`
        li {
            margin-bottom: 10px;
        }
        .row {
            gap: 6px;
        }
        .row > :first-child {
            flex: 1;
        }
        .text {
            margin: 0 0 4px;
            overflow-wrap: anywhere;
            white-space: pre-wrap;
        }
    `;

    override render(): TemplateResult {
        const notes = [...this.model.state.annotations.value.values()];
        if (notes.length === 0) {
            const how = this.model.state.role.value === 'viewer' ? '' : ' Choose Note above the picture, then click to place it.';
            return html`<p class="quiet">None yet.${how}</p>`;
        }
        return html`<ul aria-label="Notes">
            ${notes.map((note) => this.row(note))}
        </ul>`;
    }

    private row(record: AnnotationRecord): TemplateResult {
        const { annotation, text, author, position, surface = null } = record;
        const { state, view, calls, scene } = this.model;
        const show = (): void => {
            const { position: eye, target, orthographic } = scene.controls.pose;
            const from = eye.map((value, i) => position[i]! + value - target[i]!) as typeof eye;
            scene.controls.place({ position: from, target: position, orthographic });
            scene.loop.request();
        };
        return html`<li data-annotation=${annotation}>
            <p class="text">${text}</p>
            <div class="row">
                <span class="quiet">${author}</span>
                <button type="button" @click=${show}>Show</button>
                ${
                    state.role.value === 'viewer'
                        ? nothing
                        : html`<button
                              type="button"
                              @click=${() => view.writeNote({ annotation, text, position, surface })}
                          >
                              Change
                          </button>
                          <button type="button" @click=${() => calls.try('annotation.delete', { annotation })}>Delete</button>`
                }
            </div>
        </li>`;
    }
}

customElements.define('wakesurf-notes', NotesPanel);
