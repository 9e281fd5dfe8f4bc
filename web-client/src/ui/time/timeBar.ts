// Below the picture: when it is of, how that runs, and the timeline.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { SurfaceKind } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { clockText, timeField, timeWords, withUnit } from '../../session/picture/writtenNumbers.ts';
import { residentWords } from '../../session/time/cachedSteps.ts';
import type { Playback } from '../../session/time/playback.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { icon } from '../base/icons.ts';
import { isTyping, leaveKeys } from '../base/keyboard.ts';
import { type OwnCopyButton, titleOf } from '../base/locked.ts';
import '../base/locked.ts';
import { numberField } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import './timeline.ts';

const timeBarStyles = css`
    :host {
        display: block;
        padding: 6px 10px 4px;
        background: var(--ground);
        border-top: 1px solid var(--line);
    }
    .row {
        flex-wrap: wrap;
        justify-content: normal;
        gap: 4px 10px;
        min-height: 28px;
    }
    .buttons {
        display: flex;
        gap: 3px;
    }
    .buttons button {
        display: grid;
        place-content: center;
        width: 29px;
        padding: 0;
    }
    button:disabled {
        opacity: 0.45;
        cursor: default;
    }
    [aria-pressed='true'] {
        border-color: var(--accent);
        color: var(--accent);
    }
    #speed {
        max-width: 150px;
    }
    input.number {
        field-sizing: content;
        min-width: 74px;
        max-width: 150px;
        text-align: right;
        font-variant-numeric: tabular-nums;
    }
    label {
        display: flex;
        align-items: center;
        gap: 6px;
    }
    .words {
        font-variant-numeric: tabular-nums;
    }
    .quiet,
    .below {
        min-height: 18px;
        color: var(--quiet);
        font-size: 12px;
    }
    .legend {
        display: flex;
        flex-wrap: wrap;
        gap: 2px 12px;
    }
    .legend svg {
        margin-right: 4px;
        vertical-align: -1px;
    }
    .legend rect {
        fill: none;
        stroke: currentColor;
    }
    .legend path {
        fill: currentColor;
    }
    /* The signs of the marks are in the timeline's own words. */
    @media (max-width: 500px), (max-height: 500px) {
        #speed {
            max-width: 112px;
        }
        .legend [aria-hidden] {
            display: none;
        }
    }
`;

export type TimeKey = 'toggle' | 'back' | 'forward';

/** What of a key press matters here; KeyboardEvent has it. */
export type KeyPress = Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'altKey' | 'metaKey' | 'defaultPrevented'>;

/**
 * Space plays and pauses, comma and full stop step; not while something else wants them: a field that is typed in, a button in
 * focus, an open dialog. Null where the key is none of these. `spaceTaken`: the element in focus does something of its own when
 * space is pressed.
 */
export function timeKey(press: KeyPress, spaceTaken: boolean): TimeKey | null {
    if (press.ctrlKey || press.altKey || press.metaKey || press.defaultPrevented) return null;
    if (press.key === ',') return 'back';
    if (press.key === '.') return 'forward';
    return press.key === ' ' && !spaceTaken ? 'toggle' : null;
}

function timeKeyOf(event: KeyboardEvent): TimeKey | null {
    const [target] = event.composedPath();
    const takes = target instanceof Element && target.matches(spaceTakers);
    return isTyping(event) ? null : timeKey(event, takes);
}

/** Of the radio button that is chosen, and of the tab that is open, space would change nothing. */
const spaceTakers =
    'button:not([aria-selected="true"]), input:not([type="range"], [type="radio"]:checked), select, summary, a[href]';

const speeds = [0.1, 0.25, 0.5, 1, 2, 4];

/** What the release is to a surface of each kind. */
const released: Partial<Record<SurfaceKind, string>> = {
    path: 'released at',
    streak: 'released from',
    time: 'released at',
};

export interface TimeBarModel {
    state: AppState;
    view: Pick<ViewState, 'units'>;
    playback: Playback;
    edits: Pick<Edits, 'intent' | 'changeSurface'>;
    ownCopy: OwnCopyButton['model'];
}

export class TimeBar extends ModelElement<TimeBarModel> {
    /** Is shown while a time may be being typed, which the time that passes must not overwrite. */
    private held: string | null = null;
    /** Is shown as it was typed. */
    private typed = Number.NaN;

    static override styles = timeBarStyles;

    override connectedCallback(): void {
        super.connectedCallback();
        addEventListener('keydown', this.keyed);
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        removeEventListener('keydown', this.keyed);
    }

    override render(): TemplateResult {
        const { playback } = this.model;
        const locked = this.model.state.locked.value;
        const none = playback.mode.value === 'none';
        return html`
            <div class="row">
                ${this.buttons(locked || none)} ${this.speed(locked || none)}
                <label for="go-to" @focusin=${this.entered} @focusout=${this.left}
                    ><span class="quiet">${playback.mode.value === 'clock' ? 'shown' : 'frozen'} at</span>
                    ${numberField({
                        id: 'go-to',
                        title: titleOf(
                            this.model.state,
                            playback.mode.value === 'clock'
                                ? 'Time of the picture'
                                : 'The stream surface is of the flow as it is at this time',
                        ),
                        label: playback.mode.value === 'clock' ? 'Shown at time' : 'Frozen at time',
                        disabled: locked || none,
                        shown: this.held ?? this.timeText,
                        change: (time) => this.goTo(time),
                    })}
                    ${this.model.view.units.value.time}
                </label>
                <span class="words">${this.meaning()}${this.whyNot()}</span>
            </div>
            <wakesurf-timeline
                .model=${this.model}
                ?hidden=${none && this.model.state.surfaceTimes.value.length < 2}
            ></wakesurf-timeline>
            <div class="below">
                ${this.legend()}
            </div>
        `;
    }

    private get timeText(): string {
        const { playback, state } = this.model;
        const time = playback.time.value;
        const asTyped = playback.mode.value !== 'clock' || time === this.typed;
        return asTyped ? timeField(state, time) : clockText(state, time, playback.playing.value);
    }

    private words(time: number): string {
        return timeWords(this.model.state, this.model.view, time);
    }

    private buttons(disabled: boolean): TemplateResult {
        const { playback } = this.model;
        const playing = playback.playing.value;
        const button = (words: string, keys: string, sign: TemplateResult, action: () => unknown): TemplateResult =>
            html`<button type="button" aria-label=${words} title=${titleOf(this.model.state, keys)} ?disabled=${disabled} @click=${action}>
                ${sign}
            </button>`;
        return html`<div class="buttons" role="group" aria-label="Time controls">
            ${button('To the start', 'To the start', icon('start'), () => playback.toEnd(-1))}
            ${button('Previous time-step', 'Previous time-step: ,', icon('back'), () => playback.step(-1))}
            ${
                playing
                    ? button('Pause', 'Pause: space', icon('pause'), () => playback.toggle())
                    : button('Play', 'Play: space', icon('play'), () => playback.toggle())
            }
            ${button('Next time-step', 'Next time-step: .', icon('forward'), () => playback.step(1))}
            ${button('To the end', 'To the end', icon('end'), () => playback.toEnd(1))}
        </div>`;
    }

    private speed(disabled: boolean): TemplateResult {
        const { playback } = this.model;
        const normal = playback.normalSpeed.value;
        const factor = normal > 0 ? playback.speed.value / normal : 1;
        const close = (each: number): boolean => Math.abs(each - factor) < 1e-3 * each;
        const choices = speeds.some(close) ? speeds : [...speeds, factor];
        const loop = playback.loop.value;
        return html`<select
                id="speed"
                aria-label="Speed"
                title=${titleOf(this.model.state, 'Simulation time that passes in a second')}
                ?disabled=${disabled}
                @change=${this.speedChosen}
            >
                ${choices.map(
                    (each) =>
                        html`<option value=${each} .selected=${close(each)}>
                            ${shortNumber(each)}×${normal > 0 ? ` (${withUnit(shortNumber(each * normal), this.model.view.units.value.time)}/s)` : ''}
                        </option>`,
                )}
            </select>
            <button
                type="button"
                aria-pressed=${loop ? 'true' : 'false'}
                title=${titleOf(this.model.state, 'Start again at the end')}
                ?disabled=${disabled}
                @click=${() => playback.setLoop(!loop)}
            >
                Loop
            </button>`;
    }

    /** When the surface is released, or why nothing plays. */
    private meaning(): TemplateResult | typeof nothing {
        const { playback, edits, state } = this.model;
        const intent = edits.intent.value;
        if (intent === null) return nothing;
        if (intent.kind === 'level') return nothing;
        if (intent.kind === 'stream') {
            return playback.mode.value === 'none'
                ? html`<span class="quiet">The data have only one time-step: there is nothing to play.</span>`
                : nothing;
        }
        const until = intent.kind === 'streak' ? state.surface.value?.releaseUntil : undefined;
        const end = until === undefined ? nothing : html` <span class="quiet">to</span> ${this.words(until)}`;
        return html`<span class="quiet">${released[intent.kind]}</span> ${this.words(intent.from)}${end}`;
    }

    /** Where it is looked for: beside the buttons that do nothing. */
    private whyNot(): TemplateResult | typeof nothing {
        const { state } = this.model;
        if (state.role.value !== 'viewer') return nothing;
        return html` <span class="quiet" id="time-locked">People who can edit choose the time for everyone. To play for yourself:</span>
            <wakesurf-own-copy .model=${this.model.ownCopy}></wakesurf-own-copy>`;
    }

    private legend(): TemplateResult {
        const held = this.model.state.heldSteps.value;
        if (held.steps.length === 0) return html`<span></span>`;
        const sign = (fill: string): TemplateResult =>
            html`<svg width="9" height="11" viewBox="0 0 9 11" aria-hidden="true">
                <path d=${fill} />
                <rect x="0.5" y="0.5" width="8" height="10" />
            </svg>`;
        return html`<span class="legend">
            <span>${sign('M0 0h9v11h-9z')}<span id="resident">${residentWords(held)}</span></span>
            <span aria-hidden="true">${sign('M0 0h4.5v11h-4.5z')}loading</span>
            <span aria-hidden="true">${sign('')}on disk</span>
        </span>`;
    }

    private readonly keyed = (event: KeyboardEvent): void => {
        const { playback, state } = this.model;
        const key = timeKeyOf(event);
        if (key === null || playback.mode.value === 'none' || state.locked.value) return;
        event.preventDefault();
        if (key === 'toggle') void playback.toggle();
        else void playback.step(key === 'forward' ? 1 : -1);
    };

    private goTo(time: number): void {
        this.typed = time;
        this.model.playback.goTo(time);
        this.left();
    }

    private entered(): void {
        this.held = this.timeText;
    }

    private left(): void {
        this.held = null;
        this.requestUpdate();
    }

    private speedChosen(event: Event): void {
        const select = event.target as HTMLSelectElement;
        leaveKeys(select);
        void this.model.playback.setSpeed(Number(select.value));
    }
}

customElements.define('wakesurf-time-bar', TimeBar);
