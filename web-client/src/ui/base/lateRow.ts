// Of what the server has not answered for long: words, and a way out.
import { html, nothing, type TemplateResult } from 'lit';

export function lateRow(late: boolean, again: () => void): TemplateResult | typeof nothing {
    return late
        ? html`<p role="status" class="late">
              The server has not answered for more than 10 s.
              <button type="button" @click=${again}>Ask again</button>
          </p>`
        : nothing;
}
