// The panel at the side: what is shown and how it may be changed, a tab for each subject; below, always in
// sight, how far the server has come.
import { css, html, nothing, type TemplateResult } from 'lit';
import { type ReadonlySignal, signal } from '@preact/signals-core';
import { surfaceSteps, meshSteps, shareSteps, viewSteps } from '../session/out/panelSteps.ts';
import type { ScriptStep } from '../session/out/scripts.ts';
import type { AppState } from '../state/appState.ts';
import { newBodyRake, newLines, type ViewState } from '../state/viewState.ts';
import './view/bookmarksPanel.ts';
import type { BookmarksModel } from './view/bookmarksPanel.ts';
import './datasetHead.ts';
import type { DatasetHeadModel } from './datasetHead.ts';
import './help/helpDialog.ts';
import type { HelpModel } from './help/helpDialog.ts';
import type { OwnCopy } from '../session/sessions/ownCopy.ts';
import './base/locked.ts';
import type { LinksModel } from './share/linksPanel.ts';
import './share/notesPanel.ts';
import type { NotesModel } from './share/notesPanel.ts';
import './look/lookPanel.ts';
import type { LookModel } from './look/lookPanel.ts';
import './share/peoplePanel.ts';
import type { PeopleModel } from './share/peoplePanel.ts';
import './view/probePanel.ts';
import type { ProbeModel } from './view/probePanel.ts';
import './picture/pictureList.ts';
import type { PictureListModel } from './picture/pictureList.ts';
import './rake/rakePanel.ts';
import type { RakeModel } from './rake/rakePanel.ts';
import { ModelElement } from './base/signalElement.ts';
import './status/statusPanel.ts';
import type { StatusModel } from './status/statusPanel.ts';
import './sessions/sessionHead.ts';
import type { SessionHeadModel } from './sessions/sessionHead.ts';
import './surface/surfacePanel.ts';
import type { SurfaceModel } from './surface/surfacePanel.ts';
import type { MeansModel } from './slices/meansPanel.ts';
import type { LinesModel } from './lines/linesPanel.ts';
import type { BodyRakesModel } from './rake/bodyRakePanel.ts';
import type { SlicesModel } from './slices/slicesPanel.ts';
import './view/surroundingsPanel.ts';
import type { ToolsModel } from './view/viewButtons.ts';
import type { SurroundingsModel } from './view/surroundingsPanel.ts';
import type { FilmExportModel, PictureExportModel } from './out/pictureExport.ts';
import { chosenMesh, type MeshExportModel } from './out/meshExport.ts';
import type { AnimationExportModel } from './out/animationExport.ts';
import { isolated } from '../state/announcements.ts';
import { bodyId } from '../state/pageView.ts';

// Nobody needs it before the first picture.
void import('./share/linksPanel.ts');
void import('./slices/meansPanel.ts');

export interface ExportModel {
    picture: PictureExportModel;
    film: FilmExportModel;
    mesh: MeshExportModel;
    animation: AnimationExportModel;
}

// Opened on demand, in one file of the bundle.
void import('./out/openedExports.ts');

function exportBody(model: ExportModel): TemplateResult {
    return html`
        <section aria-labelledby="picture-head">
            <h2 id="picture-head">Picture</h2>
            <wakesurf-picture-export .model=${model.picture}></wakesurf-picture-export>
        </section>
        <section aria-labelledby="film-head">
            <h2 id="film-head">Film of the playback</h2>
            <wakesurf-film-export .model=${model.film}></wakesurf-film-export>
        </section>
        <section aria-labelledby="animation-head">
            <h2 id="animation-head">Animation in one file</h2>
            <wakesurf-animation-export .model=${model.animation}></wakesurf-animation-export>
        </section>
        <section aria-labelledby="mesh-head">
            <h2 id="mesh-head">Mesh of the surface</h2>
            <wakesurf-mesh-export .model=${model.mesh}></wakesurf-mesh-export>
        </section>
    `;
}

/** What each of its parts takes, by the name of the part. */
export interface PanelModel {
    /** Of the right half of a comparison, which goes with it. */
    beside: boolean;
    /** What the scripts that are offered below a part are made of. */
    state: AppState;
    view: ViewState;
    comparison: ToolsModel['comparison'];
    ownCopy: OwnCopy;
    help: HelpModel;
    sessionHead: SessionHeadModel;
    datasetHead: DatasetHeadModel;
    pictureList: PictureListModel;
    surface: SurfaceModel;
    rake: RakeModel;
    /** Null: not loaded yet. */
    slices: ReadonlySignal<SlicesModel | null>;
    /** Likewise. */
    lines: ReadonlySignal<LinesModel | null>;
    /** Likewise. */
    bodyRakes: ReadonlySignal<BodyRakesModel | null>;
    means: MeansModel;
    look: LookModel;
    bookmarks: BookmarksModel;
    probe: ProbeModel;
    surroundings: SurroundingsModel;
    people: PeopleModel;
    links: LinksModel;
    notes: NotesModel;
    export: ExportModel;
    status: StatusModel;
}

/** Of what is chosen in the list. */
function settingsOfChosen(model: PanelModel): TemplateResult {
    const { state, view, slices, lines, bodyRakes } = model;
    const thing = view.chosenThing.value;
    if (thing === bodyId) {
        return html`<section aria-labelledby="body-head">
            <h2 id="body-head">Body</h2>
            <wakesurf-body .model=${model.look}></wakesurf-body>
        </section>`;
    }
    if (thing === newLines || state.lines.value.has(thing ?? '')) {
        return html`<section aria-labelledby="streamlines-head">
            <h2 id="streamlines-head">Streamlines</h2>
            ${lines.value === null ? nothing : html`<wakesurf-streamlines .model=${lines.value}></wakesurf-streamlines>`}
        </section>`;
    }
    if (thing === newBodyRake) {
        return html`<section aria-labelledby="body-rake-head">
            <h2 id="body-rake-head">Line on a body</h2>
            ${bodyRakes.value === null ? nothing : html`<wakesurf-body-rake .model=${bodyRakes.value}></wakesurf-body-rake>`}
        </section>`;
    }
    if (thing !== null) {
        return html`<section aria-labelledby="slice-head">
            <h2 id="slice-head">Slice</h2>
            ${slices.value === null ? nothing : html`<wakesurf-slices .model=${slices.value}></wakesurf-slices>`}
        </section>`;
    }
    const surface = html`<wakesurf-surface .model=${model.surface}></wakesurf-surface>`;
    if (state.surface.value?.kind === 'level') {
        return html`<section aria-labelledby="isosurface-head">
            <h2 id="isosurface-head">Isosurface</h2>
            ${surface}
            <wakesurf-colour .model=${model.look}></wakesurf-colour>
        </section>`;
    }
    if (state.rake.value === undefined) return html``;
    return html`<section aria-labelledby="surface-head">
            <h2 id="surface-head">Surface</h2>
            ${surface}
        </section>
        <section aria-labelledby="rake-head">
            <details open>
                <summary><h2 id="rake-head">Geometry</h2></summary>
                <wakesurf-rake .model=${model.rake}></wakesurf-rake>
            </details>
        </section>`;
}

/** Where the picture has no room for the button. */
function twoPictures({ right, whyNot, toggle }: PanelModel['comparison']): TemplateResult {
    return html`<section aria-labelledby="beside-head">
        <h2 id="beside-head">Two pictures</h2>
        <button
            type="button"
            title=${whyNot.value || 'Another dataset, another time or other settings'}
            ?disabled=${whyNot.value !== '' && right.value === null}
            @click=${() => void toggle()}
        >
            ${right.value === null ? 'Show side by side' : 'End'}
        </button>
    </section>`;
}

interface Tab {
    id: string;
    label: string;
    body: (model: PanelModel) => TemplateResult;
    /** What "Copy as" copies. */
    steps: (model: PanelModel) => ScriptStep[];
}

const tabs: readonly Tab[] = [
    {
        id: 'flow',
        label: 'Flow',
        body: (model) => html`
            <section aria-labelledby="things-head">
                <h2 id="things-head">In the picture</h2>
                <wakesurf-picture-list .model=${model.pictureList}></wakesurf-picture-list>
            </section>
            ${settingsOfChosen(model)}
            <section aria-labelledby="means-head" ?hidden=${(model.state.dataset.value?.times.length ?? 0) < 2}>
                <details id="means">
                    <summary><h2 id="means-head">Means over time</h2></summary>
                    <wakesurf-means .model=${model.means}></wakesurf-means>
                </details>
            </section>
        `,
        steps: ({ state }) => surfaceSteps(state),
    },
    {
        id: 'look',
        label: 'Look',
        body: (model) => html`<wakesurf-look .model=${model.look}></wakesurf-look>`,
        steps: ({ state }) => surfaceSteps(state),
    },
    {
        id: 'view',
        label: 'View',
        body: (model) => html`
            <section aria-labelledby="bookmarks-head">
                <h2 id="bookmarks-head">Saved views</h2>
                <wakesurf-bookmarks .model=${model.bookmarks}></wakesurf-bookmarks>
            </section>
            <section aria-labelledby="probe-head">
                <h2 id="probe-head">Probe and measure</h2>
                <wakesurf-probe .model=${model.probe}></wakesurf-probe>
            </section>
            ${model.beside ? nothing : twoPictures(model.comparison)}
            <section aria-labelledby="surroundings-head">
                <h2 id="surroundings-head">Surroundings</h2>
                <wakesurf-surroundings .model=${model.surroundings}></wakesurf-surroundings>
            </section>
        `,
        steps: ({ state, view }) => viewSteps(state, view),
    },
    {
        id: 'share',
        label: 'Share',
        body: (model) => html`
            <section aria-labelledby="people-head">
                <h2 id="people-head">People</h2>
                <wakesurf-people .model=${model.people}></wakesurf-people>
            </section>
            <section aria-labelledby="links-head">
                <h2 id="links-head">Invite</h2>
                <wakesurf-links .model=${model.links}></wakesurf-links>
            </section>
            <section aria-labelledby="notes-head">
                <h2 id="notes-head">Notes</h2>
                <wakesurf-notes .model=${model.notes}></wakesurf-notes>
            </section>
        `,
        steps: ({ state }) => shareSteps(state),
    },
    {
        id: 'export',
        label: 'Export',
        body: (model) => exportBody(model.export),
        steps: (model) => meshSteps(model.state, chosenMesh(model.export.mesh)),
    },
];

export class Panel extends ModelElement<PanelModel> {
    private readonly chosen = signal(tabs[0]!.id);

    static override styles = css`
        :host {
            display: grid;
            grid-template-rows: auto auto minmax(0, 1fr) auto auto;
            min-height: 0;
            background: var(--ground);
            border-left: 1px solid var(--line);
        }
        .head {
            padding: 14px 16px 8px;
        }
        .title {
            display: flex;
            justify-content: space-between;
        }
        h1 {
            margin: 0;
            font-size: 17px;
            letter-spacing: 0.01em;
        }
        h2 {
            margin: 14px 0 8px;
            font-size: 13px;
            font-weight: 600;
        }
        section + section {
            margin-top: 12px;
            border-top: 1px solid var(--line);
        }
        summary h2 {
            display: inline-block;
        }
        p {
            margin: 2px 0 0;
        }
        [role='tablist'] {
            display: flex;
            padding: 0 8px;
            border-bottom: 1px solid var(--line);
        }
        [role='tab'] {
            flex: 1;
            padding: 5px 2px;
            border: 0;
            border-bottom: 2px solid transparent;
            border-radius: 0;
            background: none;
            color: var(--quiet);
        }
        [role='tab'][aria-selected='true'] {
            border-bottom-color: var(--accent);
            color: var(--text);
            font-weight: 600;
        }
        [role='tabpanel'] {
            overflow-y: auto;
            padding: 0 16px 14px;
        }
        wakesurf-copy-as {
            padding: 4px 16px;
            border-top: 1px solid var(--line);
        }
        wakesurf-status {
            max-height: 40vh;
            overflow-y: auto;
            padding: 4px 16px 8px;
            border-top: 1px solid var(--line);
        }
        /* Below the picture there is little height: everything scrolls, under the tabs. */
        @media (max-width: 760px) {
            :host {
                display: block;
                overflow-y: auto;
                border-left: 0;
                border-top: 1px solid var(--line);
            }
            .head {
                padding: 8px 16px 2px;
            }
            [role='tablist'] {
                position: sticky;
                top: 0;
                z-index: 1;
                background: var(--ground);
            }
            [role='tabpanel'] {
                overflow: visible;
            }
            wakesurf-status {
                display: contents;
            }
            /* Scripts are for where there are terminals. */
            wakesurf-copy-as {
                display: none;
            }
        }
    `;

    override render(): TemplateResult {
        const { state } = this.model;
        const dataset = state.dataset.value;
        const chosen = tabs.find(({ id }) => id === this.chosen.value) ?? tabs[0]!;
        return html`
            <div class="head">
                <div class="title">
                    <h1>wakesurf</h1>
                    <wakesurf-help .model=${this.model.help}></wakesurf-help>
                </div>
                ${
                    this.model.beside
                        ? html`<p class="quiet">Settings of the right half, which go with it.</p>`
                        : html`<wakesurf-session-head .model=${this.model.sessionHead}></wakesurf-session-head>
                              <wakesurf-dataset-head .model=${this.model.datasetHead}></wakesurf-dataset-head>
                              ${this.place()}`
                }
            </div>
            <div role="tablist" aria-label="Settings" @keydown=${this.turn}>
                ${this.tabs.map(({ id, label }) => this.tab(id, label, id === chosen.id))}
            </div>
            <div role="tabpanel" id="tab-body" tabindex="0" aria-labelledby=${`tab-${chosen.id}`}>
                ${dataset === null ? nothing : chosen.body(this.model)}
            </div>
            <wakesurf-copy-as .model=${this.model} .calls=${() => chosen.steps(this.model)}></wakesurf-copy-as>
            <wakesurf-status role="region" aria-label="Status" .model=${this.model.status}></wakesurf-status>
        `;
    }

    /** Nobody can be invited to a half. */
    private get tabs(): readonly Tab[] {
        return this.model.beside ? tabs.filter(({ id }) => id !== 'share') : tabs;
    }

    /** Returns what may be done here, where it is not everything; and whose session it is, where it is a
     *  copy. */
    private place(): TemplateResult | typeof nothing {
        const { state, ownCopy } = this.model;
        if (state.role.value === 'viewer') {
            return html`<p class="quiet" id="role">
                Your link is for looking: you can turn, colour, measure and save. To play and to edit for yourself:
                <wakesurf-own-copy .model=${ownCopy}></wakesurf-own-copy>
            </p>`;
        }
        const from = state.copyOf.value;
        if (from === null) return nothing;
        return html`<p class="quiet" id="copy-of">
            A copy of “${isolated(from.name)}”: what changes here changes nothing there.
            <button type="button" @click=${() => ownCopy.back()}>Back to “${isolated(from.name)}”</button>
        </p>`;
    }

    private tab(id: string, label: string, selected: boolean): TemplateResult {
        return html`<button
            type="button"
            role="tab"
            id=${`tab-${id}`}
            aria-controls="tab-body"
            aria-selected=${selected ? 'true' : 'false'}
            tabindex=${selected ? 0 : -1}
            @click=${() => (this.chosen.value = id)}
        >
            ${label}
        </button>`;
    }

    /** Arrow keys go from tab to tab, as the pattern of tabs has it (WAI-ARIA). */
    private turn(event: KeyboardEvent): void {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (step === undefined) return;
        const { tabs: own } = this;
        const at = own.findIndex(({ id }) => id === this.chosen.value);
        const next = own[(at + step + own.length) % own.length]!;
        this.chosen.value = next.id;
        this.renderRoot.querySelector<HTMLElement>(`#tab-${next.id}`)?.focus();
    }
}

customElements.define('wakesurf-panel', Panel);
