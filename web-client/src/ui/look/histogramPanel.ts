// How much of the selected surface has which value, in the colours of these values, with the ends of the range to drag, and ranges by what
// there is. Loaded when a look is first seen.
import { signal } from '@preact/signals-core';
import { css, html, nothing, svg, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { shortNumber } from '../../scene/base/numbers.ts';
import { banded, colourTable, type ColourScale, fractionOf, scaleOf, tableSize, valueAt } from '../../scene/surface/colourMap.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { SurfaceSpan } from '../../scene/surface/surfaceLayer.ts';
import { type Histogram, histogramOf, spanOfValues } from '../../session/picture/histogram.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { LookGroup, lookStyles } from './lookStyles.ts';

export interface HistogramModel {
    state: Pick<AppState, 'activeSurface' | 'displayed'>;
    view: Pick<ViewState, 'changeLook' | 'lookOf'>;
    scene: Pick<FlowScene, 'surfaces' | 'view'>;
}

const bins = 64;
/** Of the sliders. */
const steps = 1000;
/** States of a surface that plays come faster than a histogram is read. */
const restMs = 200;

export class HistogramPanel extends LookGroup<HistogramModel> {
    private readonly found = signal<{ of: string; histogram: Histogram } | null>(null);
    private due: ReturnType<typeof setTimeout> | undefined;
    private asked = '';

    static override styles = [
        lookStyles,
        css`
            .bars {
                position: relative;
                height: 64px;
                margin: 8px 7px 2px;
            }
            svg {
                display: block;
                width: 100%;
                height: 100%;
                overflow: visible;
            }
            .ground {
                fill: var(--line);
                opacity: 0.35;
            }
            .end {
                stroke: var(--text);
                stroke-width: 1.5;
                vector-effect: non-scaling-stroke;
            }
            /* A slider's handle stops half its width before the end: the sliders are that much longer. */
            input[type='range'] {
                position: absolute;
                left: -7px;
                bottom: -7px;
                width: calc(100% + 14px);
                height: 14px;
                margin: 0;
                background: none;
                appearance: none;
                pointer-events: none;
            }
            input::-webkit-slider-thumb {
                appearance: none;
                width: 14px;
                height: 14px;
                border: 2px solid var(--ground);
                border-radius: 50%;
                background: var(--text);
                cursor: ew-resize;
                pointer-events: auto;
            }
            input::-moz-range-thumb {
                width: 14px;
                height: 14px;
                border: 2px solid var(--ground);
                border-radius: 50%;
                background: var(--text);
                cursor: ew-resize;
                pointer-events: auto;
            }
            input:focus-visible {
                outline: none;
            }
            input:focus-visible::-webkit-slider-thumb {
                outline: 3px solid var(--accent);
            }
            input:focus-visible::-moz-range-thumb {
                outline: 3px solid var(--accent);
            }
            .buttons {
                margin-top: 14px;
            }
            .awaited {
                height: 116px;
            }
        `,
    ];

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        clearTimeout(this.due);
        this.asked = '';
    }

    override render(): TemplateResult | typeof nothing {
        const { state, scene } = this.model;
        const id = state.activeSurface.value;
        const span = id === null ? null : scene.surfaces.spanOf(id);
        if (id === null || span === null || span.style.source === 'constant') return nothing;
        const { look } = this;
        const scale = scaleOf(span.style);
        const of = JSON.stringify([id, span.style.source, span.style.scalar, scale, state.displayed.value.get(id)?.stateSum]);
        this.count(id, of, scale);
        const histogram = this.found.value?.histogram;
        // Its room is kept: nothing that one is about to press may move.
        if (histogram === undefined) return html`<div class="awaited" aria-hidden="true"></div>`;
        // A range beyond the values is seen as a whole; what is dragged stays on what is drawn.
        const range = look.range ?? span.colours;
        return html`<div class="bars" role="group" aria-label="Histogram">
                ${this.bars(histogram, span, scale)} ${this.end(0, range, histogram, scale)} ${this.end(1, range, histogram, scale)}
            </div>
            <div class="buttons" role="group" aria-label="Range of the colours">
                <button type="button" id="range-seen" title="From the least to the greatest value in the picture" @click=${() => this.fit(id, scale, true)}>
                    Seen
                </button>
                <button type="button" id="range-all" title="From the least to the greatest value of the surface" @click=${() => this.fit(id, scale, false)}>
                    All
                </button>
                <button
                    type="button"
                    id="range-symmetric"
                    title="As far below zero as above"
                    ?disabled=${scale === 'log'}
                    @click=${() => this.symmetric(range)}
                >
                    Symmetric
                </button>
            </div>`;
    }

    /** Not at every state: it takes longer than a frame of a large surface has. */
    private count(id: string, of: string, scale: ColourScale): void {
        if (of === this.asked) return;
        this.asked = of;
        clearTimeout(this.due);
        const due = (): void => {
            const { scene } = this.model;
            const values = scene.surfaces.valuesOf(id, null);
            const there = values === null ? null : spanOfValues(values, scale);
            const drawn = scene.surfaces.spanOf(id)?.colours ?? there;
            if (values === null || there === null || drawn === null) {
                this.found.value = null;
                return;
            }
            const whole: [number, number] = [Math.min(there[0], drawn[0]), Math.max(there[1], drawn[1])];
            this.found.value = { of, histogram: histogramOf(values, whole, scale, bins) };
        };
        this.due = setTimeout(due, this.found.value === null ? 0 : restMs);
    }

    private bars({ parts, span }: Histogram, { colours, style }: SurfaceSpan, scale: ColourScale): TemplateResult {
        const most = Math.max(...parts);
        const table = colourTable(style.map, style.inverted);
        const colour = (bin: number): string => {
            const fraction = banded(fractionOf(valueAt((bin + 0.5) / bins, span, scale), colours, scale), style.bands);
            const i = 4 * Math.round(fraction * (tableSize - 1));
            return `rgb(${table[i]},${table[i + 1]},${table[i + 2]})`;
        };
        // The root shows what there is little of.
        const height = (part: number): number => (most > 0 ? 56 * Math.sqrt(part / most) : 0);
        return html`<svg viewBox=${`0 0 ${bins} 60`} preserveAspectRatio="none" aria-hidden="true">
            <rect class="ground" width=${bins} y="59" height="1" />
            ${parts.map((part, bin) =>
                part > 0
                    ? svg`<rect x=${bin} width="1.02" y=${59 - height(part)} height=${height(part)} fill=${colour(bin)} />`
                    : nothing,
            )}
            ${colours.map((value) => {
                const at = bins * fractionOf(value, span, scale);
                // Zero has no logarithm.
                return Number.isFinite(at) ? svg`<line class="end" x1=${at} x2=${at} y1="0" y2="60" />` : nothing;
            })}
        </svg>`;
    }

    private end(which: 0 | 1, range: readonly [number, number], { span }: Histogram, scale: ColourScale): TemplateResult {
        const moved = (event: Event): void => {
            const at = (event.target as HTMLInputElement).valueAsNumber / steps;
            const value = toThousandth(valueAt(at, span, scale), span);
            const next: [number, number] =
                which === 0 ? [Math.min(value, range[1]), range[1]] : [range[0], Math.max(value, range[0])];
            this.change({ range: next, centre: null });
        };
        return html`<input
            type="range"
            id=${which === 0 ? 'range-low' : 'range-high'}
            aria-label=${which === 0 ? 'Lower end of the histogram' : 'Upper end of the histogram'}
            aria-valuetext=${shortNumber(range[which])}
            min="0"
            max=${steps}
            .value=${live(String(Math.round(steps * (fractionOf(range[which], span, scale) || 0))))}
            @input=${moved}
        />`;
    }

    private fit(id: string, scale: ColourScale, seen: boolean): void {
        const { scene } = this.model;
        const values = scene.surfaces.valuesOf(id, seen ? scene.view().camera : null);
        const span = values === null ? null : spanOfValues(values, scale);
        if (span !== null) this.change({ range: span, centre: null });
    }

    private symmetric([low, high]: readonly [number, number]): void {
        const most = Math.max(Math.abs(low), Math.abs(high));
        this.change({ range: [-most, most], centre: null });
    }
}

/** Returns a value in as few digits as tell a thousandth of a span, however far that is from 0. */
export function toThousandth(value: number, [low, high]: readonly [number, number]): number {
    const digits = Math.ceil(-Math.log10((high - low) / steps));
    return Number.isFinite(digits) ? placed(value, digits) : value;
}

function placed(value: number, digits: number): number {
    if (digits > 0) return digits > 100 ? value : Number(value.toFixed(digits));
    const unit = 10 ** -digits;
    return Math.round(value / unit) * unit;
}

customElements.define('wakesurf-histogram', HistogramPanel);
