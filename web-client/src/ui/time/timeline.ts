// The time of the data as a line: its time-steps with what of them is in the server's memory, the part that
// the surface covers, and two handles: above, when the picture is of; below, when the surface is released.
import { signal } from '@preact/signals-core';
import { css, html, noChange, nothing, svg, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { Edits } from '../../session/edits/edits.ts';
import { timeWords, withUnit } from '../../session/picture/writtenNumbers.ts';
import { markWords, type StepMark, stepMarks } from '../../session/time/cachedSteps.ts';
import type { Playback } from '../../session/time/playback.ts';
import { otherSide, releasedSpan, type Span, stepTicks, timelineSpan } from '../../session/time/timeSteps.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement } from '../base/signalElement.ts';

/** A picture with two native sliders over it, whose middle lies exactly over the time they mean. */
const timelineStyles = css`
    :host {
        display: block;
        position: relative;
        height: 52px;
        margin: 0 14px;
    }
    /* One more line: what the numbers share. */
    :host([shared]) {
        height: 66px;
    }
    text.shared {
        text-anchor: end;
    }
    .picture {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
        overflow: visible;
        pointer-events: none;
    }
    .line {
        fill: var(--line);
    }
    .shown {
        fill: var(--accent);
        opacity: 0.35;
    }
    .released {
        fill: var(--accent);
        opacity: 0.7;
    }
    .release-end {
        stroke: var(--accent);
        stroke-width: 2;
    }
    .now {
        stroke: var(--text);
        stroke-width: 1.5;
    }
    .other {
        stroke-dasharray: 2 2;
    }
    .hollow {
        fill: none;
        stroke: var(--quiet);
        stroke-width: 1;
    }
    .filled,
    .coming {
        fill: var(--quiet);
    }
    .mark {
        pointer-events: all;
    }
    text {
        fill: var(--quiet);
        font-size: 11px;
        font-variant-numeric: tabular-nums;
        text-anchor: middle;
    }
    /* A slider's handle stops half its width before the end: the sliders are that much longer. */
    input[type='range'] {
        position: absolute;
        left: -7px;
        width: calc(100% + 14px);
        margin: 0;
        background: none;
        appearance: none;
    }
    .now-handle {
        top: 0;
        height: 20px;
    }
    .release-handle {
        top: 16px;
        height: 14px;
        pointer-events: none;
    }
    input::-webkit-slider-thumb {
        appearance: none;
        width: 14px;
        height: 14px;
        border: 0;
        cursor: ew-resize;
    }
    input::-moz-range-thumb {
        width: 14px;
        height: 14px;
        border: 0;
        cursor: ew-resize;
    }
    input:focus-visible {
        outline: none;
    }
    input:focus-visible::-webkit-slider-thumb {
        outline: 3px solid var(--accent);
        outline-offset: 1px;
    }
    input:focus-visible::-moz-range-thumb {
        outline: 3px solid var(--accent);
        outline-offset: 1px;
    }
    .now-handle::-webkit-slider-thumb {
        border: 2px solid var(--ground);
        border-radius: 50%;
        background: var(--text);
    }
    .now-handle::-moz-range-thumb {
        border: 2px solid var(--ground);
        border-radius: 50%;
        background: var(--text);
    }
    .release-handle::-webkit-slider-thumb {
        pointer-events: auto;
        background: var(--accent);
        clip-path: polygon(50% 0, 100% 70%, 100% 100%, 0 100%, 0 70%);
    }
    .release-handle::-moz-range-thumb {
        pointer-events: auto;
        background: var(--accent);
        clip-path: polygon(50% 0, 100% 70%, 100% 100%, 0 100%, 0 70%);
    }
    .release-handle:focus-visible::-webkit-slider-thumb {
        background: var(--text);
        clip-path: none;
    }
    .release-handle:focus-visible::-moz-range-thumb {
        background: var(--text);
        clip-path: none;
    }
`;

const pxPerTick = 64;
/** Marks nearer to each other than this are drawn as one bar. */
const pxPerMark = 5;
const pageOfSteps = 5;

interface Slider {
    id: string;
    handle: 'now-handle' | 'release-handle';
    at: number;
    disabled: boolean;
    label: string;
    /** What it says of where it is. */
    words: string;
    title?: string;
    moved: (event: Event) => void;
    keyed: (event: KeyboardEvent) => void;
}

export interface TimelineModel {
    state: AppState;
    view: Pick<ViewState, 'units'>;
    playback: Pick<Playback, 'goTo' | 'mode' | 'own' | 'ownMoves' | 'release' | 'span' | 'step' | 'time' | 'toEnd'>;
    edits: Pick<Edits, 'intent' | 'changeSurface'>;
}

export class Timeline extends ModelElement<TimelineModel> {
    private readonly width = signal(600);
    /** The handle under the pointer stays there until it is released, also between two time-steps. */
    private readonly held = signal<string | null>(null);
    private readonly resized = new ResizeObserver(([entry]) => {
        if (entry !== undefined && entry.contentRect.width > 0) this.width.value = entry.contentRect.width;
    });

    static override styles = timelineStyles;

    override connectedCallback(): void {
        super.connectedCallback();
        this.resized.observe(this);
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.resized.disconnect();
    }

    override render(): TemplateResult {
        const { playback, state } = this.model;
        const moving = playback.mode.value === 'clock';
        const times = state.times.value;
        const ownMoves = moving && playback.ownMoves.value;
        const surface = ownMoves ? this.covered(playback.own.value) : null;
        const played = playback.span.value;
        const line = timelineSpan(times, surface === null ? played : joined(surface, played));
        const at = (time: number): string => `${((100 * (time - line[0])) / (line[1] - line[0])).toFixed(3)}%`;
        const { ticks, shared } = stepTicks(times, line, this.width.value / pxPerTick);
        this.toggleAttribute('shared', shared !== '');
        const { time } = playback;
        return html`
            <svg class="picture" aria-hidden="true">
                <rect class="line" x="0" width="100%" y="9" height="2" />
                ${surface === null ? nothing : this.surfaceBand(surface, at)}
                ${
                    Number.isFinite(time.value)
                        ? svg`<line class="now" x1=${at(time.value)} x2=${at(time.value)} y1="10" y2="34" />`
                        : nothing
                }
                ${ownMoves && this.bothWays ? this.otherNow(time.value, at) : nothing}
                ${stepMarks(state.heldSteps.value, this.width.value / pxPerMark).map((mark) => this.mark(mark, at))}
                ${ticks.map(({ value, label }, i) => {
                    const words = i === ticks.length - 1 ? withUnit(label, this.unit) : label;
                    return svg`<text class="tick" x=${at(value)} y="49">${words}</text>`;
                })}
                ${shared === '' ? nothing : svg`<text class="shared" x="100%" y="63">${withUnit(shared, this.unit)}</text>`}
            </svg>
            ${moving ? this.clockSlider(line) : this.frozenSlider(line)}
            ${ownMoves && this.model.edits.intent.value?.kind !== 'level' ? this.releaseSlider(line) : nothing}
        `;
    }

    private get bothWays(): boolean {
        return this.model.edits.intent.value?.direction === 'both';
    }

    /** The times of the surface, its backward side too. */
    private covered(span: Span): Span {
        return this.bothWays ? [otherSide(span[0], span[1], this.model.state.surfaceTimes.value), span[1]] : span;
    }

    /** Returns how far the backward side has come. */
    private otherNow(time: number, at: (time: number) => string): TemplateResult {
        const { playback, state } = this.model;
        const x = at(otherSide(playback.own.value[0], time, state.surfaceTimes.value));
        return svg`<line class="now other" x1=${x} x2=${x} y1="4" y2="16" />`;
    }

    /** Released in the full part; in the pale one what was released moves on. */
    private surfaceBand(surface: Span, at: (time: number) => string): TemplateResult {
        const record = this.model.state.surface.value;
        const backward = record !== undefined && record.to < record.from;
        const width = (low: number, high: number): string => `${Math.max(0, parseFloat(at(high)) - parseFloat(at(low)))}%`;
        if (record?.kind === 'level') {
            return svg`<rect class="shown" x=${at(surface[0])} width=${width(...surface)} y="6" height="8" rx="2" />`;
        }
        const released = releasedSpan(this.model.playback.own.value, record?.kind ?? 'path', backward, record?.releaseUntil);
        const end = released[backward ? 0 : 1];
        return svg`
            <rect class="shown" x=${at(surface[0])} width=${width(...surface)} y="6" height="8" rx="2" />
            <rect class="released" x=${at(released[0])} width=${width(...released)} y="6" height="8" rx="2" />
            ${
                end < surface[1] && end > surface[0]
                    ? svg`<line class="release-end" x1=${at(end)} x2=${at(end)} y1="3" y2="17" />`
                    : nothing
            }`;
    }

    /** Draws a mark as high as its part in memory, above that half as wide what is being read, hollow on the
     *  disk. */
    private mark(mark: StepMark, at: (time: number) => string): TemplateResult {
        const { first, last, state, resident, loading } = mark;
        const times = this.model.state.dataset.value?.times ?? [];
        const [low, high] = [parseFloat(at(times[first] ?? 0)), parseFloat(at(times[last] ?? 0))];
        const width = Math.min(1.2, ((last > first ? 1 : 0.7) * 100) / Math.max(1, times.length - 1));
        const [x, across] = [`${(low - width / 2).toFixed(3)}%`, `${(high - low + width).toFixed(3)}%`];
        const there = heightOf(resident);
        const coming = Math.min(heightOf(loading), markHeight - there);
        const bar = (name: string, base: number, height: number, wide: string): TemplateResult | typeof nothing =>
            height === 0 ? nothing : svg`<rect class=${name} x=${x} width=${wide} y=${base - height} height=${height} />`;
        return svg`<g class="mark" data-step=${first} data-state=${state}>
            <title>${this.markTitle(mark)}</title>
            <rect class="hollow" x=${x} width=${across} y="23.5" height="9" />
            ${bar('filled', markBase, there, across)}
            ${bar('coming', markBase - there, coming, `${((high - low + width) / 2).toFixed(3)}%`)}
        </g>`;
    }

    private markTitle(mark: StepMark): string {
        const { dataset, heldSteps } = this.model.state;
        const time = (step: number): string => this.words(dataset.value?.times[step] ?? 0);
        const steps =
            mark.first === mark.last
                ? `Time-step ${mark.first} at ${time(mark.first)}`
                : `Time-steps ${mark.first} to ${mark.last} at ${time(mark.first)} to ${time(mark.last)}`;
        return `${steps}: ${markWords(mark, heldSteps.value.whole)}`;
    }

    private clockSlider(line: Span): TemplateResult {
        const { time } = this.model.playback;
        return this.slider(line, {
            ...{ id: 'clock', handle: 'now-handle', at: time.value, disabled: this.mayNot },
            ...{ label: 'Shown at', words: `shown at ${this.words(time.value)}` },
            ...{ moved: this.scrubbed, keyed: this.keyed },
        });
    }

    private frozenSlider(line: Span): TemplateResult {
        const { time, mode } = this.model.playback;
        return this.slider(line, {
            ...{ id: 'time', handle: 'now-handle', disabled: this.mayNot || mode.value === 'none' },
            at: Number.isFinite(time.value) ? time.value : line[0],
            ...{ label: 'Time of the frozen field', words: `frozen at ${this.words(time.value)}` },
            ...{ moved: this.scrubbed, keyed: this.keyed },
        });
    }

    private releaseSlider(line: Span): TemplateResult {
        const { playback, edits, state } = this.model;
        const from = edits.intent.value?.from ?? line[0];
        return this.slider(line, {
            ...{ id: 'time', handle: 'release-handle', at: from },
            disabled: this.mayNot || state.surfaceTimes.value.length < 2,
            ...{
                label: 'Release',
                words: `released at ${this.words(from)}`,
                title: 'Drag to change when the surface is released',
            },
            ...{ moved: (event) => playback.release(valueOf(event)), keyed: this.releaseKeyed },
        });
    }

    private slider([first, last]: Span, slider: Slider): TemplateResult {
        const { id, handle, at, disabled, label, words, title, moved, keyed } = slider;
        return html`<input
            id=${id}
            class=${handle}
            type="range"
            min=${first}
            max=${last}
            step="any"
            ?disabled=${disabled}
            .value=${this.place(id, at)}
            aria-label=${label}
            aria-valuetext=${words}
            title=${title ?? nothing}
            @pointerdown=${this.hold}
            @input=${moved}
            @keydown=${keyed}
        />`;
    }

    private get unit(): string {
        return this.model.view.units.value.time;
    }

    private words(time: number): string {
        return timeWords(this.model.state, this.model.view, time);
    }

    private get mayNot(): boolean {
        return this.model.state.locked.value;
    }

    private place(handle: string, time: number): string | typeof noChange | ReturnType<typeof live> {
        return this.held.value === handle ? noChange : live(String(time));
    }

    private hold(event: PointerEvent): void {
        this.held.value = (event.target as HTMLInputElement).id;
        const release = (): void => {
            this.held.value = null;
            removeEventListener('pointerup', release);
            removeEventListener('pointercancel', release);
        };
        addEventListener('pointerup', release);
        addEventListener('pointercancel', release);
    }

    private scrubbed(event: Event): void {
        this.model.playback.goTo(valueOf(event));
    }

    /** Arrow keys go by time-steps: what a slider does by itself is a hundredth of the whole. */
    private keyed(event: KeyboardEvent): void {
        const { playback } = this.model;
        const steps = stepsOf(event.key);
        if (steps !== 0) {
            event.preventDefault();
            void (async () => {
                for (let i = 0; i < Math.abs(steps); ++i) await playback.step(steps > 0 ? 1 : -1);
            })();
        } else if (event.key === 'Home' || event.key === 'End') {
            event.preventDefault();
            void playback.toEnd(event.key === 'End' ? 1 : -1);
        }
    }

    private releaseKeyed(event: KeyboardEvent): void {
        const { playback, state, edits } = this.model;
        const times = state.surfaceTimes.value;
        const index = times.indexOf(edits.intent.value?.from ?? Number.NaN);
        const ends: Record<string, number> = { Home: 0, End: times.length - 1 };
        const to = ends[event.key] ?? index + stepsOf(event.key);
        if (stepsOf(event.key) === 0 && ends[event.key] === undefined) return;
        event.preventDefault();
        const time = times[Math.min(times.length - 1, Math.max(0, to))];
        if (time !== undefined) playback.release(time);
    }
}

/** Lowest edge of the marks, and how high they are. */
const markBase = 33;
const markHeight = 10;
/** The height of what is there at all, however little. */
const leastHeight = 1.5;

function joined([a, b]: Span, [c, d]: Span): Span {
    return [Math.min(a, c), Math.max(b, d)];
}

function heightOf(share: number): number {
    return share === 0 ? 0 : Math.max(leastHeight, markHeight * share);
}

function stepsOf(key: string): number {
    const steps: Record<string, number> = {
        ...{ ArrowRight: 1, ArrowUp: 1, PageUp: pageOfSteps },
        ...{ ArrowLeft: -1, ArrowDown: -1, PageDown: -pageOfSteps },
    };
    return steps[key] ?? 0;
}

function valueOf(event: Event): number {
    return (event.target as HTMLInputElement).valueAsNumber;
}

customElements.define('wakesurf-timeline', Timeline);
