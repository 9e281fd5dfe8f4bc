// When a surface begins and ends, to be typed; of a stream surface, when its field is frozen.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { Edits } from '../../session/edits/edits.ts';
import { endOf, typedFrom, type TypedTime, typedTo } from '../../session/edits/surfaceTimes.ts';
import { timeField } from '../../session/picture/writtenNumbers.ts';
import type { AppState } from '../../state/appState.ts';
import { numberField } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

export interface TimeEndsModel {
    state: AppState;
    edits: Pick<Edits, 'changeSurface' | 'intent' | 'remark'>;
}

type Typed = (value: number) => TypedTime;

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
        const times = state.times.value;
        const steady = state.dataset.value?.steady ?? false;
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
                    const { change, told } = typed(to);
                    if (change !== null) edits.changeSurface(change, undefined, told);
                    else edits.remark.value = told;
                    return change !== null;
                },
            })}`;
    }
}

customElements.define('wakesurf-time-ends', TimeEnds);
