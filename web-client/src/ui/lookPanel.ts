// How the selected surface looks: the colours first, everything else in groups that open.
import { css, html, type TemplateResult } from 'lit';
import type { AppModel } from './appModel.ts';
import './clipPanel.ts';
import './colourPanel.ts';
import './linesPanel.ts';
import './opacityPanel.ts';
import './paintPanel.ts';
import { sharedStyles } from './sharedStyles.ts';
import { SignalElement } from './signalElement.ts';
import './windowsPanel.ts';

export class LookPanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
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
        `,
    ];

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
            <details id="windows-group">
                <summary>Part shown</summary>
                <wakesurf-windows .model=${model}></wakesurf-windows>
            </details>
            <details id="clip-group">
                <summary>Cutting planes</summary>
                <wakesurf-clip .model=${model}></wakesurf-clip>
            </details>
            <details id="paint-group" @toggle=${this.listParts}>
                <summary>Painting and connected parts</summary>
                <wakesurf-paint .model=${model}></wakesurf-paint>
            </details>
        `;
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.model.view.partsListed.value = null;
    }

    /** Parts are looked for only while somebody sees the list. */
    private listParts(event: Event): void {
        const { state, view } = this.model;
        const { open } = event.target as HTMLDetailsElement;
        view.partsListed.value = open ? state.activeSurface.value : null;
    }
}

customElements.define('wakesurf-look', LookPanel);
