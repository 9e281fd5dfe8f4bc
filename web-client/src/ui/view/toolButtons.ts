// Chooses what a click on the picture does; without a tool it only turns the view.
import { css, html, type TemplateResult } from 'lit';
import type { Tool, ViewState } from '../../state/viewState.ts';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from '../base/signalElement.ts';

const tools: readonly { tool: Tool; label: string; words: string; edits: boolean }[] = [
    { tool: 'probe', label: 'Probe', words: 'Show the flow under the pointer; click to keep the point', edits: false },
    { tool: 'measure', label: 'Measure', words: 'Measure the distance between two clicks', edits: false },
    { tool: 'annotate', label: 'Note', words: 'Click to place a note', edits: true },
];

export interface ToolsModel {
    state: Pick<AppState, 'role'>;
    view: Pick<ViewState, 'tool'>;
}

export class ToolButtons extends ModelElement<ToolsModel> {
    static override styles = css`
        div {
            display: grid;
            gap: 4px;
        }
        @media (max-width: 760px), (max-height: 500px) {
            div {
                grid-auto-flow: column;
            }
        }
        button[aria-pressed='true'] {
            border-color: var(--accent);
            background: var(--accent);
            color: var(--ground);
        }
    `;

    override render(): TemplateResult {
        const { view, state } = this.model;
        const viewer = state.role.value === 'viewer';
        return html`<div role="group" aria-label="Tools">
            ${tools.map(({ tool, label, words, edits }) => {
                const chosen = view.tool.value === tool;
                return html`<button
                    type="button"
                    title=${viewer && edits ? `${words} (your link is for looking)` : words}
                    aria-pressed=${chosen ? 'true' : 'false'}
                    ?disabled=${viewer && edits}
                    @click=${() => (view.tool.value = chosen ? 'none' : tool)}
                >
                    ${label}
                </button>`;
            })}
        </div>`;
    }
}

customElements.define('wakesurf-tool-buttons', ToolButtons);
