// What the colours mean: the colour table with numbers, as text that can be read aloud.
import { css, html, type TemplateResult } from 'lit';
import { colorTable, fractionOf, tableSize } from '../scene/surface/colorMap.ts';
import { niceTicks, shortNumber } from '../scene/ticks.ts';
import type { AppModel } from './appModel.ts';
import { SignalElement } from './signalElement.ts';

export class ScalarBar extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = css`
        :host([hidden]) {
            display: none;
        }
        :host {
            display: block;
            width: 260px;
            padding: 8px 14px 6px;
            border-radius: 8px;
            background: light-dark(rgb(255 255 255 / 0.85), rgb(11 16 24 / 0.82));
            color: light-dark(#17202d, #e8edf5);
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
            justify-content: space-between;
            margin-bottom: 4px;
        }
        .range {
            color: light-dark(#4b5a70, #a7b4c8);
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
    `;

    override render(): TemplateResult {
        const { state } = this.model;
        const dataset = state.dataset.value;
        this.hidden = dataset === null;
        const range = state.speedRange.value;
        const unit = dataset?.fields.find(({ name }) => name === dataset.velocity)?.unit;
        const name = unit === undefined ? 'Speed' : `Speed (${unit})`;
        const span = `from ${shortNumber(range[0])} to ${shortNumber(range[1])}`;
        return html`<figure aria-label=${`Colours: ${name} ${span}`}>
            <figcaption>
                <span>${name}</span>
                <span class="range">${shortNumber(range[0])} to ${shortNumber(range[1])}</span>
            </figcaption>
            <canvas width=${tableSize} height="1" aria-hidden="true"></canvas>
            <div class="ticks" aria-hidden="true">
                ${niceTicks(range[0], range[1], 5).map(
                    ({ value, label }) =>
                        html`<span data-at=${fractionOf(value, range)}>${label}</span>`,
                )}
            </div>
        </figure>`;
    }

    protected override updated(): void {
        // Positions through the object model: the content security policy forbids style attributes.
        for (const tick of this.renderRoot.querySelectorAll<HTMLElement>('.ticks span')) {
            tick.style.left = `${Number(tick.dataset['at']) * 100}%`;
        }
        const canvas = this.renderRoot.querySelector('canvas');
        const pixels = new Uint8ClampedArray(colorTable().buffer);
        canvas?.getContext('2d')?.putImageData(new ImageData(pixels, tableSize, 1), 0, 0);
    }
}

customElements.define('wakesurf-scalar-bar', ScalarBar);
