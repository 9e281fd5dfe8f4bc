// A field for another link, on a page that the server does not let in.
import { css, html, LitElement, nothing, type TemplateResult } from 'lit';
import { sharedStyles } from '../base/sharedStyles.ts';

const noLink = 'There is no token in this. Paste the whole link, with the part after token=.';

export class LinkField extends LitElement {
    static override properties = { take: { attribute: false }, wrong: { state: true } };
    /** False: what was typed is no link. */
    declare take: (text: string) => boolean;
    declare wrong: boolean;

    static override styles = [
        sharedStyles,
        css`
            form {
                display: flex;
                gap: 8px;
                margin-top: 8px;
            }
            input {
                flex: 1;
                min-width: 0;
            }
        `,
    ];

    override render(): TemplateResult {
        return html`<form @submit=${(event: SubmitEvent) => this.submit(event)}>
                <input
                    name="link"
                    aria-label="New link"
                    placeholder="Paste a new link here"
                    autocomplete="off"
                    spellcheck="false"
                    required
                />
                <button type="submit">Connect</button>
            </form>
            ${this.wrong ? html`<p role="alert">${noLink}</p>` : nothing}`;
    }

    private submit(event: SubmitEvent): void {
        event.preventDefault();
        const field = this.renderRoot.querySelector('input')!;
        this.wrong = !this.take(field.value);
        if (!this.wrong) field.value = '';
    }
}

customElements.define('wakesurf-link-field', LinkField);
