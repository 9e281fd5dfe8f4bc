// The time of the data: one stop of the slider for every time-step that is ready.
import { css, html, type TemplateResult } from 'lit';
import type { SurfaceKind } from '../protocol/messages.ts';
import { shortNumber } from '../scene/ticks.ts';
import type { AppModel } from './appModel.ts';
import { sharedStyles } from './sharedStyles.ts';
import { SignalElement } from './signalElement.ts';

/** What the time of the slider is for a surface of each kind. */
const meanings: Record<SurfaceKind, string> = {
    stream: 'frozen at',
    path: 'released at',
    streak: 'released from',
    time: 'released at',
};

export class TimeBar extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [
        sharedStyles,
        css`
            :host {
                display: grid;
                grid-template-columns: auto auto 1fr auto auto;
                align-items: center;
                gap: 10px;
                padding: 8px 16px;
                background: var(--ground);
                border-top: 1px solid var(--line);
            }
            output {
                min-width: 12ch;
                font-variant-numeric: tabular-nums;
            }
            .quiet {
                color: var(--quiet);
            }
        `,
    ];

    override render(): TemplateResult {
        const { state, edits } = this.model;
        const times = state.times.value;
        const intent = edits.intent.value;
        const index = nearestIndex(times, intent?.from ?? 0);
        const still = intent === null || times.length < 2;
        const meaning = meanings[intent?.kind ?? 'stream'];
        return html`
            <label for="time">Time</label>
            <button
                type="button"
                aria-label="Previous time-step"
                ?disabled=${still || index === 0}
                @click=${() => this.choose(index - 1)}
            >
                ‹
            </button>
            <input
                id="time"
                type="range"
                min="0"
                max=${Math.max(1, times.length - 1)}
                step="1"
                ?disabled=${still}
                .value=${String(index)}
                aria-valuetext=${`time ${shortNumber(times[index] ?? 0)}`}
                @input=${(event: Event) => this.choose((event.target as HTMLInputElement).valueAsNumber)}
            />
            <button
                type="button"
                aria-label="Next time-step"
                ?disabled=${still || index >= times.length - 1}
                @click=${() => this.choose(index + 1)}
            >
                ›
            </button>
            <output for="time"
                ><span class="quiet">${meaning}</span> t = ${shortNumber(intent?.from ?? Number.NaN)}</output
            >
        `;
    }

    private choose(index: number): void {
        const from = this.model.state.times.value[index];
        if (from !== undefined) this.model.edits.changeSurface({ from });
    }
}

function nearestIndex(times: readonly number[], time: number): number {
    let nearest = 0;
    times.forEach((t, i) => {
        if (Math.abs(t - time) < Math.abs((times[nearest] ?? 0) - time)) nearest = i;
    });
    return nearest;
}

customElements.define('wakesurf-time-bar', TimeBar);
