// Views of the picture under names, for every user in the session.
import { css, html, nothing, type TemplateResult } from 'lit';
import type { BookmarkRecord } from '../../protocol/messages.ts';
import { timeText } from '../../session/picture/writtenNumbers.ts';
import { isolated } from '../../state/announcements.ts';
import { readPageView } from '../../state/pageView.ts';
import type { Calls } from '../../session/base/calls.ts';
import type { ClockControl } from '../../session/time/clockControl.ts';
import type { Views } from '../../session/view/views.ts';
import type { AppState } from '../../state/appState.ts';
import { ModelElement } from '../base/signalElement.ts';

export interface BookmarksModel {
    state: Pick<AppState, 'bookmarks' | 'clock' | 'dataset' | 'role' | 'surfaces'>;
    views: Pick<Views, 'current' | 'show'>;
    calls: Pick<Calls, 'try'>;
    clock: Pick<ClockControl, 'set'>;
}

export class BookmarksPanel extends ModelElement<BookmarksModel> {
    static override styles = css`
        form {
            display: grid;
            grid-template-columns: minmax(0, 1fr) auto;
            gap: 6px;
        }
        ul {
            margin-top: 6px;
        }
        li {
            display: grid;
            grid-template-columns: minmax(0, 1fr) auto;
            gap: 6px;
            margin-top: 4px;
        }
        .go {
            text-align: left;
        }
    `;

    override render(): TemplateResult {
        const { state } = this.model;
        const bookmarks = [...state.bookmarks.value.values()];
        const viewer = state.role.value === 'viewer';
        return html`
            ${
                viewer
                    ? nothing
                    : html`<form @submit=${this.add}>
                      <input id="bookmark-name" required maxlength="60" aria-label="Name of the view" placeholder="Name of this view" />
                      <button type="submit">Keep</button>
                  </form>`
            }
            <ul aria-label="Saved views">
                ${bookmarks.map((bookmark) => this.row(bookmark, viewer))}
            </ul>
        `;
    }

    private row(record: BookmarkRecord, viewer: boolean): TemplateResult {
        const { bookmark, name, time } = record;
        return html`<li>
            <button type="button" class="go cut" title=${name} @click=${() => this.show(record)}>
                ${isolated(name)}${time === undefined ? nothing : html` <span class="quiet">t = ${timeText(this.model.state, time)}</span>`}
            </button>
            ${
                viewer
                    ? nothing
                    : html`<button
                      type="button"
                      aria-label=${`Delete the view ${isolated(name)}`}
                      @click=${() => this.model.calls.try('bookmark.delete', { bookmark })}
                  >
                      ✕
                  </button>`
            }
        </li>`;
    }

    private async add(event: Event): Promise<void> {
        event.preventDefault();
        const { state, views, calls } = this.model;
        const input = this.renderRoot.querySelector<HTMLInputElement>('#bookmark-name');
        const name = input?.value.trim() ?? '';
        if (input === null || name === '') return;
        const time = state.clock.value?.time ?? null;
        const view = { ...views.current() };
        const made = await calls.try('bookmark.set', { name, view, ...(time === null ? {} : { time }) });
        if (made !== null) input.value = '';
    }

    /** The time as well, which every user shares, where there is one and this page may set it. */
    private show({ view, time }: BookmarkRecord): void {
        const { state, views, clock } = this.model;
        views.show(readPageView(view));
        if (time !== undefined && state.role.value !== 'viewer' && state.clock.value?.time !== time) clock.set(time);
    }
}

customElements.define('wakesurf-bookmarks', BookmarksPanel);
