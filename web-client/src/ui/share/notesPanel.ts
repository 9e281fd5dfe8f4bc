// The notes of the session in full, and the dialog in which they are written.
import { css, html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { AnnotationRecord } from '../../protocol/messages.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Calls } from '../../session/base/calls.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { dialogStyles, ModelElement } from '../base/signalElement.ts';

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

/** The server takes 4 KiB; letters of other alphabets take up to four bytes. */
const longest = 1000;

export interface NoteModel {
    view: Pick<ViewState, 'note' | 'endNote' | 'tool'>;
    calls: Pick<Calls, 'try'>;
}

/** Asks for the words of a note. */
export class NoteDialog extends ModelElement<NoteModel> {
    private saving = false;

    static override styles = [
        dialogStyles,
        css`
            dialog {
                width: 340px;
            }
            label {
                display: grid;
                gap: 6px;
                font-weight: 600;
            }
            textarea {
                min-height: 90px;
                padding: 6px 8px;
                border: 1px solid var(--line);
                border-radius: 6px;
                background: var(--raised);
                color: inherit;
                font: inherit;
                font-weight: 400;
            }
        `,
    ];

    override render(): TemplateResult {
        const { note } = this.model.view;
        return html`<dialog @cancel=${this.cancelled} @close=${this.closed}>
            <form @submit=${this.save}>
                <label
                    >${note.value?.annotation == null ? 'A note for everyone here' : 'Change the note'}
                    <textarea
                        required
                        maxlength=${longest}
                        .value=${live(note.value?.text ?? '')}
                        @keydown=${this.pressed}
                    ></textarea>
                </label>
                <p class="hint">Ctrl+Enter saves. Escape closes and keeps the text.</p>
                <div class="answers">
                    <button type="button" @click=${() => this.model.view.endNote(null)}>Discard</button>
                    <button type="submit">Save</button>
                </div>
            </form>
        </dialog>`;
    }

    protected override updated(): void {
        const wanted = this.model.view.note.value !== null;
        if (wanted && this.dialog?.open === false) this.dialog.showModal();
        else if (!wanted && this.dialog?.open === true) this.dialog.close();
    }

    private get dialog(): HTMLDialogElement | null {
        return this.renderRoot.querySelector('dialog');
    }

    /** By Escape. What is typed is kept now: the dialog tells that it has closed only later, when the next
     *  note may be open already. */
    private cancelled(event: Event): void {
        event.preventDefault();
        this.model.view.endNote(this.text);
    }

    /** Keeps the text also where the browser has closed the dialog by itself. */
    private closed(): void {
        const { view } = this.model;
        if (view.note.value !== null && this.dialog?.open === false) view.endNote(this.text);
    }

    private pressed(event: KeyboardEvent): void {
        if (event.key !== 'Enter' || !(event.ctrlKey || event.metaKey)) return;
        event.preventDefault();
        this.renderRoot.querySelector('form')?.requestSubmit();
    }

    private get text(): string {
        return this.renderRoot.querySelector('textarea')?.value ?? '';
    }

    private async save(event: Event): Promise<void> {
        event.preventDefault();
        const { view, calls } = this.model;
        const draft = view.note.value;
        const text = this.text.trim();
        if (draft === null || text === '' || this.saving) return;
        this.saving = true;
        const saved = await calls.try('annotation.set', {
            ...{ text, position: draft.position },
            ...(draft.annotation === null ? {} : { annotation: draft.annotation }),
            ...(draft.surface === null ? {} : { surface: draft.surface }),
        });
        this.saving = false;
        // What the server refuses can be corrected.
        if (saved === null) return;
        view.endNote(null);
        view.tool.value = 'none';
    }
}

customElements.define('wakesurf-note-dialog', NoteDialog);
