// Shows how much of what is behind the selected surface is seen through it, its outlines and its other side.
import { html, type TemplateResult } from 'lit';
import type { BackSide, SurfaceLook } from '../../state/surfaceLook.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, type Choice, selectRow, sliderRow } from '../base/rows.ts';
import { LookGroup } from './lookStyles.ts';

const sides: readonly Choice<BackSide>[] = [
    { value: 'shaded', words: 'A little darker' },
    { value: 'tinted', words: 'Tinted orange' },
    { value: 'same', words: 'The same' },
];

export interface OpacityModel {
    state: Pick<AppState, 'activeSurface'>;
    view: Pick<ViewState, 'changeLook' | 'exactWhenStill' | 'lookOf'>;
}

export class OpacityPanel extends LookGroup<OpacityModel> {
    override render(): TemplateResult {
        const { look } = this;
        const { view } = this.model;
        const percent = (part: number): string => `${Math.round(100 * part)} %`;
        const slider = { low: 0, high: 1, step: 0.05 };
        return html`
            ${sliderRow({
                ...{ ...slider, low: 0.05, id: 'opacity', words: 'Opacity', value: look.opacity },
                shown: percent(look.opacity),
                change: (opacity) => this.change({ opacity }),
            })}
            ${checkRow(
                'More opaque when seen edge-on',
                look.angleOpacity,
                (angleOpacity) => this.change({ angleOpacity, ...dimmed(look, angleOpacity) }),
                { id: 'angle-opacity' },
            )}
            ${sliderRow({
                ...{ ...slider, id: 'smoke', words: 'Smoke', value: look.smoke },
                shown: look.smoke === 0 ? 'off' : percent(look.smoke),
                change: (smoke) => this.change({ smoke, ...dimmed(look, smoke > 0, 0.9) }),
            })}
            <p class="quiet">Smoke thins where the surface has been stretched, and with age.</p>
            ${checkRow('Points instead of cells', look.points, (points) => this.change({ points }), { id: 'points' })}
            ${checkRow('Outlines', look.silhouettes, (silhouettes) => this.change({ silhouettes }), { id: 'silhouettes' })}
            ${selectRow('back-side', 'Other side', sides, look.backSide, (backSide) => this.change({ backSide }))}
            ${checkRow(
                'Exact order when still',
                view.exactWhenStill.value,
                (on) => {
                    view.exactWhenStill.value = on;
                },
                { id: 'exact-order' },
            )}
            <p class="quiet">Applies to all transparent surfaces. While the view moves, transparency is approximate; pictures and films are always exact.</p>
        `;
    }
}

/** Makes a surface let something through, so that more or less of that can be chosen. */
function dimmed({ opacity }: SurfaceLook, on: boolean, to = 0.6): Partial<SurfaceLook> {
    return on && opacity > 0.95 ? { opacity: to } : {};
}

customElements.define('wakesurf-opacity', OpacityPanel);
