// Stripes, lines and flow texture on the selected surface.
import { html, nothing, type TemplateResult } from 'lit';
import type { LineKind, SurfaceLook } from '../../state/surfaceLook.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, type Choice, lookStyles, selectRow, sliderRow } from './lookStyles.ts';
import { sharedStyles } from '../base/sharedStyles.ts';
import { SignalElement } from '../base/signalElement.ts';

const kinds: readonly Choice<LineKind>[] = [
    { value: 'none', words: 'None' },
    { value: 'timelines', words: 'Along timelines' },
    { value: 'streamlines', words: 'Along the flow' },
    { value: 'grid', words: 'Grid of both' },
    { value: 'checker', words: 'Checkerboard' },
];

export interface LinesModel {
    state: Pick<AppState, 'activeSurface'>;
    view: ViewState;
}

export class LinesPanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: LinesModel;
    static override styles = [sharedStyles, lookStyles];

    override render(): TemplateResult {
        const { state, view } = this.model;
        const { lines, density, texture, animated } = view.lookOf(state.activeSurface.value);
        return html`
            ${selectRow('lines', 'Stripes', kinds, lines, (chosen) => this.change({ lines: chosen }))}
            ${checkRow('texture', 'Flow texture', texture, (on) => this.change({ texture: on, animated: on && animated }))}
            ${checkRow('animated', 'Moving with the flow', animated, (on) => this.change({ animated: on }), !texture)}
            ${
                matchMedia('(prefers-reduced-motion: reduce)').matches && animated
                    ? html`<p class="quiet">Animation is off: your system asks for reduced motion.</p>`
                    : nothing
            }
            ${sliderRow({
                ...{ id: 'density', words: 'Density', value: Math.log2(density), low: -2, high: 2, step: 0.5 },
                shown: `× ${Number(density.toPrecision(2))}`,
                change: (power) => this.change({ density: 2 ** power }),
            })}
        `;
    }

    private change(change: Partial<SurfaceLook>): void {
        const { state, view } = this.model;
        const id = state.activeSurface.value;
        if (id !== null) view.changeLook(id, change);
    }
}

customElements.define('wakesurf-lines', LinesPanel);
