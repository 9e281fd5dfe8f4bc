// Shows who is in the session, whose view to take, and, for hosts, who may do what.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { Participant, Role } from '../../protocol/messages.ts';
import type { Calls } from '../../session/base/calls.ts';
import type { People } from '../../session/people/people.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { roleWords } from '../base/words.ts';
import { ModelElement } from '../base/signalElement.ts';
import { isolated } from '../../state/announcements.ts';

const roles: readonly Role[] = ['viewer', 'editor', 'host'];

export interface PeopleModel {
    state: Pick<AppState, 'participants' | 'you' | 'role' | 'notices' | 'problems'>;
    view: Pick<ViewState, 'following'>;
    calls: Pick<Calls, 'try'>;
    people: Pick<People, 'startFollowing'>;
    rename: (name: string) => Promise<void>;
    logOut: () => Promise<void>;
}

export class PeoplePanel extends ModelElement<PeopleModel> {
    static override styles = css`
        li {
            display: grid;
            grid-template-columns: 12px minmax(0, 1fr) auto auto;
            gap: 8px;
            align-items: center;
            min-height: 32px;
        }
        .dot {
            width: 12px;
            height: 12px;
            border-radius: 6px;
        }
        input {
            min-width: 0;
        }
        .away {
            opacity: 0.6;
        }
        .leave {
            margin: 6px 0 0;
            text-align: right;
        }
    `;

    override render(): TemplateResult {
        const people = [...this.model.state.participants.value.values()];
        return html`<ul aria-label="People in this session">
                ${people.map((person) => this.row(person))}
            </ul>
            <p class="leave">
                <button type="button" id="log-out" title="This browser forgets the server's token or your link" @click=${this.logOut}>Log out</button>
                <span class="quiet">You need the link again to come back.</span>
            </p>`;
    }

    protected override updated(): void {
        // Colours through the object model: the content security policy forbids style attributes.
        for (const dot of this.renderRoot.querySelectorAll<HTMLElement>('.dot')) {
            dot.style.background = dot.dataset['colour'] ?? '';
        }
    }

    private row(person: Participant): TemplateResult {
        const { participant, name, colour, connected } = person;
        const you = participant === this.model.state.you.value;
        return html`<li data-participant=${participant} class=${connected ? '' : 'away'}>
            <span class="dot" data-colour=${colour}></span>
            ${
                you
                    ? html`<input
                      aria-label="Your name"
                      maxlength="40"
                      .value=${name}
                      @change=${(event: Event) => this.model.rename((event.target as HTMLInputElement).value.trim())}
                  />`
                    : html`<span class="cut" title=${name}>${isolated(name)}${connected ? '' : ' (away)'}</span>`
            }
            ${this.mayDo(person, you)} ${you ? nothing : this.follow(person)}
        </li>`;
    }

    private mayDo({ participant, name, role }: Participant, you: boolean): TemplateResult {
        if (you || this.model.state.role.value !== 'host') return html`<span class="quiet">${roleWords[role]}</span>`;
        return html`<select
            aria-label=${`What ${isolated(name)} may do`}
            @change=${(event: Event) => this.setRole(participant, event.target as HTMLSelectElement)}
        >
            ${roles.map((each) => html`<option value=${each} .selected=${each === role}>${roleWords[each]}</option>`)}
            <option value="remove">remove</option>
        </select>`;
    }

    private follow({ participant, name, camera }: Participant): TemplateResult {
        const { people, view } = this.model;
        const following = view.following.value === participant;
        return html`<button
            type="button"
            aria-pressed=${following ? 'true' : 'false'}
            aria-label=${`Follow ${isolated(name)}`}
            ?disabled=${!following && (camera === undefined || camera === null)}
            @click=${() => people.startFollowing(following ? null : participant)}
        >
            ${following ? 'Following' : 'Follow'}
        </button>`;
    }

    /** A lesser role is for the person, wherever they come by the same link, and for the link. */
    private sayAlso({ also = [], newcomers }: { also?: string[]; newcomers?: Role }): void {
        const { notices } = this.model.state;
        if (also.length === 0 && newcomers === undefined) {
            notices.solved('role');
            return;
        }
        const places =
            also.length === 0
                ? ''
                : `This also applies to ${also.length === 1 ? 'their other window' : `their ${also.length} other windows`} in this session. `;
        const others =
            newcomers === undefined
                ? ''
                : `Anyone who uses the same link from now on ${roleWords[newcomers]}; make another link for others.`;
        notices.say('role', `${places}${others}`.trim());
    }

    private async logOut(): Promise<void> {
        try {
            await this.model.logOut();
        } catch (error) {
            this.model.state.problems.tell('log out', error);
        }
    }

    private async setRole(participant: string, choice: HTMLSelectElement): Promise<void> {
        const { calls, state } = this.model;
        const role = roles.find((each) => each === choice.value);
        const set = role === undefined ? null : await calls.try('session.setRole', { participant, role });
        const taken = role === undefined ? await calls.try('session.kick', { participant }) : set;
        if (set !== null) this.sayAlso(set);
        // Refused: nothing has changed, so nothing else puts the choice back.
        if (taken === null) choice.value = state.participants.value.get(participant)?.role ?? choice.value;
    }
}

customElements.define('wakesurf-people', PeoplePanel);
