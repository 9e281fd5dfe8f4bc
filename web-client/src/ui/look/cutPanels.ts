// Which part is shown: planes that cut all surfaces open, and the body if wanted; of the selected surface some seeds only, or some age
// only; and whether its torn borders are smooth.
import { css, html, nothing, type TemplateResult } from 'lit';
import { placeNumber, resolutionOf } from '../../scene/base/numbers.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { changeLookWithFields } from '../../session/picture/surfaceFields.ts';
import { clipBounds, picturedBounds } from '../../session/picture/picturedBounds.ts';
import { coordinateText } from '../../session/picture/writtenNumbers.ts';
import type { AppState } from '../../state/appState.ts';
import type { ClipPlane, ClipPlanes } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, sliderRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { countWords } from '../base/words.ts';
import { ageName } from './colourNames.ts';
import { LookGroup, lookStyles } from './lookStyles.ts';

const axes = ['x', 'y', 'z'] as const;

export interface ClipModel {
    state: Pick<AppState, 'dataset' | 'described' | 'lines' | 'pictured' | 'slices' | 'surfaces'>;
    view: Pick<ViewState, 'clip'>;
}

/** Planes that cut all surfaces open. */
export class ClipPanel extends ModelElement<ClipModel> {
    static override styles = [
        lookStyles,
        css`
            .plane {
                display: grid;
                grid-template-columns: 72px 1fr minmax(44px, auto) auto;
                gap: 8px;
                align-items: center;
            }
            .value {
                text-align: right;
                font-size: 12px;
            }
            .plane button {
                padding: 1px 8px;
            }
        `,
    ];

    override render(): TemplateResult {
        const { view } = this.model;
        const { planes, slice, body } = view.clip.value;
        return html`
            ${axes.map((axis, i) => this.plane(axis, i, planes[i]!))}
            ${checkRow('Cut the body too', body, (on) => this.change({ body: on }), { id: 'clip-body' })}
            <p class="quiet">
                Planes cut all surfaces in the picture. A slice can cut them at any angle: choose it under "In the picture".
                ${slice === null ? nothing : 'One cuts now.'}
                ${slice === null ? nothing : html`<button id="clip-no-slice" type="button" @click=${() => this.change({ slice: null })}>Cut at no slice</button>`}
            </p>
        `;
    }

    private plane(axis: string, index: number, plane: ClipPlane): TemplateResult {
        const bounds = clipBounds(this.model.state) ?? [0, 1, 0, 1, 0, 1];
        const [low, high] = [bounds[2 * index] ?? 0, bounds[2 * index + 1] ?? 1];
        const whole = picturedBounds(this.model.state) ?? bounds;
        const part = (end: 0 | 1): number => (high > low ? (whole[2 * index + end]! - low) / (high - low) : end);
        const place = coordinateText(this.model.state, index, low + plane.at * (high - low));
        return html`<div class="plane" role="group" aria-label=${`Plane across ${axis}`}>
            ${checkRow(`Cut ${axis}`, plane.on, (on) => this.changePlane(index, { on }), { id: `clip-${axis}` })}
            <input
                id=${`clip-${axis}-at`}
                type="range"
                min=${part(0)}
                max=${part(1)}
                step=${(part(1) - part(0)) / 200}
                aria-label=${`Where it cuts ${axis}`}
                aria-valuetext=${place}
                .value=${String(plane.at)}
                ?disabled=${!plane.on}
                @input=${(event: Event) => this.changePlane(index, { at: (event.target as HTMLInputElement).valueAsNumber })}
            />
            <span class="value">${place}</span>
            <button
                id=${`clip-${axis}-flip`}
                type="button"
                aria-pressed=${plane.flipped ? 'true' : 'false'}
                aria-label=${`Cut the other side of ${axis}`}
                title="Cut the other side"
                ?disabled=${!plane.on}
                @click=${() => this.changePlane(index, { flipped: !plane.flipped })}
            >
                ⇄
            </button>
        </div>`;
    }

    private changePlane(index: number, change: Partial<ClipPlane>): void {
        const { planes } = this.model.view.clip.value;
        const [x, y, z] = planes.map((plane, i) => (i === index ? { ...plane, ...change } : plane));
        this.change({ planes: [x!, y!, z!] });
    }

    private change(change: Partial<ClipPlanes>): void {
        const { clip } = this.model.view;
        clip.value = { ...clip.value, ...change };
    }
}

customElements.define('wakesurf-clip', ClipPanel);

type Window = 'sWindow' | 'ageWindow';
type Span = readonly [number, number];

export interface WindowsModel {
    state: Pick<AppState, 'activeSurface' | 'notices' | 'displayed' | 'role' | 'surface' | 'trimmed'>;
    view: Pick<ViewState, 'changeLook' | 'lookOf'>;
    scene: Pick<FlowScene, 'surfaces'>;
    edits: Pick<Edits, 'changeSurface'>;
}

/** The part of the selected surface that is shown. */
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
