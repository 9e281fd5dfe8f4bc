// The rakes of the session: choose one, give it a name and a colour, make, copy and delete, undo and redo.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { RakeRecord } from '../../protocol/messages.ts';
import { holderOf, rakeColour } from '../../session/picture/rakesInPicture.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { isolated } from '../../state/announcements.ts';
import { showsRake, toggled } from '../../state/pageView.ts';
import { titleOf } from '../base/locked.ts';
import { icon, type IconName } from '../base/icons.ts';
import { ModelElement } from '../base/signalElement.ts';

const kindWords = { line: 'line', polyline: 'polyline', circle: 'circle', points: 'points' } as const;

export interface RakeListModel {
    state: AppState;
    view: ViewState;
    edits: Edits;
}

export class RakeList extends ModelElement<RakeListModel> {
    static override styles = css`
        ul {
            display: grid;
            gap: 2px;
            max-height: 168px;
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
        .alone {
            display: flex;
            gap: 8px;
            align-items: center;
            margin-top: 6px;
            cursor: pointer;
        }
        .alone input {
            margin: 0;
            accent-color: var(--accent);
        }
        .rake {
            display: grid;
            grid-template-columns: 16px minmax(0, 1fr) auto;
            gap: 8px;
            align-items: center;
            width: 100%;
            border-color: transparent;
            background: none;
            text-align: left;
        }
        .rake[aria-pressed='true'] {
            border-color: var(--line);
            background: var(--raised);
            font-weight: 600;
        }
        svg {
            display: block;
        }
        .about {
            max-width: 84px;
            font-size: 12px;
            font-weight: 400;
        }
        .row {
            display: grid;
            gap: 6px;
            margin-top: 8px;
        }
        .actions {
            grid-template-columns: auto auto auto 1fr auto auto;
        }
        .actions button {
            padding-inline: 7px;
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
    `;

    override render(): TemplateResult {
        const { state, view, edits } = this.model;
        const visibility = view.visibility.value;
        const rakes = [...state.rakes.value.values()];
        const chosen = state.rake.value;
        const { history, actions } = edits;
        const locked = state.locked.value;
        return html`
            ${rakes.length === 0 ? html`<p class="hint">No rake: nothing is released into the flow.</p>` : nothing}
            <ul aria-label="Rakes">
                ${rakes.map((record) => this.entry(record, record === chosen))}
            </ul>
            ${
                rakes.length < 2 && !visibility.alone
                    ? nothing
                    : html`<label class="alone">
                          <input
                              id="show-alone"
                              type="checkbox"
                              .checked=${visibility.alone}
                              @change=${() => view.changeVisibility({ alone: !visibility.alone })}
                          />
                          Show only the selected rake
                      </label>`
            }
            ${chosen === undefined ? nothing : this.own(chosen, locked)}
            <div class="row actions" role="group" aria-label="Edit rakes">
                <button
                    type="button"
                    aria-label="New rake"
                    title=${titleOf(state, 'New rake, beside the chosen one')}
                    ?disabled=${locked}
                    @click=${() => actions.newRake()}
                >
                    New
                </button>
                <button
                    type="button"
                    title=${titleOf(state, 'Copy the chosen rake and its surfaces')}
                    ?disabled=${locked || chosen === undefined}
                    @click=${() => actions.duplicate(chosen!.rake)}
                >
                    Duplicate
                </button>
                <button
                    type="button"
                    ?disabled=${locked || chosen === undefined || visibility.lockedRakes.has(chosen.rake)}
                    title=${titleOf(state, 'Delete the chosen rake and its surfaces')}
                    @click=${() => actions.deleteRake(chosen!.rake)}
                >
                    Delete
                </button>
                <span></span>
                ${this.turn('Undo', '↶', 'Ctrl+Z', history.undoable.value, () => void edits.undo())}
                ${this.turn('Redo', '↷', 'Ctrl+Shift+Z', history.redoable.value, () => void edits.redo())}
            </div>
            <p class="hint" role="status" ?hidden=${history.words.value === ''}>${history.words.value}</p>
        `;
    }

    private entry(record: RakeRecord, chosen: boolean): TemplateResult {
        const { state, view, edits } = this.model;
        const { hiddenRakes, lockedRakes } = view.visibility.value;
        const shown = showsRake(view.visibility.value, record.rake, state.activeRake.value);
        const isLocked = lockedRakes.has(record.rake);
        const holder = holderOf(state, record);
        const you = state.participants.value.get(state.you.value ?? '')?.name;
        const { author = '' } = record;
        const made = author === '' ? '' : `, ${author === you ? 'yours' : `by ${isolated(author)}`}`;
        const about = holder === null ? `${kindWords[record.kind]}${made}` : `${isolated(holder.name)} is moving it`;
        return html`<li>
            <button
                type="button"
                class=${shown ? 'rake' : 'rake unseen'}
                data-rake=${record.rake}
                aria-pressed=${chosen ? 'true' : 'false'}
                title=${`${isolated(nameOf(record))}: ${about}`}
                @click=${() => edits.chooseRake(record.rake)}
            >
                ${swatch(rakeColour(record, state.rakes.value))}
                <span class="cut">${nameOf(record)}</span>
                <span class="about cut quiet">${about}</span>
            </button>
            ${this.switch(
                isLocked,
                'locked',
                'free',
                `Lock ${isolated(nameOf(record))}`,
                'Keep it from being moved on this page',
                () => view.changeVisibility({ lockedRakes: toggled(lockedRakes, record.rake) }),
            )}
            ${this.switch(
                !shown,
                'hidden',
                'seen',
                `Hide ${isolated(nameOf(record))}`,
                'Hide it and its surfaces on this page',
                () => view.changeVisibility({ hiddenRakes: toggled(hiddenRakes, record.rake), alone: false }),
            )}
        </li>`;
    }

    private switch(
        on: boolean,
        sign: IconName,
        otherwise: IconName,
        name: string,
        words: string,
        turn: () => void,
    ): TemplateResult {
        return html`<button
            type="button"
            class="switch"
            aria-label=${name}
            aria-pressed=${on ? 'true' : 'false'}
            title=${words}
            @click=${turn}
        >
            ${icon(on ? sign : otherwise)}
        </button>`;
    }

    /** Name and colour of the chosen one. */
    private own(record: RakeRecord, locked: boolean): TemplateResult {
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

    private turn(label: string, sign: string, keys: string, steps: number, action: () => void): TemplateResult {
        return html`<button
            type="button"
            aria-label=${label}
            title=${`${label} (${keys})`}
            ?disabled=${steps === 0}
            @click=${action}
        >
            ${sign}
        </button>`;
    }
}

function nameOf({ name, rake }: RakeRecord): string {
    return name === '' ? `Rake ${rake}` : name;
}

/** Presentation attributes, because style attributes are not allowed. */
function swatch(colour: string): TemplateResult {
    return html`<svg width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
        <circle cx="8" cy="8" r="6.5" fill=${colour} stroke="#0b1018" stroke-width="1.5" />
    </svg>`;
}

customElements.define('wakesurf-rake-list', RakeList);
