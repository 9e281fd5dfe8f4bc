// The page: the picture with its overlays, the panel beside it, the time below; or, where nothing
// can be shown, the reason in words.
import { css, html, nothing, type TemplateResult } from 'lit';
import { keyed } from 'lit/directives/keyed.js';
import { type ReadonlySignal, signal } from '@preact/signals-core';
import type { AppState } from '../state/appState.ts';
import './status/banner.ts';
import type { BannerModel } from './status/banner.ts';
import './panel.ts';
import type { PanelModel } from './panel.ts';
import './look/scalarBar.ts';
import type { ScalarBarModel } from './look/scalarBar.ts';
import { NumberTyped } from './base/rows.ts';
import { SignalElement } from './base/signalElement.ts';
import { leaveKeys } from './base/keyboard.ts';
import './share/notesPanel.ts';
import type { NoteModel } from './share/notesPanel.ts';
import type { PlotDockModel } from './plots/plotDock.ts';
import './time/timeBar.ts';
import type { TimeBarModel } from './time/timeBar.ts';
import './view/viewButtons.ts';
import type { ToolsModel, ViewButtonsModel } from './view/viewButtons.ts';
import type { CompareBarModel, Side } from './compare/compareBar.ts';
import './help/tour.ts';
import type { TourModel } from './help/tour.ts';

/** Are done with once they are pressed, other than handles of a rake, which arrow keys move. */
const switches = 'button[aria-pressed]:not(.handle), input[type="checkbox"]';

/** The comparison with a page beside this one, which is a picture alone; the panel is for the half that is chosen. */
export interface AppComparison {
    right: ReadonlySignal<{ app: HTMLElement; panel: PanelModel } | null>;
    bar: ReadonlySignal<CompareBarModel | null>;
    chosen: ReadonlySignal<Side>;
    choose: (side: Side) => void;
}

/** What each part of the page takes, by the name of the part. */
export interface PageModel {
    /** Null: this is a right half, which has the picture alone. */
    comparison: AppComparison | null;
    state: Pick<AppState, 'fatal' | 'problems'>;
    scalarBar: ScalarBarModel;
    viewButtons: ViewButtonsModel;
    tools: ToolsModel;
    tour: TourModel;
    banner: BannerModel;
    panel: PanelModel;
    note: NoteModel;
    timeBar: TimeBarModel;
    /** Null: nothing is plotted. */
    plots: ReadonlySignal<PlotDockModel | null>;
}

export class App extends SignalElement {
    readonly canvas = document.createElement('canvas');
    readonly labels = document.createElement('div');
    private readonly model = signal<PageModel | null>(null);
    private readonly failure = signal<string | null>(null);

    static override styles = css`
        :host {
            display: block;
            height: 100%;
        }
        .layout {
            display: grid;
            grid-template: minmax(0, 1fr) auto auto / minmax(0, 1fr) 304px;
            height: 100%;
        }
        main {
            position: relative;
            overflow: hidden;
            background: light-dark(#f2f5f9, #0b1018);
        }
        canvas {
            display: block;
            width: 100%;
            height: 100%;
            touch-action: none;
            outline-offset: -2px;
        }
        .labels {
            position: absolute;
            inset: 0;
            overflow: hidden;
            pointer-events: none;
            color: light-dark(#3b485c, #c3cede);
            font-size: 12px;
            font-variant-numeric: tabular-nums;
        }
        .labels span {
            position: absolute;
            left: 0;
            top: 0;
            white-space: nowrap;
        }
        .labels .rake-label {
            padding: 1px 7px;
            border-left: 3px solid;
            border-radius: 4px;
            background: rgb(8 12 20 / 0.82);
            color: #ffffff;
        }
        .labels .beside-pointer {
            position: absolute;
            left: 0;
            top: 0;
            max-width: 240px;
            padding: 2px 8px;
            border-radius: 6px;
            background: rgb(8 12 20 / 0.86);
            color: #ffffff;
        }
        .labels .beside-pointer:empty {
            display: none;
        }
        .labels .brush {
            position: absolute;
            left: 0;
            top: 0;
            border: 1.5px solid light-dark(#17202d, #e8edf5);
            border-radius: 50%;
        }
        .labels .scale {
            font-size: 12px;
        }
        .labels .scale-line {
            height: 3px;
            background: currentColor;
        }
        .labels .axis-name {
            font-size: 15px;
            font-weight: 600;
        }
        .labels .person,
        .labels .marker {
            padding: 0 6px;
            border: 2px solid;
            border-radius: 9px;
            background: rgb(11 16 24 / 0.8);
            color: #e8edf5;
        }
        .axis-x {
            color: light-dark(#b3261e, #ff8a80);
        }
        .axis-y {
            color: light-dark(#17713f, #7ee2a8);
        }
        .axis-z {
            color: light-dark(#1d4fa8, #8ab8ff);
        }
        wakesurf-scalar-bar {
            position: absolute;
            right: 12px;
            bottom: 12px;
        }
        wakesurf-view-buttons {
            position: absolute;
            right: 12px;
            top: 12px;
        }
        wakesurf-note-dialog {
            position: absolute;
        }
        wakesurf-tool-buttons {
            position: absolute;
            right: 12px;
            top: 150px;
        }
        wakesurf-tour {
            position: absolute;
            left: 12px;
            top: 12px;
        }
        wakesurf-banner {
            position: absolute;
            left: 12px;
            right: 150px;
            top: 12px;
        }
        wakesurf-panel {
            grid-row: 1 / 4;
            grid-column: 2;
        }
        wakesurf-plot-dock {
            grid-row: 2;
            grid-column: 1;
        }
        wakesurf-time-bar {
            grid-row: 3;
            grid-column: 1;
        }
        .comparing {
            grid-template: auto minmax(0, 1fr) auto auto / minmax(0, 1fr) minmax(0, 1fr) 304px;
        }
        .comparing.folded {
            grid-template: auto minmax(0, 1fr) auto auto / minmax(0, 1fr) minmax(0, 1fr) 0;
        }
        .comparing > * {
            grid-column: 1 / 3;
        }
        .comparing > main,
        .comparing > wakesurf-app {
            grid-row: 2;
            grid-column: 1;
            min-width: 0;
        }
        .comparing > wakesurf-app {
            grid-column: 2;
            border-left: 1px solid var(--line);
        }
        .comparing > wakesurf-plot-dock {
            grid-row: 3;
        }
        .comparing > wakesurf-time-bar {
            grid-row: 4;
        }
        .comparing > wakesurf-panel {
            grid-row: 1 / 5;
            grid-column: 3;
        }
        main.alone {
            height: 100%;
        }
        .folded {
            grid-template: minmax(0, 1fr) auto auto / minmax(0, 1fr) 0;
        }
        .folded wakesurf-panel {
            display: none;
        }
        /* Seen by those who come to it by keyboard. */
        .skip:not(:focus-visible) {
            position: absolute;
            clip-path: inset(50%);
        }
        .skip:focus-visible {
            position: absolute;
            z-index: 2;
            left: 12px;
            top: 12px;
        }
        .failure {
            display: grid;
            place-content: center;
            gap: 8px;
            height: 100%;
            padding: 24px;
            background: light-dark(#f2f5f9, #0b1018);
            color: var(--text);
            font-size: 16px;
        }
        .failure h1 {
            margin: 0;
            font-size: 22px;
        }
        .failure p {
            max-width: 60ch;
            margin: 0;
        }
        /* In one row with the buttons of the view: the domain has no room to spare beside it. Colours below the picture,
           not on it, because the axes need its width; the tour over the settings, because the first handle is where it would be. */
        @media (max-width: 760px), (max-height: 500px) {
            wakesurf-tool-buttons {
                right: auto;
                left: 12px;
                top: 12px;
            }
            main {
                display: grid;
                grid-template-rows: minmax(0, 1fr) auto;
            }
            canvas,
            .labels {
                grid-row: 1 / 2;
            }
            wakesurf-scalar-bar {
                grid-row: 2;
                position: static;
                justify-self: center;
                pointer-events: auto;
                touch-action: none;
            }
            wakesurf-tour {
                position: fixed;
                z-index: 1;
                left: auto;
                right: 8px;
                top: auto;
                bottom: 8px;
                width: min(288px, 100vw - 16px);
            }
        }
        @media (max-width: 760px) {
            .layout {
                grid-template: minmax(42vh, 1fr) auto auto minmax(0, 42vh) / minmax(0, 1fr);
            }
            .layout.plotting {
                grid-template: minmax(30vh, 1fr) auto auto minmax(0, 30vh) / minmax(0, 1fr);
            }
            .layout.folded {
                grid-template: minmax(0, 1fr) auto auto 0 / minmax(0, 1fr);
            }
            .layout.comparing {
                grid-template: auto minmax(32vh, 1.4fr) minmax(20vh, 1fr) auto auto minmax(0, 20vh) / minmax(0, 1fr);
            }
            .layout.comparing.folded {
                grid-template: auto minmax(0, 1fr) minmax(0, 1fr) auto auto 0 / minmax(0, 1fr);
            }
            /* Colours mean the same in both halves. */
            main.alone wakesurf-scalar-bar {
                display: none;
            }
            .layout.comparing > * {
                grid-column: 1;
            }
            .layout.comparing > wakesurf-app {
                grid-row: 3;
                border-left: 0;
                border-top: 1px solid var(--line);
            }
            .layout.comparing > wakesurf-plot-dock {
                grid-row: 4;
            }
            .layout.comparing > wakesurf-time-bar {
                grid-row: 5;
            }
            .layout.comparing > wakesurf-panel {
                grid-row: 6;
            }
            wakesurf-tour {
                width: calc(100vw - 16px);
            }
            wakesurf-panel {
                grid-row: 4;
                grid-column: 1;
            }
            wakesurf-banner {
                right: 12px;
                top: 48px;
            }
        }
    `;

    constructor() {
        super();
        this.labels.className = 'labels';
        this.canvas.setAttribute('role', 'img');
        this.canvas.tabIndex = 0;
        this.canvas.setAttribute(
            'aria-label',
            'The surface in the flow. Arrow keys turn the view, with Shift they move it, plus and minus zoom. ' +
                'Rakes can be moved by keyboard in the panel, under Geometry.',
        );
    }

    /** The model needs the canvas, so it comes after the element. */
    begin(model: PageModel): void {
        this.model.value = model;
    }

    /** Shows why there is nothing to show. */
    fail(reason: string): void {
        this.failure.value = reason;
    }

    /** A drag that begins on the bar turns the view, as on the picture: the canvas takes the pointer, and
     *  what follows comes to it. */
    private handOn(event: PointerEvent): void {
        this.canvas.dispatchEvent(new PointerEvent('pointerdown', event));
    }

    private clicked(event: Event): void {
        const [at] = event.composedPath();
        const control = at instanceof Element ? at.closest<HTMLElement>(switches) : null;
        if (control !== null) leaveKeys(control);
    }

    /** Past the picture and all settings, which are some seventy stops of Tab. */
    private skipToTime(): void {
        this.renderRoot.querySelector('wakesurf-time-bar')?.shadowRoot?.querySelector<HTMLElement>('button:enabled')?.focus();
    }

    private numberTyped({ detail: refusal }: NumberTyped): void {
        const { problems } = this.model.value!.state;
        if (refusal === null) problems.solved(NumberTyped.type);
        else problems.sayUntil('edit', NumberTyped.type, refusal);
    }

    /** What a right half has of it. */
    private pictureAlone(model: PageModel): TemplateResult {
        return html`<main class="alone">
            ${this.canvas} ${this.labels}
            <wakesurf-scalar-bar .model=${model.scalarBar} @pointerdown=${this.handOn}></wakesurf-scalar-bar>
            <wakesurf-banner .model=${model.banner}></wakesurf-banner>
        </main>`;
    }

    override render(): TemplateResult {
        const model = this.model.value;
        const reason = this.failure.value ?? model?.state.fatal.value ?? null;
        if (reason !== null) {
            return html`<main class="failure" role="alert">
                <h1>wakesurf</h1>
                <p>${reason}</p>
            </main>`;
        }
        if (model === null) return html`<main></main>`;
        const { comparison } = model;
        if (comparison === null) return this.pictureAlone(model);
        const plots = model.plots.value;
        const [right, bar] = [comparison.right.value, comparison.bar.value];
        const onRight = right !== null && comparison.chosen.value === 'right';
        const classes = [
            'layout',
            ...(model.viewButtons.view.panelFolded.value ? ['folded'] : []),
            ...(plots === null ? [] : ['plotting']),
            ...(right === null ? [] : ['comparing']),
        ];
        return html`<button type="button" class="skip" @click=${this.skipToTime}>Skip to the time controls</button>
            <div class=${classes.join(' ')} @number-typed=${this.numberTyped} @click=${this.clicked} @pointerdown=${(event: Event) => right !== null && event.composedPath().includes(right.app) && comparison.choose('right')}>
            ${bar === null ? nothing : html`<wakesurf-compare-bar role="region" aria-label="Comparison" .model=${bar}></wakesurf-compare-bar>`}
            <main @pointerdown=${() => comparison.choose('left')}>
                ${this.canvas} ${this.labels}
                <wakesurf-scalar-bar .model=${model.scalarBar} @pointerdown=${this.handOn}></wakesurf-scalar-bar>
                <wakesurf-view-buttons .model=${model.viewButtons}></wakesurf-view-buttons>
                <wakesurf-tool-buttons .model=${model.tools}></wakesurf-tool-buttons>
                <wakesurf-tour .model=${model.tour}></wakesurf-tour>
                <wakesurf-banner .model=${model.banner}></wakesurf-banner>
            </main>
            ${right?.app ?? nothing}
            ${plots === null ? nothing : html`<wakesurf-plot-dock role="region" aria-label="Plot" .model=${plots}></wakesurf-plot-dock>`}
            <wakesurf-time-bar role="region" aria-label="Time of the data" .model=${model.timeBar}></wakesurf-time-bar>
            ${keyed(
                onRight,
                html`<wakesurf-panel
                    role="complementary"
                    aria-label=${onRight ? 'Settings of the right half' : 'Settings'}
                    .model=${onRight ? right.panel : model.panel}
                ></wakesurf-panel>`,
            )}
            <wakesurf-note-dialog .model=${model.note}></wakesurf-note-dialog>
        </div>`;
    }
}

customElements.define('wakesurf-app', App);
