// The sessions of this server: to go to, to make, rename, copy, save and delete; and the trash, from which
// they come back.
import { signal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { repeat } from 'lit/directives/repeat.js';
import type { SessionEntry } from '../../protocol/messages.ts';
import type { SessionList } from '../../session/sessions/sessionList.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { dialogStyles, ModelElement } from '../base/signalElement.ts';
import { fileName, saveFile } from '../base/copyAndSave.ts';
import { type CardActs, type Question, sessionCard, trashCard } from './sessionCard.ts';

const sessionsStyles = css`
    dialog {
        flex-direction: column;
        width: min(980px, 94vw);
        height: min(760px, 90vh);
        padding: 0;
        overflow: hidden;
    }
    dialog[open] {
        display: flex;
    }
    .head,
    .foot {
        display: flex;
        flex-wrap: wrap;
        gap: 8px 12px;
        align-items: center;
        padding: 12px 18px;
    }
    .head {
        border-bottom: 1px solid var(--line);
    }
    .foot {
        border-top: 1px solid var(--line);
    }
    h2 {
        flex: 1;
        margin: 0;
        font-size: 17px;
    }
    .choice {
        display: flex;
        gap: 2px;
        padding: 2px;
        border: 1px solid var(--line);
        border-radius: 8px;
    }
    .choice button {
        min-height: 26px;
        padding: 2px 12px;
        border: 0;
        background: none;
        color: var(--quiet);
    }
    .choice button[aria-pressed='true'] {
        background: var(--raised);
        color: var(--text);
        font-weight: 600;
    }
    form {
        display: flex;
        flex: 1;
        flex-wrap: wrap;
        gap: 6px;
    }
    form input {
        flex: 1 1 180px;
        min-width: 0;
        max-width: 320px;
    }
    .said {
        display: flex;
        gap: 12px;
        align-items: center;
        margin: 10px 18px 0;
        padding: 7px 12px;
        border: 1px solid var(--line);
        border-left: 4px solid var(--good);
        border-radius: 8px;
        background: var(--raised);
    }
    .said.problem {
        border-left-color: var(--warm);
    }
    .said .words {
        flex: 1;
    }
    .list {
        flex: 1;
        overflow-y: auto;
        padding: 14px 18px 18px;
    }
    .list > p {
        margin: 0 0 12px;
    }
    .search {
        width: 240px;
        margin: 0 0 12px;
    }
    ul {
        display: grid;
        grid-template-columns: repeat(auto-fill, minmax(272px, 1fr));
        gap: 14px;
    }
    .card {
        display: flex;
        flex-direction: column;
        overflow: hidden;
        border: 1px solid var(--line);
        border-radius: 10px;
        background: var(--raised);
        content-visibility: auto;
        contain-intrinsic-size: auto 320px;
    }
    .card.here {
        border-color: var(--accent);
    }
    .picture {
        display: block;
        width: 100%;
        aspect-ratio: 16 / 10;
        padding: 0;
        border: 0;
        border-bottom: 1px solid var(--line);
        border-radius: 0;
        overflow: hidden;
        background: light-dark(#e4eaf2, #0b1018);
        color: var(--quiet);
    }
    .picture:focus-visible {
        outline-offset: -3px;
    }
    .trash .picture wakesurf-session-picture {
        opacity: 0.55;
    }
    .about {
        display: flex;
        flex: 1;
        flex-direction: column;
        gap: 2px;
        padding: 9px 11px 10px;
    }
    .about p {
        margin: 0;
    }
    .name {
        display: flex;
        gap: 8px;
        align-items: baseline;
        font-size: 14px;
        font-weight: 600;
    }
    .name > span:first-child {
        flex: 1;
    }
    .badge {
        flex: none;
        padding: 0 7px;
        border-radius: 9px;
        background: var(--accent);
        color: light-dark(#ffffff, #06131b);
        font-size: 11px;
    }
    .people {
        display: flex;
        gap: 4px;
        align-items: center;
        min-height: 18px;
    }
    .dot {
        flex: none;
        width: 9px;
        height: 9px;
        border-radius: 5px;
    }
    .actions {
        display: flex;
        flex-wrap: wrap;
        gap: 5px;
        margin-top: auto;
        padding-top: 7px;
    }
    .actions button {
        min-height: 25px;
        padding: 1px 6px;
        font-size: 12px;
    }
    .rename {
        gap: 5px;
    }
    .rename input {
        flex: 1 1 100%;
        max-width: none;
    }
    .asked {
        color: var(--warm);
    }
`;

/** Fewer are found by looking. */
const searchFrom = 9;
/** Limits are told before they are met. */
const fewLeft = 10;

export interface SessionsModel {
    state: Pick<AppState, 'dataset' | 'datasets' | 'gone' | 'role' | 'session'>;
    view: Pick<ViewState, 'sessionsShown'>;
    sessionList: SessionList;
}

export class SessionsDialog extends ModelElement<SessionsModel> {
    private readonly inTrash = signal(false);
    private readonly sought = signal('');
    private readonly question = signal<{ session: string; question: Question } | null>(null);
    private look = 0;
    private watching = false;

    static override styles = [dialogStyles, sessionsStyles];

    private readonly acts: CardActs = {
        open: (entry) => (this.isHere(entry) ? this.close() : this.model.sessionList.enter(entry.session)),
        rename: ({ session }, name) => this.done(this.model.sessionList.rename(session, name)),
        copy: (entry) => this.done(this.model.sessionList.copy(entry)),
        export: (entry) => void this.save(entry),
        delete: (entry) => this.done(this.model.sessionList.delete(entry)),
        restore: (entry) => this.done(this.model.sessionList.restore(entry)),
        deleteForever: (entry) => this.done(this.model.sessionList.deleteForever(entry)),
        ask: (session, question) => (this.question.value = question === null ? null : { session, question }),
    };

    private readonly fetchPicture = (session: string): Promise<Blob | null> => this.model.sessionList.thumbnail(session);

    override render(): TemplateResult {
        const { sessionList, view } = this.model;
        if (!view.sessionsShown.value) return html`<dialog></dialog>`;
        const trash = sessionList.trash.value ?? [];
        return html`<dialog aria-labelledby="sessions-head" @close=${this.closed}>
            <div class="head">
                <h2 id="sessions-head">Sessions</h2>
                ${
                    sessionList.ownOnly.value
                        ? nothing
                        : html`<div class="choice" role="group" aria-label="Which sessions">
                          ${this.choice(`On this server (${sessionList.sessions.value?.length ?? '…'})`, false)}
                          ${this.choice(`Trash (${trash.length})`, true)}
                      </div>`
                }
                <button type="button" aria-label="Close" @click=${() => this.close()}>✕</button>
            </div>
            <div role="status" aria-live="polite">${this.said('done')}</div>
            <div role="alert">${this.trouble()}</div>
            <div class="list">${this.inTrash.value ? this.deleted() : this.kept()}</div>
            ${this.inTrash.value || sessionList.ownOnly.value ? nothing : this.making()}
        </dialog>`;
    }

    protected override updated(): void {
        const shown = this.model.view.sessionsShown.value;
        if (shown && this.dialog?.open === false) {
            this.look = Date.now();
            this.dialog.showModal();
        }
        if (shown !== this.watching) {
            this.watching = shown;
            if (shown) this.model.sessionList.watch();
            else this.model.sessionList.unwatch();
        }
        // Colours through the object model: the content security policy forbids style attributes.
        for (const dot of this.renderRoot.querySelectorAll<HTMLElement>('.dot')) {
            dot.style.background = dot.dataset['colour'] ?? '';
        }
        this.renderRoot.querySelector<HTMLInputElement>('.rename input:not(:focus)')?.select();
    }

    private get dialog(): HTMLDialogElement | null {
        return this.renderRoot.querySelector('dialog');
    }

    private close(): void {
        this.dialog?.close();
    }

    private readonly closed = (): void => {
        const { sessionList, view } = this.model;
        view.sessionsShown.value = false;
        this.inTrash.value = false;
        this.question.value = null;
        this.sought.value = '';
        sessionList.notices.solved('done');
        sessionList.problems.solved('action');
    };

    private done(action: Promise<void>): void {
        this.question.value = null;
        void action;
    }

    private choice(words: string, trash: boolean): TemplateResult {
        const choose = (): void => {
            this.inTrash.value = trash;
            this.question.value = null;
        };
        return html`<button type="button" aria-pressed=${this.inTrash.value === trash ? 'true' : 'false'} @click=${choose}>${words}</button>`;
    }

    private said(about: string): TemplateResult | typeof nothing {
        const { notices } = this.model.sessionList;
        const words = notices.all.value.get(about);
        const remedy = notices.remedyOf(about);
        if (words === undefined) return nothing;
        return html`<p class="said">
            <span class="words">${words}</span>
            ${remedy === undefined ? nothing : html`<button type="button" @click=${() => remedy.act()}>${remedy.label}</button>`}
        </p>`;
    }

    private trouble(): TemplateResult[] {
        return [...this.model.sessionList.problems.all.value.values()].map(
            (words) => html`<p class="said problem"><span class="words">${words}</span></p>`,
        );
    }

    private kept(): TemplateResult {
        const { sessionList, state } = this.model;
        const all = sessionList.sessions.value;
        if (all === null) return html`<p class="quiet">Asking the server …</p>`;
        const wanted = this.sought.value.trim().toLowerCase();
        const found = all.filter((entry) => wanted === '' || textOf(entry).includes(wanted));
        const hosts = state.role.value === 'host';
        const makes = !sessionList.ownOnly.value;
        return html`${
            all.length < searchFrom
                ? nothing
                : html`<input
                      class="search"
                      aria-label="Find a session by its name or people"
                      placeholder="Find by name or people"
                      .value=${this.sought.value}
                      @input=${(event: Event) => (this.sought.value = (event.target as HTMLInputElement).value)}
                  />`
        }
            ${makes ? nothing : html`<p class="quiet">Your link is for one session only.</p>`}
            ${found.length === 0 ? html`<p class="quiet">No session and no person matches this search.</p>` : nothing}
            <ul aria-label="Sessions on this server">
                ${repeat(
                    found,
                    ({ session }) => session,
                    (entry) => {
                        const here = this.isHere(entry);
                        return sessionCard(
                            entry,
                            {
                                here,
                                hosts,
                                makes,
                                question: this.questionOf(entry),
                                look: this.look,
                                fetchPicture: this.fetchPicture,
                            },
                            this.acts,
                        );
                    },
                )}
            </ul>`;
    }

    private deleted(): TemplateResult {
        const { trash, limits } = this.model.sessionList;
        const all = trash.value ?? [];
        if (all.length === 0) return html`<p class="quiet">The trash is empty. Deleted sessions stay here for 30 days.</p>`;
        return html`<p class="quiet">
                Deleted sessions stay here for 30 days; their links work again once they are restored.
                ${limits.value === null ? nothing : leftWords(limits.value.trash - all.length, `The trash holds up to ${limits.value.trash} sessions`)}
            </p>
            <ul aria-label="Sessions in the trash">
                ${repeat(
                    all,
                    ({ session }) => session,
                    (entry) =>
                        trashCard(
                            entry,
                            { question: this.questionOf(entry), look: this.look, fetchPicture: this.fetchPicture },
                            this.acts,
                        ),
                )}
            </ul>`;
    }

    private isHere({ session }: SessionEntry): boolean {
        const { state } = this.model;
        return session === state.session.value && state.gone.value === null;
    }

    private questionOf({ session }: SessionEntry): Question | null {
        const asked = this.question.value;
        return asked?.session === session ? asked.question : null;
    }

    private making(): TemplateResult {
        const { sessionList, state } = this.model;
        const datasets = state.datasets.value;
        const [remaining, limits, busy] = [sessionList.remaining.value, sessionList.limits.value, sessionList.busy.value];
        const shown = state.dataset.value?.dataset;
        return html`<div class="foot">
            <form aria-label="A new session" @submit=${this.create}>
                <input name="name" maxlength="80" aria-label="Name of the new session" placeholder="Name of the new session" required />
                ${
                    datasets.length < 2
                        ? nothing
                        : html`<select name="dataset" aria-label="Dataset of the new session">
                          ${datasets.map(({ dataset, name }) => html`<option value=${dataset} .selected=${dataset === shown}>${name}</option>`)}
                      </select>`
                }
                <button type="submit" ?disabled=${busy}>New session</button>
            </form>
            <button type="button" ?disabled=${busy} @click=${() => this.fileInput?.click()}>Import a file …</button>
            <input type="file" hidden accept=".json,application/json" aria-label="File of a session" @change=${this.import} />
            ${limits === null || remaining === null ? nothing : html`<span class="quiet">${leftWords(remaining, `The server keeps up to ${limits.sessions} sessions`)}</span>`}
        </div>`;
    }

    private get fileInput(): HTMLInputElement | null {
        return this.renderRoot.querySelector('input[type=file]');
    }

    private readonly create = (event: Event): void => {
        event.preventDefault();
        const values = new FormData(event.target as HTMLFormElement);
        // None of them is a file.
        const text = (field: string): string | null => values.get(field) as string | null;
        const dataset = text('dataset') ?? this.model.state.dataset.value?.dataset ?? null;
        void this.model.sessionList.create(text('name')?.trim() ?? '', dataset);
    };

    private readonly import = (event: Event): void => {
        const input = event.target as HTMLInputElement;
        const file = input.files?.[0];
        // The same file may be chosen again.
        if (file !== undefined) void this.model.sessionList.import(file).finally(() => (input.value = ''));
    };

    private async save(entry: SessionEntry): Promise<void> {
        const file = await this.model.sessionList.export(entry);
        if (file !== null) saveFile(file, fileName(entry.name, 'session.json'));
    }
}

function textOf({ name, people }: SessionEntry): string {
    return [name, ...people.map((each) => each.name)].join('\n').toLowerCase();
}

/** Said always, and with what to do where it is few. */
function leftWords(left: number, whole: string): string {
    if (left > fewLeft) return `${whole}: there is room for ${left} more.`;
    const more = left <= 0 ? 'there is no room for more' : `there is room for only ${left} more`;
    return `${whole}: ${more}. Delete sessions that are no longer needed; an exported session can be imported again.`;
}

customElements.define('wakesurf-sessions', SessionsDialog);
