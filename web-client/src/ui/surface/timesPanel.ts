// The times of a surface: when it begins and ends, to be typed (of a stream surface, when its field is frozen), how long it is released
// for, and how old its particles get.
import { css, html, nothing, type TemplateResult } from 'lit';
import { shortNumber } from '../../scene/base/numbers.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { SurfaceIntent } from '../../session/edits/surfaceIntent.ts';
import { endOf, followed, typedFrom, type TypedTime, typedTo } from '../../session/edits/surfaceTimes.ts';
import { timeField, timeWords, withUnit } from '../../session/picture/writtenNumbers.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { checkRow, numberField, sliderRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

export interface ReleaseModel {
    state: AppState;
    view: Pick<ViewState, 'units'>;
    edits: Pick<Edits, 'changeSurface' | 'intent'>;
}

interface Span {
    id: string;
    /** The id of the box that leaves it at its longest, and what it says. */
    box: string;
    label: string;
    title: string;
    words: string;
    /** What the slider stands for, and its words. */
    shown: number | null;
    longest: number;
    says: (value: number) => string;
    change: (value: number | null) => Partial<SurfaceIntent>;
}

/** How long a surface is released for, and how old its particles get. */
export class ReleasePanel extends ModelElement<ReleaseModel> {
    static override styles = css`
        .row {
            margin-top: 6px;
        }
        .check {
            margin-top: 8px;
            cursor: pointer;
        }
    `;

    override render(): TemplateResult {
        const { state, view, edits } = this.model;
        const intent = edits.intent.value;
        if (intent === null || intent.kind === 'stream') return html``;
        const longest = followed(intent, state.surfaceTimes.value, state.surfaceDataset.value?.steady ?? false);
        const sign = intent.direction === 'backward' ? -1 : 1;
        const until: Span = {
            ...{ id: 'release-until', box: 'release', label: 'Keep releasing while shown', words: 'Release until', longest },
            title: 'Particles are released until the time that is shown; without, the release stops at a time of your choice',
            shown: intent.released,
            says: (value) => `t = ${timeWords(state, view, intent.from + sign * value)}`,
            change: (released) => ({ released }),
        };
        const age: Span = {
            ...{ id: 'life', box: 'live-on', label: 'Particles live on', words: 'Longest age', longest },
            title: 'A particle lasts as long as the surface is followed; without, it ends at an age of your choice',
            shown: intent.life,
            says: (value) => withUnit(shortNumber(value), view.units.value.time),
            change: (life) => ({ life }),
        };
        return html`${intent.kind === 'streak' ? this.span(until) : ''}${this.span(age)}`;
    }

    /** A box and a slider; at the slider's end, the box is what it says. */
    private span({ id, box, label, title, words, shown, longest, says, change }: Span): TemplateResult {
        const value = Math.min(shown ?? longest, longest);
        const set = (to: number | null): void => this.model.edits.changeSurface(change(to));
        const slid = (to: number): void => {
            if (to > longest * 0.999) set(null);
            else if (to > 0) set(to);
        };
        const step = longest / 50;
        return html`${checkRow(label, value > longest * 0.999, (on) => set(on ? null : longest / 2), { id: box, title })}
        ${sliderRow({ id, words, value, shown: says(value), low: step, high: longest, step, change: slid })}`;
    }
}

customElements.define('wakesurf-release', ReleasePanel);

export interface TimeEndsModel {
    state: AppState;
    edits: Pick<Edits, 'changeSurface' | 'intent' | 'remark'>;
}

type Typed = (value: number) => TypedTime;

/** When a surface begins and ends; of a stream surface, when its field is frozen. */
export class TimeEnds extends ModelElement<TimeEndsModel> {
    static override styles = css`
        :host {
            display: flex;
            gap: 6px;
            align-items: center;
            margin-top: 4px;
        }
        label {
            white-space: nowrap;
        }
        input {
            flex: 1;
        }
    `;

    override render(): TemplateResult {
        const { state, edits } = this.model;
        const intent = edits.intent.value;
        if (intent === null) return html``;
        const times = state.surfaceTimes.value;
        const steady = state.surfaceDataset.value?.steady ?? false;
        const frozen = intent.kind === 'stream' && !steady;
        const from: Typed = (value) => typedFrom(intent, value, times, steady);
        const to: Typed = (value) => typedTo(intent, value, times, steady);
        return html`${this.field('time-from', frozen ? 'Frozen at' : 'From', intent.from, from)}
        ${frozen ? nothing : this.field('time-to', 'To', endOf(intent, times, steady), to)}`;
    }

    private field(id: string, words: string, value: number, typed: Typed): TemplateResult {
        const { state, edits } = this.model;
        return html`<label for=${id}>${words}</label>
            ${numberField({
                ...{ id, narrow: true, shown: timeField(state, value), disabled: state.locked.value },
                change: (to) => {
                    const { change, remark } = typed(to);
                    if (change !== null) edits.changeSurface(change, undefined, remark);
                    else edits.remark.value = remark;
                    return change !== null;
                },
            })}`;
    }
}

customElements.define('wakesurf-time-ends', TimeEnds);
