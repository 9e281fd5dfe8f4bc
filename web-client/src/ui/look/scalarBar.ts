// What the colours of the selected surface mean: the colour table with numbers, as text that can be read aloud.
import { css, html, nothing, type TemplateResult } from 'lit';
import { colourTable, fractionOf, tableSize } from '../../scene/surface/colourMap.ts';
import { colourTicks } from '../../scene/surface/colourTicks.ts';
import type { SurfaceSpan } from '../../scene/surface/surfaceLayer.ts';
import { placeNumbers, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { colourTitle } from './colourNames.ts';
import { sharedStyles } from '../base/sharedStyles.ts';
import { SignalElement } from '../base/signalElement.ts';

export interface ScalarBarModel {
    state: AppState;
    view: ViewState;
    scene: Pick<FlowScene, 'surfaces'>;
}

const rangeWords = { surface: 'of this surface', data: 'of all the data', locked: 'locked' };

export class ScalarBar extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: ScalarBarModel;
    private span: SurfaceSpan | null = null;
    private painted: { canvas: HTMLCanvasElement; table: string } | null = null;

    static override styles = [
        sharedStyles,
        css`
            :host([hidden]) {
                display: none;
            }
            :host {
                display: block;
                width: 260px;
                padding: 8px 14px 6px;
                border-radius: 8px;
                background: light-dark(rgb(246 248 251 / 0.86), rgb(11 16 24 / 0.82));
                font-size: 12px;
                pointer-events: none;
            }
            figure {
                margin: 0;
            }
            canvas {
                display: block;
                width: 100%;
                height: 12px;
                border-radius: 3px;
            }
            figcaption {
                display: flex;
                flex-wrap: wrap;
                justify-content: space-between;
                gap: 0 8px;
                margin-bottom: 4px;
            }
            /* A line of its own where both do not fit: a figure repeats what stands here span by span, each in one line. */
            figcaption span {
                white-space: nowrap;
            }
            .range {
                color: var(--quiet);
                font-variant-numeric: tabular-nums;
            }
            .ticks {
                position: relative;
                height: 18px;
                margin-top: 3px;
                font-variant-numeric: tabular-nums;
            }
            .ticks span {
                position: absolute;
                transform: translateX(-50%);
            }
        `,
    ];

    override render(): TemplateResult {
        const { state, view, scene } = this.model;
        // Whenever one of these changes, what is drawn may.
        void [state.displayed.value, view.looks.value, state.surfaces.value, state.speedRange.value];
        this.span = scene.surfaces.spanOf(state.activeSurface.value ?? '');
        this.hidden = this.span === null || this.span.style.source === 'constant';
        if (this.span === null) return html``;
        const { colours, style } = this.span;
        const [low, high] = colours;
        const name = colourTitle(style, state.dataset.value, state.surface.value?.kind, view.units.value.length);
        const scale = style.logarithmic ? ', logarithmic' : '';
        const [from, to] = style.logarithmic
            ? [shortNumber(low), shortNumber(high)]
            : placeNumbers(colours, resolutionOf(low, high));
        const whose = style.source === 'scalar' ? rangeWords[style.rangeOf] : '';
        const { ticks, shared } = colourTicks(low, high, style.logarithmic, 5);
        return html`<figure aria-label=${`Colours: ${name} from ${from} to ${to}${scale}${whose === '' ? '' : `, ${whose}`}`}>
            <figcaption>
                <span>${name}</span>
                <span class="range">${from} to ${to}${style.logarithmic ? ', log' : ''}</span>
                ${whose === '' ? nothing : html`<span class="range" id="whose">${whose}</span>`}
                ${shared === '' ? nothing : html`<span class="range" id="shared">numbers below ${shared}</span>`}
            </figcaption>
            <canvas width=${tableSize} height="1" aria-hidden="true"></canvas>
            <div class="ticks" aria-hidden="true">
                ${ticks.map(
                    ({ value, label }) => html`<span data-at=${fractionOf(value, colours, style.logarithmic)}>${label}</span>`,
                )}
            </div>
        </figure>`;
    }

    protected override updated(): void {
        // Positions through the object model: the content security policy forbids style attributes.
        for (const tick of this.renderRoot.querySelectorAll<HTMLElement>('.ticks span')) {
            tick.style.left = `${Number(tick.dataset['at']) * 100}%`;
        }
        if (this.span === null) return;
        const { map, inverted } = this.span.style;
        const canvas = this.renderRoot.querySelector('canvas');
        const table = `${map} ${inverted}`;
        // Ranges change with every state, colours seldom.
        if (canvas === null || (this.painted?.canvas === canvas && this.painted.table === table)) return;
        this.painted = { canvas, table };
        const pixels = new Uint8ClampedArray(colourTable(map, inverted).buffer);
        canvas.getContext('2d')?.putImageData(new ImageData(pixels, tableSize, 1), 0, 0);
    }
}

customElements.define('wakesurf-scalar-bar', ScalarBar);
