// Asks for the words of a note.
import { css, html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Calls } from '../../session/base/calls.ts';
import type { ViewState } from '../../state/viewState.ts';
import { dialogStyles } from '../base/sharedStyles.ts';
import { ModelElement } from '../base/signalElement.ts';

/** The server takes 4 KiB; letters of other alphabets take up to four bytes. */
const longest = 1000;

export interface NoteModel {
    view: Pick<ViewState, 'note' | 'endNote' | 'tool'>;
    calls: Pick<Calls, 'try'>;
}

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
        const asked = this.model.view.note.value !== null;
        if (asked && this.dialog?.open === false) this.dialog.showModal();
        else if (!asked && this.dialog?.open === true) this.dialog.close();
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
