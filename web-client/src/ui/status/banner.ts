// Shows what stands in the way at the moment: no connection, data still being imported, a notice, an edit
// that was refused. Over the picture, because the panel may be scrolled.
import { css, html, LitElement, nothing, type TemplateResult } from 'lit';
import { type DatasetEntry, errorWords } from '../../protocol/messages.ts';
import type { ImportWait } from '../../session/importWait.ts';
import { velocitiesOf } from '../../session/openDataset.ts';
import { type Announcements, isolated } from '../../state/announcements.ts';
import type { AppState, GoneSession } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { ModelElement, sharedStyles } from '../base/signalElement.ts';
import { dayWords } from '../base/words.ts';

export interface BannerModel {
    state: AppState;
    view: Pick<ViewState, 'sessionsShown'>;
    imports: Pick<ImportWait, 'resume' | 'choose' | 'left' | 'stop'>;
    retryNow: () => void;
    /** Takes a link from a user whom the server does not let in; false: it is none. */
    takeLink: (text: string) => boolean;
    /** Does what can be done where the session of this page is gone. */
    restoreSession: () => Promise<void>;
    recoverSession: () => Promise<void>;
}

export class Banner extends ModelElement<BannerModel> {
    private countdown: ReturnType<typeof setInterval> | null = null;

    static override styles = css`
        .banner {
            display: flex;
            align-items: center;
            gap: 12px;
            max-width: 620px;
            margin: 0 auto 8px;
            padding: 9px 14px;
            border: 1px solid var(--line);
            border-left: 4px solid var(--accent);
            border-radius: 8px;
            background: var(--ground);
            box-shadow: 0 6px 24px rgb(0 0 0 / 0.35);
        }
        .down {
            border-left-color: var(--warm);
        }
        .words {
            flex: 1;
        }
        #velocity-unclear {
            flex-wrap: wrap;
        }
        #velocity-unclear .words {
            flex-basis: 100%;
        }
        progress {
            width: 140px;
        }
    `;

    override render(): TemplateResult {
        return html`<div role="status" aria-live="polite">
                ${this.connection()} ${this.importing()} ${this.catchingUp()} ${this.gone()}
                ${this.announced(this.model.state.notices, '')}
            </div>
            <div role="alert">${this.announced(this.model.state.problems, 'down')}</div>`;
    }

    private connection(): TemplateResult | typeof nothing {
        const { state, retryNow } = this.model;
        const connection = state.connection.value;
        this.keepCounting(connection.state === 'waiting');
        if (connection.state === 'open' || connection.state === 'broken') return nothing;
        if (connection.state === 'refused') return this.refused(connection.reason);
        if (connection.state === 'ended') return this.ended(connection.reason);
        if (connection.state === 'connecting' && connection.attempt === 1) return nothing;
        const seconds = Math.ceil(Math.max(0, state.retryAt.value - performance.now()) / 1000);
        const lead = state.everConnected.value ? 'Connection lost.' : 'No connection.';
        const reason = connection.state === 'waiting' ? connection.reason : '';
        const next = connection.state === 'waiting' ? `Trying again in ${seconds} s.` : 'Trying …';
        return html`<div class="banner down" id="connection">
            <span class="words"><strong>${lead}</strong> ${reason} ${next}</span>
            <button type="button" @click=${retryNow}>Try now</button>
        </div>`;
    }

    private refused(reason: string): TemplateResult {
        const { state, takeLink } = this.model;
        const picture = state.everConnected.value ? ' The picture stays as it was.' : '';
        return html`<div class="banner down" id="refused">
            <div class="words">
                <strong>Not connected.</strong> ${reason}${picture}
                <wakesurf-link-field .take=${takeLink}></wakesurf-link-field>
            </div>
        </div>`;
    }

    private ended(reason: string): TemplateResult {
        return html`<div class="banner down" id="ended">
            <span class="words"><strong>Connection ended.</strong> ${reason} The picture stays as it was.</span>
            <button type="button" @click=${() => location.reload()}>Reload</button>
        </div>`;
    }

    private importing(): TemplateResult | typeof nothing {
        const { state } = this.model;
        const entry = state.datasetEntry.value;
        if ((entry?.state === 'ready' || entry?.state === 'incomplete') && entry.error !== undefined) {
            return html`<div class="banner down" id="incomplete">
                <span class="words">${isolated(entry.name)} ends early: ${errorWords(entry.error)}</span>
            </div>`;
        }
        if (entry?.state === 'stopped') return this.importStopped(entry);
        if (entry !== null && velocitiesOf(entry).length > 0) return this.velocityUnclear(entry);
        if (entry === null || entry.state !== 'importing') return nothing;
        const { imports } = this.model;
        const steps = entry.steps === undefined ? '' : ` (${entry.steps.ready} of ${entry.steps.total})`;
        const left = entry.remaining === undefined ? '' : ` About ${duration(entry.remaining)} left.`;
        const waiting = state.stage.value === 'importing' ? ' It opens when the first one is ready.' : '';
        const gone = imports.left.value;
        const words = gone
            ? `You stopped waiting for ${isolated(entry.name)}. Its import continues for others${steps}.`
            : `Importing the time-steps of ${isolated(entry.name)}${steps}.${left}${waiting}`;
        return html`<div class="banner" id="importing">
            <span class="words">${words}</span>
            <progress max="1" .value=${entry.progress ?? 0} aria-label="Import"></progress>
            ${
                gone
                    ? html`<button type="button" @click=${() => imports.resume()}>Wait again</button>`
                    : html`<button type="button" @click=${() => imports.stop()}>Stop</button>`
            }
        </div>`;
    }

    private velocityUnclear(entry: DatasetEntry): TemplateResult {
        const { state, imports } = this.model;
        const viewer = state.role.value === 'viewer';
        const next = viewer ? 'Anyone who can edit can choose it.' : 'Which field do particles follow?';
        return html`<div class="banner down" id="velocity-unclear">
            <span class="words">It is not clear which field of ${isolated(entry.name)} is the velocity. ${next}</span>
            ${
                viewer
                    ? nothing
                    : velocitiesOf(entry).map(
                          (name) => html`<button type="button" @click=${() => void imports.choose(name)}>${name}</button>`,
                      )
            }
        </div>`;
    }

    private importStopped({ name, steps }: DatasetEntry): TemplateResult {
        const { state, imports } = this.model;
        const ready = steps?.ready ?? 0;
        const there =
            ready === 0
                ? `The import of ${isolated(name)} was stopped before its first time-step.`
                : `The import of ${isolated(name)} was stopped: ${ready} of ${steps.total} time-steps are here.`;
        const viewer = state.role.value === 'viewer';
        const next = viewer ? 'Anyone who can edit can resume it.' : 'It can resume where it stopped.';
        return html`<div class="banner down" id="import-stopped">
            <span class="words">${there} ${next}</span>
            ${viewer ? '' : html`<button type="button" @click=${() => imports.resume()}>Resume the import</button>`}
        </div>`;
    }

    private catchingUp(): TemplateResult | typeof nothing {
        if (this.model.state.catchingUp.value.size === 0) return nothing;
        return html`<div class="banner" id="catching-up">
            <span class="words">Catching up: the surface changes faster than this page receives it …</span>
        </div>`;
    }

    private gone(): TemplateResult | typeof nothing {
        const { gone, role } = this.model.state;
        if (gone.value === null) return nothing;
        const { name, restorableUntil, remembered } = gone.value;
        const { words, next } = goneWords(gone.value);
        return html`<div class="banner down" id="gone">
            <span class="words"><strong>${name === '' ? 'This session' : `“${isolated(name)}”`} ${words}</strong> ${next}</span>
            ${
                restorableUntil === null || role.value === 'viewer'
                    ? nothing
                    : html`<button type="button" @click=${() => this.model.restoreSession()}>Restore</button>`
            }
            ${
                restorableUntil === null && remembered
                    ? html`<button type="button" @click=${() => this.model.recoverSession()}>Recreate it</button>`
                    : nothing
            }
            <button type="button" @click=${() => (this.model.view.sessionsShown.value = true)}>Sessions</button>
        </div>`;
    }

    private announced(announcements: Announcements, kind: string): TemplateResult[] {
        return [...announcements.all.value].map(([about, words]) => {
            const remedy = announcements.remedyOf(about);
            return html`<div class="banner ${kind}" data-about=${about}>
                <span class="words">${words}</span>
                ${remedy === undefined ? nothing : html`<button type="button" @click=${() => remedy.act()}>${remedy.label}</button>`}
                <button type="button" @click=${() => announcements.solved(about)}>Dismiss</button>
            </div>`;
        });
    }

    private keepCounting(counting: boolean): void {
        if (counting && this.countdown === null) {
            this.countdown = setInterval(() => this.requestUpdate(), 500);
        } else if (!counting && this.countdown !== null) {
            clearInterval(this.countdown);
            this.countdown = null;
        }
    }
}

function duration(seconds: number): string {
    return seconds < 90 ? `${Math.max(1, Math.round(seconds))} s` : `${Math.round(seconds / 60)} min`;
}

function goneWords({ restorableUntil, remembered }: GoneSession): { words: string; next: string } {
    if (restorableUntil !== null) {
        return { words: 'was moved to the trash.', next: `It can be restored until ${dayWords(restorableUntil)}.` };
    }
    return {
        words: 'is not on this server.',
        next: remembered
            ? 'This page remembers its contents and can recreate it as a new session.'
            : 'It was deleted, or the server was started without it. Choose another session.',
    };
}

customElements.define('wakesurf-banner', Banner);

const noLink = 'There is no token in this. Paste the whole link, with the part after token=.';

/** A field for another link, on a page that the server does not let in. */
export class LinkField extends LitElement {
    static override properties = { take: { attribute: false }, wrong: { state: true } };
    /** False: what was typed is no link. */
    declare take: (text: string) => boolean;
    declare wrong: boolean;

    static override styles = [
        sharedStyles,
        css`
            form {
                display: flex;
                gap: 8px;
                margin-top: 8px;
            }
            input {
                flex: 1;
                min-width: 0;
            }
        `,
    ];

    override render(): TemplateResult {
        return html`<form @submit=${(event: SubmitEvent) => this.submit(event)}>
                <input
                    name="link"
                    aria-label="New link"
                    placeholder="Paste a new link here"
                    autocomplete="off"
                    spellcheck="false"
                    required
                />
                <button type="submit">Connect</button>
            </form>
            ${this.wrong ? html`<p role="alert">${noLink}</p>` : nothing}`;
    }

    private submit(event: SubmitEvent): void {
        event.preventDefault();
        const field = this.renderRoot.querySelector('input')!;
        this.wrong = !this.take(field.value);
        if (!this.wrong) field.value = '';
    }
}

customElements.define('wakesurf-link-field', LinkField);
