// Which part of the selected surface is shown: from some seeds only, or of some age only, and whether its
// torn borders are smooth.
import { html, nothing, type TemplateResult } from 'lit';
import { placeNumber, resolutionOf } from '../../scene/base/numbers.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { changeLookWithFields } from '../../session/picture/surfaceFields.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ageName } from './colourNames.ts';
import { checkRow, sliderRow } from '../base/rows.ts';
import { LookGroup } from './lookStyles.ts';
import { countWords } from '../base/statusWords.ts';

type Window = 'sWindow' | 'ageWindow';
type Span = readonly [number, number];

export interface WindowsModel {
    state: Pick<AppState, 'activeSurface' | 'notices' | 'displayed' | 'role' | 'surface' | 'trimmed'>;
    view: Pick<ViewState, 'changeLook' | 'lookOf'>;
    scene: Pick<FlowScene, 'surfaces'>;
    edits: Pick<Edits, 'changeSurface'>;
}

export class WindowsPanel extends LookGroup<WindowsModel> {
    override render(): TemplateResult {
        const { state, scene } = this.model;
        void state.displayed.value;
        const id = state.activeSurface.value ?? '';
        const { look } = this;
        const span = scene.surfaces.spanOf(id);
        if (span === null) return html`<p class="quiet">There is no surface yet.</p>`;
        const trimmed = state.trimmed.value.get(id) ?? 0;
        const shown = look.sWindow !== null || look.ageWindow !== null;
        return html`
            ${this.window('sWindow', 's-window', 'Position on the rake', look.sWindow, [0, 1])}
            ${this.window('ageWindow', 'age-window', ageName(state.surface.value?.kind), look.ageWindow, span.age)}
            ${
                shown
                    ? html`<div class="buttons"><button id="show-whole" type="button" @click=${() => this.change({ sWindow: null, ageWindow: null })}>Show all of it</button></div>`
                    : nothing
            }
            ${checkRow('Trim torn borders', look.trimmed, (on) => this.change({ trimmed: on }), { id: 'trimmed' })}
            ${checkRow('Curved cells when still', look.curved, (on) => this.curved(on), { id: 'curved' })}
            <p class="quiet">
                ${trimmed === 0 ? 'Nothing is trimmed.' : `Of ${countWords(trimmed)} ${trimmed === 1 ? 'quad' : 'quads'} at torn borders a part is not drawn.`}
                Meshes, lines and numbers always have all of it.
            </p>
        `;
    }

    /** The normals travel with the surface from then on, for every user; who may only look has those of the
     *  picture. */
    private curved(on: boolean): void {
        const record = this.model.state.surface.value;
        if (record !== undefined) changeLookWithFields(this.model, record, { curved: on });
    }

    private window(name: Window, id: string, words: string, window: Span | null, whole: Span): TemplateResult {
        // Of a surface without vertices there is no age.
        if (!whole.every(Number.isFinite) || !(whole[1] > whole[0])) return html``;
        const [low, high] = window ?? whole;
        const step = (whole[1] - whole[0]) / 200;
        // Ages come in steps of the wire: the youngest is zero but for one of those.
        const slider = (end: 'from' | 'to', value: number): TemplateResult =>
            sliderRow({
                ...{
                    id: `${id}-${end}`,
                    words: `${words}, ${end}`,
                    value,
                    shown: placeNumber(Math.abs(value) < step / 2 ? 0 : value, resolutionOf(...whole)),
                },
                ...{ low: whole[0], high: whole[1], step },
                change: (at) => this.setWindow(name, end === 'from' ? [at, Math.max(at, high)] : [Math.min(at, low), at], whole),
            });
        return html`${slider('from', low)} ${slider('to', high)}`;
    }

    /** A window that holds everything is none, and goes on to do so. */
    private setWindow(name: Window, [low, high]: Span, whole: Span): void {
        const slack = (whole[1] - whole[0]) / 400;
        const open = low <= whole[0] + slack && high >= whole[1] - slack;
        this.change({ [name]: open ? null : [low, high] });
    }
}

customElements.define('wakesurf-windows', WindowsPanel);
