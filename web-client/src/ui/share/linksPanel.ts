// Links for others, each with what it allows; and a copy of the session to go on alone with.
import { css, html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import type { Role, ShareLink } from '../../protocol/messages.ts';
import type { Calls } from '../../session/base/calls.ts';
import type { Views } from '../../session/view/views.ts';
import type { AppState } from '../../state/appState.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { copyText } from '../base/copyAndSave.ts';
import { momentWords, roleWords } from '../base/words.ts';
import '../base/locked.ts';
import type { OwnCopyButton } from '../base/locked.ts';
import { ModelElement } from '../base/signalElement.ts';
import { isolated } from '../../state/announcements.ts';

/** The first is the server's, which is less for who came by a link that ends before. */
const lifetimes = [
    { seconds: undefined, words: 'for 7 days' },
    { seconds: 3600, words: 'for an hour' },
    { seconds: 86_400, words: 'for a day' },
    { seconds: 2_592_000, words: 'for 30 days' },
    { seconds: null, words: 'until revoked' },
];

const purposes: Record<Role, string> = { viewer: 'To look', editor: 'To edit', host: 'To edit and invite' };

export interface LinksModel {
    state: Pick<AppState, 'role'>;
    calls: Pick<Calls, 'try'>;
    views: Pick<Views, 'link'>;
    worker: Pick<WorkerClient, 'call'>;
    ownCopy: OwnCopyButton['model'];
}

export class LinksPanel extends ModelElement<LinksModel> {
    private readonly made = signal<{ link: string; role: Role; expires: number | undefined } | null>(null);
    private readonly shares = signal<readonly ShareLink[]>([]);
    /** The link that is about to be taken back, and has made others. */
    private readonly confirming = signal<string | null>(null);
    private readonly copied = signal(false);

    static override styles = css`
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
            flex-wrap: wrap;
            justify-content: space-between;
            align-items: center;
            gap: 4px 8px;
            padding: 5px 0;
            border-top: 1px solid var(--line);
        }
        li > span {
            flex: 1;
            min-width: 60%;
        }
        li small {
            display: block;
            font-size: 12px;
            color: var(--quiet);
        }
        li button {
            flex: none;
        }
        li p {
            flex: 1 1 100%;
            margin: 2px 0;
            color: var(--warm);
        }
        a {
            color: var(--accent);
        }
        p {
            margin: 6px 0;
        }
    `;

    override connectedCallback(): void {
        super.connectedCallback();
        void this.list();
    }

    override render(): TemplateResult {
        const { state } = this.model;
        if (state.role.value !== 'host') {
            return html`<p class="quiet">Only people who can invite can make links for others.</p>
                ${this.ownCopy()}`;
        }
        const made = this.made.value;
        return html`
            <div class="new">
                <select id="share-role" aria-label="What the link allows">
                    <option value="editor">to edit</option>
                    <option value="viewer">to look</option>
                </select>
                <select id="share-lifetime" aria-label="How long the link is valid">
                    ${lifetimes.map(({ words }, i) => html`<option value=${i}>${words}</option>`)}
                </select>
                <button type="button" id="share" @click=${this.make}>Make a link</button>
            </div>
            <p class="quiet">A link is valid for 7 days unless you choose another time here. You can revoke it at any time.</p>
            ${
                made === null
                    ? nothing
                    : html`<div class="made">
                          <input id="share-link" readonly aria-label="Link" .value=${made.link} />
                          <button type="button" @click=${() => this.copy(made.link)}>
                              ${this.copied.value ? 'Copied' : 'Copy'}
                          </button>
                      </div>
                      <p class="quiet">Anyone who opens this link ${roleWords[made.role]}. It is valid until ${untilWords(made.expires)}, and it is not shown again.</p>`
            }
            ${
                this.shares.value.length === 0
                    ? nothing
                    : html`<ul aria-label="Valid links">
                      ${this.shares.value.map((share) => this.share(share))}
                  </ul>`
            }
            ${this.ownCopy()}
        `;
    }

    private ownCopy(): TemplateResult {
        return html`<p class="quiet">A copy has the same rakes and surfaces, and no one else in it. Everyone who has a link may make copies; they last as long as the link.</p>
            <wakesurf-own-copy .model=${this.model.ownCopy}></wakesurf-own-copy>`;
    }

    private share(share: ShareLink): TemplateResult {
        const { grant, role, expires, children = 0 } = share;
        const asked = this.confirming.value === grant;
        const back = (): void => {
            if (children === 0) void this.takeBack(grant, false);
            else this.confirming.value = grant;
        };
        return html`<li data-grant=${grant}>
            <span
                >${purposes[role]}, until ${untilWords(expires)}<small>${makerWords(share)}</small>${
                    children === 0
                        ? nothing
                        : html`<small>${children === 1 ? '1 link or copy was' : `${children} links and copies were`} made by people who used it</small>`
                }</span
            >
            ${
                asked
                    ? html`<p>Revoke what those people made as well?</p>
                      <button type="button" @click=${() => this.takeBack(grant, true)}>${children === 1 ? 'Both' : `All ${children + 1}`}</button>
                      <button type="button" @click=${() => this.takeBack(grant, false)}>Only this one</button>
                      <button type="button" @click=${() => (this.confirming.value = null)}>Cancel</button>`
                    : html`<button type="button" @click=${back}>Revoke</button>`
            }
        </li>`;
    }

    private chosen(id: string): string {
        return this.renderRoot.querySelector<HTMLSelectElement>(`#${id}`)?.value ?? '';
    }

    private async make(): Promise<void> {
        const role = this.chosen('share-role') === 'viewer' ? 'viewer' : 'editor';
        const { seconds } = lifetimes[Number(this.chosen('share-lifetime'))] ?? lifetimes[0]!;
        const made = await this.model.calls.try('session.share', {
            role,
            ...(seconds === undefined ? {} : { expiresIn: seconds }),
        });
        if (made === null) return;
        this.copied.value = false;
        const state = new URLSearchParams(new URL(this.model.views.link()).hash.slice(1)).get('state') ?? '';
        // Those who come by it see what is seen here.
        this.made.value = { link: `${new URL(made.link, location.href).href}&state=${state}`, role, expires: made.expires };
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

    private async takeBack(grant: string, children: boolean): Promise<void> {
        this.confirming.value = null;
        await this.model.calls.try('session.unshare', { grant, ...(children ? { children } : {}) });
        await this.list();
    }
}

function untilWords(expires: number | undefined): string {
    return expires === undefined ? 'it is revoked' : momentWords(new Date(expires * 1000));
}

function makerWords({ madeBy, newcomers, role }: ShareLink): string {
    const maker = madeBy === undefined ? '' : madeBy.name === '' ? 'made by a script' : `made by ${isolated(madeBy.name)}`;
    const lessened = newcomers === undefined || newcomers === role ? '' : `anyone who uses it now ${roleWords[newcomers]}`;
    return [maker, lessened].filter((words) => words !== '').join('; ');
}

customElements.define('wakesurf-links', LinksPanel);
