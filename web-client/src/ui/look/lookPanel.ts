// Shows how the selected surface looks: the colours first, everything else in groups that open.
import { css, html, nothing, type TemplateResult } from 'lit';
import './clipPanel.ts';
import type { ClipModel } from './clipPanel.ts';
import './colourPanel.ts';
import type { ColourModel } from './colourPanel.ts';
import './linesPanel.ts';
import type { LinesModel } from './linesPanel.ts';
import './piecesPanel.ts';
import './opacityPanel.ts';
import type { OpacityModel } from './opacityPanel.ts';
import './paintPanel.ts';
import type { PaintModel } from './paintPanel.ts';
import { ModelElement } from '../base/signalElement.ts';
import './windowsPanel.ts';
import type { WindowsModel } from './windowsPanel.ts';
import type { BodyFlow } from '../../session/picture/bodyFlow.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow } from '../base/rows.ts';
import { lookStyles } from './lookStyles.ts';

export interface BodyModel {
    state: Pick<AppState, 'dataset'>;
    view: Pick<ViewState, 'bodyTexture'>;
    bodyFlow: Pick<BodyFlow, 'standing'>;
}

const bodyWords = {
    off: '',
    waiting: 'The flow along the body is on its way.',
    shown: 'The velocity is that a quarter of a cell off the body. Where the clock runs, the texture goes with the flow.',
    failed: 'The server did not send the flow along the body at this time.',
};

export class BodyPanel extends ModelElement<BodyModel> {
    static override styles = lookStyles;

    override render(): TemplateResult {
        const { state, view, bodyFlow } = this.model;
        const { bodyTexture } = view;
        const none = state.dataset.value?.obstacle !== true;
        const said = none ? 'There is no body in this dataset.' : bodyWords[bodyFlow.standing.value];
        return html`
            ${checkRow('Show the flow along the body', bodyTexture.value, (on) => (bodyTexture.value = on), { id: 'body-texture', disabled: none })}
            ${said === '' ? nothing : html`<p class="quiet" role="status">${said}</p>`}
        `;
    }
}

customElements.define('wakesurf-body', BodyPanel);

/** Describes what its groups take: all of them are about the same surface. */
export type LookModel = ColourModel & OpacityModel & LinesModel & WindowsModel & ClipModel & BodyModel & PaintModel;

export class LookPanel extends ModelElement<LookModel> {
    static override styles = css`
        :host {
            display: block;
            padding-top: 10px;
        }
        details {
            border-top: 1px solid var(--line);
        }
        wakesurf-colour {
            display: block;
            margin-bottom: 10px;
        }
        summary {
            padding: 7px 0;
            font-weight: 600;
            cursor: pointer;
        }
        details[open] > :last-child {
            display: block;
            padding-bottom: 10px;
        }
    `;

    override render(): TemplateResult {
        const { model } = this;
        return html`
            <wakesurf-colour .model=${model}></wakesurf-colour>
            <details id="opacity-group">
                <summary>Opacity and outlines</summary>
                <wakesurf-opacity .model=${model}></wakesurf-opacity>
            </details>
            <details id="lines-group">
                <summary>Stripes and texture</summary>
                <wakesurf-lines .model=${model}></wakesurf-lines>
            </details>
            <details id="pieces-group">
                <summary>Lines, ribbons and arrows</summary>
                <wakesurf-pieces .model=${model}></wakesurf-pieces>
            </details>
            <details id="windows-group">
                <summary>Part shown</summary>
                <wakesurf-windows .model=${model}></wakesurf-windows>
            </details>
            <details id="clip-group">
                <summary>Cutting planes</summary>
                <wakesurf-clip .model=${model}></wakesurf-clip>
            </details>
            <details id="body-group">
                <summary>Body</summary>
                <wakesurf-body .model=${model}></wakesurf-body>
            </details>
            <details id="paint-group" @toggle=${this.listParts}>
                <summary>Painting and connected parts</summary>
                <wakesurf-paint .model=${model}></wakesurf-paint>
            </details>
        `;
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        const { view } = this.model;
        view.partsListed.value = false;
        // Nothing on the page would say that the brush is still in hand.
        if (view.tool.value === 'paint') view.tool.value = 'none';
    }

    /** Parts are looked for only while a user sees the list. */
    private listParts(event: Event): void {
        this.model.view.partsListed.value = (event.target as HTMLDetailsElement).open;
    }
}

customElements.define('wakesurf-look', LookPanel);
