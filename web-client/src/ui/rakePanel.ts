// The rake in numbers and by keyboard: everything a pointer can do to it, without one.
import { css, html, type TemplateResult } from 'lit';
import type { Vec3 } from '../protocol/messages.ts';
import type { Handle } from '../scene/rake/rakeWidget.ts';
import { diagonal } from '../scene/camera/fitting.ts';
import type { AppModel } from './appModel.ts';
import { sharedStyles } from './sharedStyles.ts';
import { SignalElement } from './signalElement.ts';

const nudgeKeys: Record<string, [axis: 0 | 1 | 2, sign: 1 | -1]> = {
    ArrowRight: [0, 1],
    ArrowLeft: [0, -1],
    PageUp: [1, 1],
    PageDown: [1, -1],
    ArrowUp: [2, 1],
    ArrowDown: [2, -1],
};
/** Of the domain's diagonal; ten times as much with Shift. */
const nudgeFraction = 0.002;
const axes = ['x', 'y', 'z'] as const;

export class RakePanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
            .handles {
                display: grid;
                grid-template-columns: repeat(3, 1fr);
                gap: 6px;
            }
            .point {
                display: grid;
                grid-template-columns: 42px repeat(3, 1fr);
                gap: 6px;
                align-items: center;
                margin-top: 8px;
            }
            .point input,
            .seeds input {
                width: 100%;
                min-width: 0;
                padding: 3px 6px;
                text-align: right;
                font-variant-numeric: tabular-nums;
            }
            .point input {
                appearance: textfield;
            }
            .point input::-webkit-inner-spin-button {
                appearance: none;
            }
            .seeds {
                display: grid;
                grid-template-columns: 42px 84px 1fr;
                gap: 6px;
                align-items: center;
                margin-top: 8px;
            }
            .hint {
                margin: 6px 0 0;
                color: var(--quiet);
                font-size: 12px;
            }
            .heads {
                color: var(--quiet);
                text-align: center;
                margin-bottom: -6px;
            }
        `,
    ];

    override render(): TemplateResult {
        const { state, edits } = this.model;
        const points = state.rakePoints.value;
        return html`
            <div class="handles" role="group" aria-label="Rake handles">
                ${this.handleButton('Start', 0)} ${this.handleButton('Middle', 'middle')}
                ${this.handleButton('End', Math.max(1, points.length - 1))}
            </div>
            <p class="hint" id="nudge-hint">
                Drag a handle, or focus a button and press ← → for x, ↑ ↓ for z, Page Up/Down for y;
                Shift for longer steps.
            </p>
            <div class="point heads" aria-hidden="true">
                <span></span>${axes.map((axis) => html`<span>${axis}</span>`)}
            </div>
            ${points.map((point, i) => this.pointRow(point, i, points.length))}
            <label class="seeds"
                >Seeds
                <input
                    id="seeds"
                    type="number"
                    min="2"
                    max="4096"
                    step="1"
                    .value=${String(edits.seeds.value)}
                    @change=${this.seedsChanged}
                />
            </label>
        `;
    }

    private handleButton(label: string, handle: Handle): TemplateResult {
        const { interaction } = this.model.scene;
        return html`<button
            type="button"
            data-handle=${String(handle)}
            aria-describedby="nudge-hint"
            @focus=${() => interaction.highlight(handle)}
            @blur=${() => interaction.highlight(null)}
            @keydown=${(event: KeyboardEvent) => this.nudge(event, handle)}
        >
            ${label}
        </button>`;
    }

    private pointRow(point: Vec3, index: number, count: number): TemplateResult {
        const name = index === 0 ? 'Start' : index === count - 1 ? 'End' : String(index + 1);
        return html`<div class="point" role="group" aria-label=${`${name} point`}>
            <span>${name}</span>
            ${axes.map(
                (axis, k) =>
                    html`<input
                        type="number"
                        step="any"
                        aria-label=${`${name} ${axis}`}
                        .value=${String(Number((point[k] ?? 0).toPrecision(4)))}
                        @change=${(event: Event) => this.pointChanged(event, index, k)}
                    />`,
            )}
        </div>`;
    }

    private nudge(event: KeyboardEvent, handle: Handle): void {
        const key = nudgeKeys[event.key];
        const bounds = this.model.state.dataset.value?.bounds;
        if (key === undefined || bounds === undefined) return;
        event.preventDefault();
        const [axis, sign] = key;
        const by: Vec3 = [0, 0, 0];
        by[axis] = sign * diagonal(bounds) * nudgeFraction * (event.shiftKey ? 10 : 1);
        this.model.scene.interaction.nudge(handle, by);
    }

    private pointChanged(event: Event, index: number, axis: number): void {
        const { state, edits } = this.model;
        const input = event.target as HTMLInputElement;
        const value = input.valueAsNumber;
        if (!Number.isFinite(value)) {
            this.requestUpdate();
            return;
        }
        const points = state.rakePoints.value.map((point) => [...point] as Vec3);
        const point = points[index];
        if (point === undefined) return;
        point[axis] = value;
        edits.setPoints(points);
    }

    private seedsChanged(event: Event): void {
        const value = Math.round((event.target as HTMLInputElement).valueAsNumber);
        if (Number.isFinite(value) && value >= 2) this.model.edits.setSeeds(value);
        else this.requestUpdate();
    }
}

customElements.define('wakesurf-rake', RakePanel);
