// The list of what is in the picture: each thing can be hidden, shown alone, chosen, made less opaque, deleted; more is added below, and undo
// and redo are at hand.
import { css, html, nothing, svg, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import type { RakeRecord } from '../../protocol/messages.ts';
import { rakeColour } from '../../session/picture/rakesInPicture.ts';
import { isolated } from '../../state/announcements.ts';
import { chosenRake, toggled } from '../../state/pageView.ts';
import { hasBoundary } from '../../state/bodyPatches.ts';
import { newBodyRake, newLines, newSlice } from '../../state/viewState.ts';
import { icon, type IconName } from '../base/icons.ts';
import { titleOf } from '../base/locked.ts';
import { ModelElement } from '../base/signalElement.ts';
import { type PicturedThing, picturedThings, type PictureListModel, rakeName } from './picturedThings.ts';

export type { PictureListModel };

export class PictureList extends ModelElement<PictureListModel> {
    static override styles = css`
        ul {
            display: grid;
            gap: 2px;
            max-height: 200px;
            margin: 0 -6px;
            overflow-y: auto;
        }
        li {
            display: grid;
            grid-template-columns: minmax(0, 1fr) auto auto;
        }
        .switch {
            min-width: 28px;
            padding: 3px 5px;
            border-color: transparent;
            background: none;
            color: var(--quiet);
        }
        .switch svg {
            margin: auto;
        }
        .switch[aria-pressed='true'] {
            color: var(--warm);
        }
        .unseen {
            opacity: 0.55;
        }
        .thing {
            display: grid;
            grid-template-columns: 16px minmax(0, 1fr) auto;
            gap: 8px;
            align-items: center;
            width: 100%;
            border-color: transparent;
            background: none;
            text-align: left;
        }
        .thing[aria-pressed='true'] {
            border-color: var(--line);
            background: var(--raised);
            font-weight: 600;
        }
        svg {
            display: block;
        }
        .about {
            max-width: 100px;
            font-size: 12px;
            font-weight: 400;
        }
        .data {
            display: block;
            font-size: 12px;
            font-weight: 400;
        }
        .row {
            display: grid;
            gap: 6px;
            margin-top: 8px;
        }
        .add {
            display: flex;
            flex-wrap: wrap;
            align-items: center;
            gap: 6px;
            margin-top: 8px;
        }
        .add button {
            padding-inline: 7px;
            white-space: nowrap;
        }
        .actions {
            grid-template-columns: auto auto auto 1fr auto auto;
        }
        .actions button {
            padding-inline: 7px;
        }
        .actions .switch {
            border-color: var(--line);
        }
        .own {
            grid-template-columns: 34px minmax(0, 1fr);
        }
        input[type='color'] {
            width: 34px;
            height: 28px;
            padding: 2px;
            border: 1px solid var(--line);
            border-radius: 6px;
            background: var(--raised);
            cursor: pointer;
        }
        .see {
            grid-template-columns: auto minmax(0, 1fr) 4em;
            align-items: center;
        }
        .see input {
            width: 100%;
        }
        .value {
            text-align: right;
            font-variant-numeric: tabular-nums;
        }
    `;

    override render(): TemplateResult {
        const { state } = this.model;
        const things = picturedThings(this.model);
        const chosen = things.find((each) => each.chosen);
        const locked = state.locked.value;
        const rake = chosen?.kind === 'rake' ? state.rake.value : undefined;
        return html`
            ${things.length === 0 ? html`<p class="hint">Nothing yet: add a rake, an isosurface or a slice.</p>` : nothing}
            <ul aria-label="In the picture">
                ${things.map((each) => this.entry(each))}
            </ul>
            ${this.adding(locked)} ${rake === undefined ? nothing : this.ownOfRake(rake, locked)}
            ${chosen?.opacity == null ? nothing : this.opacity(chosen.opacity)} ${this.actions(chosen, rake, locked)}
            <p class="hint" role="status" ?hidden=${this.model.edits.history.words.value === ''}>${this.model.edits.history.words.value}</p>
        `;
    }

    private entry(thing: PicturedThing): TemplateResult {
        const { view } = this.model;
        const { id, name, about, data, title, shown } = thing;
        const visibility = view.visibility.value;
        const isAlone = visibility.only === id || (visibility.only === chosenRake && thing.kind === 'rake' && shown);
        return html`<li>
            <button
                type="button"
                class=${shown ? 'thing' : 'thing unseen'}
                data-thing=${id}
                aria-pressed=${thing.chosen ? 'true' : 'false'}
                title=${`${isolated(name)}: ${title}`}
                @click=${thing.choose}
            >
                ${sign(thing)}
                <span class="cut">${name}${data === undefined ? nothing : html`<span class="data cut quiet">${data}</span>`}</span>
                <span class="about cut quiet">${about}</span>
            </button>
            ${turnable(!shown, ['hidden', 'seen'], `Hide ${isolated(name)}`, 'Hide it on this page', () => {
                const hidden = new Set(visibility.hidden);
                if (shown) hidden.add(id);
                else hidden.delete(id);
                view.changeVisibility({ hidden, only: null });
            })}
            ${turnable(
                isAlone,
                ['only', 'only'],
                `Show only ${isolated(name)}`,
                'Show nothing else on this page; again: everything',
                () => view.changeVisibility({ only: isAlone ? null : id }),
            )}
        </li>`;
    }

    private adding(locked: boolean): TemplateResult {
        const { state, view, edits } = this.model;
        const { actions } = edits;
        const add = (words: string, title: string, can: boolean, action: () => void): TemplateResult =>
            html`<button
                type="button"
                aria-label=${`New ${words.toLowerCase()}`}
                title=${titleOf(state, title)}
                ?disabled=${locked || !can}
                @click=${action}
            >
                ${words}
            </button>`;
        const fresh = (action: () => Promise<unknown>) => (): void => {
            view.chosenThing.value = null;
            void action();
        };
        // A formula has no nodes.
        const levels = state.dataset.value?.points !== 0 && state.capabilities.value.includes('level');
        const levelTitle = levels ? 'Where a field has one value' : 'This flow is a formula: it has no values at nodes';
        return html`<div class="add" role="group" aria-label="Add">
            <span>Add</span>
            ${add(
                'Rake',
                'A rake with a surface, beside the others',
                true,
                fresh(() => actions.newRake()),
            )}
            ${hasBoundary(state.dataset.value) ? add('Line on a body', 'A rake that follows a body', true, () => (view.chosenThing.value = newBodyRake)) : nothing}
            ${add(
                'Isosurface',
                levelTitle,
                levels,
                fresh(() => actions.newIsosurface()),
            )}
            ${add('Slice', 'A plane through the data', true, () => (view.chosenThing.value = newSlice))}
            ${add('Lines', 'Streamlines at the time of the picture', true, () => (view.chosenThing.value = newLines))}
        </div>`;
    }

    /** Name and colour of the chosen rake. */
    private ownOfRake(record: RakeRecord, locked: boolean): TemplateResult {
        const { state, edits } = this.model;
        const change = (event: Event): string => (event.target as HTMLInputElement).value;
        // A server that knows no colours would refuse the edit.
        const colours = record.colour !== undefined;
        return html`<div class="row own" role="group" aria-label="Chosen rake">
            <input
                type="color"
                id="rake-colour"
                aria-label="Colour of the rake"
                title=${colours ? 'Colour of the rake' : 'This server does not store colours'}
                ?disabled=${locked || !colours}
                .value=${rakeColour(record, state.rakes.value)}
                @change=${(event: Event) => edits.changeRake(record.rake, { colour: change(event) })}
            />
            <input
                id="rake-name"
                aria-label="Name of the rake"
                maxlength="60"
                ?disabled=${locked}
                .value=${record.name}
                @change=${(event: Event) => edits.changeRake(record.rake, { name: change(event).trim() })}
            />
        </div>`;
    }

    private opacity({ value, change }: NonNullable<PicturedThing['opacity']>): TemplateResult {
        return html`<label class="row see" for="thing-opacity">
            <span>Opacity</span>
            <input
                id="thing-opacity"
                type="range"
                min="0.05"
                max="1"
                step="0.05"
                .value=${live(String(value))}
                @input=${(event: Event) => change((event.target as HTMLInputElement).valueAsNumber)}
            />
            <span class="value">${Math.round(100 * value)} %</span>
        </label>`;
    }

    private actions(chosen: PicturedThing | undefined, rake: RakeRecord | undefined, locked: boolean): TemplateResult {
        const { state, view, edits } = this.model;
        const { history, actions } = edits;
        const { lockedRakes } = view.visibility.value;
        const what = chosen?.kind === 'rake' ? 'rake and its surfaces' : (chosen?.kind ?? 'thing');
        return html`<div class="row actions" role="group" aria-label="Edit">
            <button
                type="button"
                ?disabled=${locked || chosen?.remove == null}
                title=${titleOf(state, chosen?.kind === 'body' ? 'The body belongs to the data: hide it' : `Delete the chosen ${what}`)}
                @click=${() => chosen?.remove?.()}
            >
                Delete
            </button>
            ${
                rake === undefined
                    ? html`<span></span><span></span>`
                    : html`<button
                              type="button"
                              title=${titleOf(state, 'Copy the chosen rake and its surfaces')}
                              ?disabled=${locked}
                              @click=${() => actions.duplicate(rake.rake)}
                          >
                              Duplicate
                          </button>
                          ${turnable(
                              lockedRakes.has(rake.rake),
                              ['locked', 'free'],
                              `Lock ${isolated(rakeName(rake))}`,
                              'Keep it from being moved on this page',
                              () => view.changeVisibility({ lockedRakes: toggled(lockedRakes, rake.rake) }),
                          )}`
            }
            <span></span>
            ${turn('Undo', '↶', 'Ctrl+Z', history.undoable.value, () => void edits.undo())}
            ${turn('Redo', '↷', 'Ctrl+Shift+Z', history.redoable.value, () => void edits.redo())}
        </div>`;
    }
}

/** @param signs while it is on, and otherwise */
function turnable(
    on: boolean,
    signs: readonly [IconName, IconName],
    name: string,
    words: string,
    turnIt: () => void,
): TemplateResult {
    return html`<button
        type="button"
        class="switch"
        aria-label=${name}
        aria-pressed=${on ? 'true' : 'false'}
        title=${words}
        @click=${turnIt}
    >
        ${icon(on ? signs[0] : signs[1])}
    </button>`;
}

function turn(label: string, mark: string, keys: string, steps: number, action: () => void): TemplateResult {
    return html`<button type="button" aria-label=${label} title=${`${label} (${keys})`} ?disabled=${steps === 0} @click=${action}>
        ${mark}
    </button>`;
}

const shapes = {
    rake: 'M8 1.5a6.5 6.5 0 1 1 0 13 6.5 6.5 0 0 1 0-13z',
    isosurface: 'M8 2c4-1.5 7 1.5 6 5-.8 3-3 3-4 5.5S4 15 2.5 11 4 3.5 8 2z',
    slice: 'M5 2h10l-4 12H1z',
    lines: 'M1 5c4-5 9 3 14-2v3c-5 5-10-3-14 2zm0 5c4-5 9 3 14-2v3c-5 5-10-3-14 2z',
    body: 'M8 1.2l6 3.4v6.8l-6 3.4-6-3.4V4.6z',
} as const;

/** Presentation attributes, because style attributes are not allowed. */
function sign({ kind, colour }: PicturedThing): TemplateResult {
    return html`<svg width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
        ${svg`<path d=${shapes[kind]} fill=${colour ?? '#8d99ab'} stroke="#0b1018" stroke-width="1.2" />`}
    </svg>`;
}

customElements.define('wakesurf-picture-list', PictureList);
