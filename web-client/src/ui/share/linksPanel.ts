// Links for others, each with what it allows; and a copy of the session to go on alone with.
import { css, html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import type { ResultOf, Role } from '../../protocol/messages.ts';
import type { AppModel } from '../base/appModel.ts';
import { copyText } from '../base/copyText.ts';
import { roleWords } from './roleWords.ts';
import { listStyles } from '../base/listStyles.ts';
import { sharedStyles } from '../base/sharedStyles.ts';
import { SignalElement } from '../base/signalElement.ts';

type Share = ResultOf<'session.shares'>['shares'][number];

const lifetimes = [
    { seconds: 3600, words: 'for an hour' },
    { seconds: 86_400, words: 'for a day' },
    { seconds: 604_800, words: 'for a week' },
    { seconds: null, words: 'until taken back' },
];

export class LinksPanel extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;
    private readonly made = signal<{ link: string; role: Role } | null>(null);
    private readonly shares = signal<readonly Share[]>([]);
    private readonly copied = signal(false);
    private readonly forked = signal<string | null>(null);

    static override styles = [
        sharedStyles,
        listStyles,
        css`
            .new,
            .made {
                display: grid;
                grid-template-columns: 1fr 1fr;
                gap: 6px;
            }
            .new button {
                grid-column: 1 / 3;
            }
            .made {
                grid-template-columns: minmax(0, 1fr) auto;
                margin-top: 8px;
            }
            input {
                min-width: 0;
            }
            ul {
                margin-top: 8px;
            }
            li {
                display: flex;
                justify-content: space-between;
                align-items: center;
                gap: 8px;
                min-height: 32px;
            }
            li button {
                flex: none;
            }
            a {
                color: var(--accent);
            }
            p {
                margin: 6px 0;
            }
            .fork {
                margin-top: 10px;
            }
        `,
    ];

    override connectedCallback(): void {
        super.connectedCallback();
        void this.list();
    }

    override render(): TemplateResult {
        const { state } = this.model;
        if (state.role.value !== 'host') {
            return html`<p class="quiet">Only hosts can make links for others.</p>`;
        }
        const made = this.made.value;
        return html`
            <div class="new">
                <select id="share-role" aria-label="What the link allows">
                    <option value="editor">to edit</option>
                    <option value="viewer">to look on</option>
                </select>
                <select id="share-lifetime" aria-label="How long the link holds">
                    ${lifetimes.map(({ words }, i) => html`<option value=${i}>${words}</option>`)}
                </select>
                <button type="button" id="share" @click=${this.make}>Make a link</button>
            </div>
            ${made === null
                ? nothing
                : html`<div class="made">
                          <input id="share-link" readonly aria-label="Link" .value=${made.link} />
                          <button type="button" @click=${() => this.copy(made.link)}>
                              ${this.copied.value ? 'Copied' : 'Copy'}
                          </button>
                      </div>
                      <p class="quiet">Whoever opens this link ${roleWords[made.role]}. It is not shown again.</p>`}
            ${this.shares.value.length === 0
                ? nothing
                : html`<ul aria-label="Links that hold">
                      ${this.shares.value.map((share) => this.share(share))}
                  </ul>`}
            <div class="fork">
                <button type="button" id="fork" @click=${this.fork}>Go on with a copy</button>
                ${this.forked.value === null
                    ? nothing
                    : html`<p>
                          <a id="forked" href=${this.forked.value} target="_blank" rel="noopener">Open the copy</a>:
                          the same rakes and surfaces, and nobody else in it.
                      </p>`}
            </div>
        `;
    }

    private share({ grant, role, expires }: Share): TemplateResult {
        const until = expires === undefined ? 'until taken back' : `until ${momentWords(new Date(expires * 1000))}`;
        return html`<li>
            <span>${role === 'viewer' ? 'to look on' : role === 'editor' ? 'to edit' : 'to host'}, ${until}</span>
            <button type="button" @click=${() => this.takeBack(grant)}>Take back</button>
        </li>`;
    }

    private chosen(id: string): string {
        return this.renderRoot.querySelector<HTMLSelectElement>(`#${id}`)?.value ?? '';
    }

    private async make(): Promise<void> {
        const role = this.chosen('share-role') === 'viewer' ? 'viewer' : 'editor';
        const seconds = lifetimes[Number(this.chosen('share-lifetime'))]?.seconds ?? null;
        const made = await this.model.calls.try('session.share', {
            role,
            ...(seconds === null ? {} : { expiresIn: seconds }),
        });
        if (made === null) return;
        this.copied.value = false;
        const state = new URLSearchParams(new URL(this.model.views.link()).hash.slice(1)).get('state') ?? '';
        // Whoever comes by it sees what is seen here.
        this.made.value = { link: `${new URL(made.link, location.href).href}&state=${state}`, role };
        await this.list();
    }

    private async copy(link: string): Promise<void> {
        this.copied.value = await copyText(link);
        // Where the page may not copy, the user can.
        if (!this.copied.value) this.renderRoot.querySelector<HTMLInputElement>('#share-link')?.select();
    }

    private async list(): Promise<void> {
        if (this.model.state.role.value !== 'host') return;
        const listed = await this.model.worker.call('session.shares', {}).catch(() => null);
        if (listed !== null) this.shares.value = listed.shares;
    }

    private async takeBack(grant: string): Promise<void> {
        await this.model.calls.try('session.unshare', { grant });
        await this.list();
    }

    private async fork(): Promise<void> {
        const fork = await this.model.calls.try('session.fork', {});
        if (fork === null) return;
        const link = new URL(location.href);
        link.hash = `session=${encodeURIComponent(fork.session)}`;
        this.forked.value = link.href;
    }
}

/** To the minute, and the day where it is not today. */
function momentWords(moment: Date): string {
    const today = moment.toDateString() === new Date().toDateString();
    return moment.toLocaleString([], { ...(today ? {} : { dateStyle: 'medium' }), timeStyle: 'short' });
}

customElements.define('wakesurf-links', LinksPanel);
