// The time of the data: one stop of the slider for every time-step that is ready. Below it, for surfaces that move,
// the session's clock: when of their life they are shown.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { ClockRecord, SurfaceKind } from '../protocol/messages.ts';
import { shortNumber } from '../scene/ticks.ts';
import type { AppModel } from './appModel.ts';
import { sharedStyles } from './sharedStyles.ts';
import { SignalElement } from './signalElement.ts';

const clockStops = 200;
const secondsToPlay = 10;

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
            button {
                width: 40px; /* the same for all that may stand in it, or the sliders would jump */
                padding-inline: 0;
            }
            .clock {
                display: contents;
            }
            .clock input {
                grid-column: 3 / 5;
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
            ${this.clock()}
        `;
    }

    /** Only for what the clock moves, and where the server has one. */
    private clock(): TemplateResult | typeof nothing {
        const { state, clock } = this.model;
        const record = state.clock.value;
        const intent = this.model.edits.intent.value;
        if (record === null || intent === null || intent.kind === 'stream') return nothing;
        const [from, to] = [record.from ?? intent.from, record.to ?? intent.from + intent.length];
        const time = this.shownTime(record) ?? to;
        const speed = record.from === null ? (to - from) / secondsToPlay : record.speed;
        return html`<div class="clock">
            <label for="clock">Shown at</label>
            <button
                type="button"
                aria-label=${record.playing ? 'Pause' : 'Play'}
                @click=${() => (record.playing ? clock.pause() : clock.play(speed))}
            >
                ${record.playing ? '❚❚' : '▶'}
            </button>
            <input
                id="clock"
                type="range"
                min=${from}
                max=${to}
                step=${(to - from) / clockStops}
                .value=${String(time)}
                aria-valuetext=${`time ${shortNumber(time)}`}
                @input=${(event: Event) => clock.set((event.target as HTMLInputElement).valueAsNumber)}
            />
            <output for="clock">t = ${shortNumber(time)}</output>
        </div>`;
    }

    /** While the clock runs, that of the surface on the screen. */
    private shownTime(record: ClockRecord): number | null {
        const { state } = this.model;
        const displayed = state.displayed.value.get(state.activeSurface.value ?? '');
        return record.playing && displayed !== undefined ? displayed.time : record.time;
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
