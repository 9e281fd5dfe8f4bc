// Above two pictures side by side: what each shows, and what the right one is to show.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { Signal } from '@preact/signals-core';
import { Compare } from '../../session/compare/compare.ts';
import type { Beside } from '../../session/compare/compare.ts';
import { type Half, shownWords } from '../../session/compare/half.ts';
import { timeField } from '../../session/picture/writtenNumbers.ts';
import { otherTimeRow } from '../base/otherTimeRow.ts';
import { checkRow, selectRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

/** Loaded when it is first asked for. */
export { Compare };

export type Side = 'left' | 'right';

export interface CompareBarModel {
    compare: Compare<Beside>;
    /** The half that the settings are those of. */
    chosen: Signal<Side>;
}

export class CompareBar extends ModelElement<CompareBarModel> {
    static override styles = css`
        :host {
            display: grid;
            grid-template-columns: minmax(0, 1fr) minmax(0, 1fr);
            background: var(--ground);
            border-bottom: 1px solid var(--line);
        }
        .half {
            display: flex;
            flex-wrap: wrap;
            gap: 4px 10px;
            align-items: center;
            padding: 5px 10px;
        }
        .half + .half {
            border-left: 1px solid var(--line);
        }
        .shows {
            margin: 0;
            overflow-wrap: anywhere;
        }
        .end {
            margin-left: auto;
        }
        .which[aria-pressed='true'] {
            border-color: var(--accent);
            background: var(--accent);
            color: var(--ground);
        }
        input.number {
            width: 84px;
            text-align: right;
        }
        .half .row {
            gap: 4px;
        }
        @media (max-width: 760px) {
            :host {
                grid-template-columns: minmax(0, 1fr);
            }
        }
    `;

    override render(): TemplateResult {
        const { compare } = this.model;
        const right = compare.right.value;
        if (right === null) return html``;
        return html`
            <div class="half" role="group" aria-label="Left half">
                ${this.which('left')}
                <p class="shows" id="left-shows">${shownWords(compare.left)}</p>
            </div>
            <div class="half" role="group" aria-label="Right half">
                ${this.which('right')}
                <p class="shows" id="right-shows">${shownWords(right)}</p>
                ${this.data()} ${this.time(right)}
                ${checkRow('Move together', compare.moveTogether.value, (on) => (compare.moveTogether.value = on), { id: 'move-together', title: 'Rakes, slices and streamlines that both halves have' })}
                <button type="button" class="end" id="end-compare" @click=${() => void compare.end()}>End</button>
            </div>
        `;
    }

    private which(side: Side): TemplateResult {
        const { chosen } = this.model;
        const words = side === 'left' ? 'Left' : 'Right';
        return html`<button
            type="button"
            class="which"
            id=${`choose-${side}`}
            title=${`Show the settings of the ${side} half in the panel`}
            aria-pressed=${chosen.value === side ? 'true' : 'false'}
            @click=${() => (chosen.value = side)}
        >
            ${words}
        </button>`;
    }

    private data(): TemplateResult | typeof nothing {
        const { compare } = this.model;
        const { state } = compare.left;
        const choices = state.datasets.value.map(({ dataset, name }) => ({ value: dataset, words: name }));
        if (choices.length < 2) return nothing;
        return selectRow('compare-data', 'Data', choices, compare.dataset.value, (dataset) => void compare.begin(dataset));
    }

    private time(right: Half): TemplateResult {
        const { time } = this.model.compare;
        return otherTimeRow({
            ...{ id: 'compare-time', words: 'Time', chosen: time.value },
            first: { by: 0, time: right.playback.time.value },
            written: (number) => timeField(right.state, number),
            change: (chosen) => (time.value = chosen),
        });
    }
}

customElements.define('wakesurf-compare-bar', CompareBar);
