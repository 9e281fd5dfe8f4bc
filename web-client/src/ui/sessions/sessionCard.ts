// One session of the list: its picture, who was in it and when, and what can be done with it. An image cannot show the login, so it is
// fetched; once it is looked at.
import { css, html, LitElement, nothing, type PropertyValues, type TemplateResult } from 'lit';
import type { SessionEntry } from '../../protocol/messages.ts';
import { isolated } from '../../state/announcements.ts';
import { agoWords, dayWords } from '../base/words.ts';

/** What is asked about a session before it is done. */
export type Question = 'rename' | 'delete' | 'forever';

export interface CardActs {
    open: (entry: SessionEntry) => void;
    rename: (entry: SessionEntry, name: string) => void;
    copy: (entry: SessionEntry) => void;
    export: (entry: SessionEntry) => void;
    delete: (entry: SessionEntry) => void;
    restore: (entry: SessionEntry) => void;
    deleteForever: (entry: SessionEntry) => void;
    /** Null: no longer. */
    ask: (session: string, question: Question | null) => void;
}

export interface CardState {
    /** The page is in it. */
    here: boolean;
    question: Question | null;
    /** May rename and delete it. */
    hosts: boolean;
    /** May make others. */
    makes: boolean;
    /** Pictures of an earlier look at the list may be old. */
    look: number;
    fetchPicture: (session: string) => Promise<Blob | null>;
}

export function sessionCard(entry: SessionEntry, card: CardState, acts: CardActs): TemplateResult {
    const { session, name, participants } = entry;
    const others = participants - (card.here ? 1 : 0);
    return html`<li class="card ${card.here ? 'here' : ''}" data-session=${session}>
        ${picture(entry, card, card.here ? `Continue in ${isolated(name)}` : `Open ${isolated(name)}`, () => acts.open(entry))}
        <div class="about">
            <p class="name"><span class="cut" title=${name}>${name}</span>${card.here ? html`<span class="badge">you are here</span>` : nothing}</p>
            <p class="quiet">${useWords(entry, others, card.here)}</p>
            <p class="quiet">${contentWords(entry)}</p>
            ${people(entry)}
            ${
                card.question === 'rename'
                    ? renaming(entry, acts)
                    : card.question === 'delete'
                      ? deleting(entry, others, acts)
                      : html`<div class="actions">
                        ${card.here ? nothing : html`<button type="button" @click=${() => acts.open(entry)}>Open</button>`}
                        ${card.hosts ? html`<button type="button" @click=${() => acts.ask(session, 'rename')}>Rename</button>` : nothing}
                        ${card.makes ? html`<button type="button" @click=${() => acts.copy(entry)}>Copy</button>` : nothing}
                        <button type="button" @click=${() => acts.export(entry)}>Export</button>
                        ${
                            card.hosts && session !== 'main'
                                ? html`<button type="button" @click=${() => (others > 0 ? acts.ask(session, 'delete') : acts.delete(entry))}>
                                  Delete
                              </button>`
                                : nothing
                        }
                    </div>`
            }
        </div>
    </li>`;
}

export function trashCard(
    entry: SessionEntry,
    { question, ...pictures }: Pick<CardState, 'question' | 'look' | 'fetchPicture'>,
    acts: CardActs,
): TemplateResult {
    const { session, name, deletedAt = '', deletedUntil = '' } = entry;
    return html`<li class="card trash" data-session=${session}>
        ${picture(entry, pictures, `Restore ${isolated(name)}`, () => acts.restore(entry))}
        <div class="about">
            <p class="name"><span class="cut" title=${name}>${name}</span></p>
            <p class="quiet">Deleted ${agoWords(deletedAt)}, kept until ${dayWords(deletedUntil)}</p>
            <p class="quiet">${contentWords(entry)}</p>
            ${people(entry)}
            ${
                question === 'forever'
                    ? html`<p class="asked">This cannot be undone.</p>
                      <div class="actions">
                          <button type="button" @click=${() => acts.deleteForever(entry)}>Delete permanently</button>
                          <button type="button" @click=${() => acts.ask(session, null)}>Keep</button>
                      </div>`
                    : html`<div class="actions">
                      <button type="button" @click=${() => acts.restore(entry)}>Restore</button>
                      <button type="button" @click=${() => acts.ask(session, 'forever')}>Delete permanently …</button>
                  </div>`
            }
        </div>
    </li>`;
}

function picture(
    { session, thumbnail }: SessionEntry,
    { look, fetchPicture }: Pick<CardState, 'look' | 'fetchPicture'>,
    label: string,
    open: () => void,
): TemplateResult {
    const name = thumbnail ? label : `${label}, no picture yet`;
    return html`<button type="button" class="picture" aria-label=${name} title=${label} @click=${open}>
        ${
            thumbnail
                ? html`<wakesurf-session-picture .session=${session} .look=${look} .fetchPicture=${fetchPicture}></wakesurf-session-picture>`
                : 'no picture yet'
        }
    </button>`;
}

function people({ people: all }: SessionEntry): TemplateResult {
    const names = all.map(({ name }) => isolated(name)).join(', ');
    return html`<p class="people quiet" title=${names}>
        ${all.map(({ colour }) => html`<span class="dot" data-colour=${colour}></span>`)}
        <span class="cut">${names}</span>
    </p>`;
}

function renaming(entry: SessionEntry, acts: CardActs): TemplateResult {
    const save = (event: Event): void => {
        event.preventDefault();
        const name = new FormData(event.target as HTMLFormElement).get('name');
        if (typeof name === 'string' && name.trim() !== '') acts.rename(entry, name.trim());
    };
    return html`<form class="rename actions" @submit=${save}>
        <input name="name" required maxlength="80" aria-label=${`New name of ${isolated(entry.name)}`} .value=${entry.name} />
        <button type="submit">Save</button>
        <button type="button" @click=${() => acts.ask(entry.session, null)}>Cancel</button>
    </form>`;
}

function deleting(entry: SessionEntry, others: number, acts: CardActs): TemplateResult {
    return html`<p class="asked">${others === 1 ? 'Someone else is' : `${others} others are`} in it now.</p>
        <div class="actions">
            <button type="button" @click=${() => acts.delete(entry)}>Delete anyway</button>
            <button type="button" @click=${() => acts.ask(entry.session, null)}>Keep</button>
        </div>`;
}

function useWords({ lastUsed }: SessionEntry, others: number, here: boolean): string {
    if (others > 0) return `${others === 1 ? '1 person' : `${others} people`} here${here ? ' besides you' : ' now'}`;
    return here ? 'no one else is here' : `last used ${agoWords(lastUsed)}`;
}

function contentWords({ rakes, surfaces, annotations, bookmarks, edited }: SessionEntry): string {
    if (!edited) return 'nothing edited yet';
    const counts: [number, string][] = [
        [rakes, 'rake'],
        [surfaces, 'surface'],
        [annotations, 'note'],
        [bookmarks, 'view'],
    ];
    const words = counts.filter(([count]) => count > 0).map(([count, word]) => `${count} ${word}${count === 1 ? '' : 's'}`);
    return words.length === 0 ? 'empty' : words.join(', ');
}

export class SessionPicture extends LitElement {
    static override properties = {
        session: {},
        look: {},
        fetchPicture: { attribute: false },
        address: { state: true },
    };
    declare session: string;
    /** Another one than before: the picture may be another as well. */
    declare look: number;
    declare fetchPicture: (session: string) => Promise<Blob | null>;
    declare address: string | null;
    private seen = false;
    private readonly observer = new IntersectionObserver((entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        this.observer.disconnect();
        this.seen = true;
        void this.load();
    });

    static override styles = css`
        :host {
            display: block;
            width: 100%;
            height: 100%;
        }
        img {
            display: block;
            width: 100%;
            height: 100%;
            object-fit: cover;
        }
    `;

    constructor() {
        super();
        this.address = null;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        this.observer.observe(this);
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.observer.disconnect();
        this.show(null);
    }

    protected override updated(changed: PropertyValues<this>): void {
        if (this.seen && (changed.has('session') || changed.has('look'))) void this.load();
    }

    override render(): TemplateResult | typeof nothing {
        return this.address === null ? nothing : html`<img alt="" src=${this.address} />`;
    }

    private async load(): Promise<void> {
        const { session, look } = this;
        const image = await this.fetchPicture(session);
        if (this.isConnected && session === this.session && look === this.look) this.show(image);
    }

    private show(image: Blob | null): void {
        if (this.address !== null) URL.revokeObjectURL(this.address);
        this.address = image === null ? null : URL.createObjectURL(image);
    }
}

customElements.define('wakesurf-session-picture', SessionPicture);
