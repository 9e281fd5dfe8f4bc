// Shows what mouse and keys do, and the tour again.
import { css, html, type TemplateResult } from 'lit';
import type { ViewState } from '../../state/viewState.ts';
import { dialogStyles, ModelElement } from '../base/signalElement.ts';
import { isTyping } from '../base/keyboard.ts';

const hints: readonly [keys: string, words: string][] = [
    ['Drag a handle', 'move the rake; hold Shift to stay on one axis'],
    ['Drag elsewhere', 'rotate the view; the right button pans'],
    ['Wheel, pinch', 'zoom'],
    ['Arrows, Page Up/Down', 'move the handle whose button has focus'],
    ['Ctrl Z, Ctrl Shift Z', 'undo and redo your own edits'],
    ['Space', 'play and pause'],
    [', and .', 'previous and next time-step'],
    ['Arrows', 'turn the view, while the picture has the focus; with Shift they move it'],
    ['+ and −', 'zoom'],
    ['F', 'fit the whole domain'],
    ['P', 'show or fold away the panel'],
    ['Shift F', 'full screen'],
    ['Ctrl Enter', 'save a note'],
    ['Esc', 'close the tool, stop following'],
    ['?', 'show this help'],
];

export interface HelpModel {
    view: Pick<ViewState, 'tourStep'>;
}

export class HelpDialog extends ModelElement<HelpModel> {
    static override styles = [
        dialogStyles,
        css`
            dialog {
                max-width: 460px;
            }
            h2 {
                margin: 0 0 10px;
                font-size: 16px;
            }
            dl {
                gap: 5px 16px;
            }
            dt {
                font-weight: 600;
                color: inherit;
            }
            dd {
                text-align: left;
                font-variant-numeric: normal;
            }
            a {
                margin: auto auto auto 0;
                color: var(--accent);
            }
            .open {
                min-width: 28px;
            }
        `,
    ];

    override render(): TemplateResult {
        return html`<button type="button" class="open" aria-label="Help" title="Help (?)" @click=${() => this.show()}>?</button>
            <dialog aria-labelledby="help-head">
                <h2 id="help-head">Mouse and keys</h2>
                <dl>
                    ${hints.map(
                        ([keys, words]) => html`<dt>${keys}</dt>
                            <dd>${words}</dd>`,
                    )}
                </dl>
                <div class="answers">
                    <a href="third-party-notices.txt" target="_blank" rel="noopener">Licences</a>
                    <button type="button" @click=${this.tour}>Show the tour</button>
                    <button type="button" autofocus @click=${() => this.dialog?.close()}>Close</button>
                </div>
            </dialog>`;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        addEventListener('keydown', this.pressed);
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        removeEventListener('keydown', this.pressed);
    }

    private readonly pressed = (event: KeyboardEvent): void => {
        if (event.key === '?' && !isTyping(event)) this.show();
    };

    private get dialog(): HTMLDialogElement | null {
        return this.renderRoot.querySelector('dialog');
    }

    private show(): void {
        if (this.dialog?.open === false) this.dialog.showModal();
    }

    private tour(): void {
        this.dialog?.close();
        this.model.view.tourStep.value = 0;
    }
}

customElements.define('wakesurf-help', HelpDialog);
