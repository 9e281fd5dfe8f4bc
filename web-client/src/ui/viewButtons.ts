// Views of the whole domain, for when the camera has lost its way.
import { css, html, LitElement, type TemplateResult } from 'lit';
import type { ViewName } from '../scene/camera/cameraControls.ts';
import type { AppModel } from './appModel.ts';
import { sharedStyles } from './sharedStyles.ts';

const views: { view: ViewName; label: string; words: string }[] = [
    { view: 'oblique', label: 'Fit', words: 'Fit the whole domain' },
    { view: 'x', label: 'x', words: 'x: look along x' },
    { view: 'y', label: 'y', words: 'y: look along y' },
    { view: 'z', label: 'z', words: 'z: look along z' },
];

export class ViewButtons extends LitElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
            div {
                display: flex;
                gap: 4px;
            }
            button {
                min-width: 30px;
            }
        `,
    ];

    override render(): TemplateResult {
        return html`<div role="group" aria-label="View">
            ${views.map(
                ({ view, label, words }) =>
                    html`<button
                        type="button"
                        title=${words}
                        aria-label=${words}
                        @click=${() => this.model.scene.controls.show(view)}
                    >
                        ${label}
                    </button>`,
            )}
        </div>`;
    }
}

customElements.define('wakesurf-view-buttons', ViewButtons);
