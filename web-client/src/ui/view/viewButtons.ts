// Buttons over the picture: which way the axes point, and views of the whole domain for when the camera has lost its way, each end of an
// axis being a button that looks from there; and what a click on the picture does, which without a tool only turns the view.
import type { ReadonlySignal } from '@preact/signals-core';
import { css, html, nothing, svg, type SVGTemplateResult, type TemplateResult } from 'lit';
import { Vector3 } from 'three';
import type { View } from '../../scene/base/view.ts';
import type { ViewName } from '../../scene/camera/cameraControls.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { Tool, ViewState } from '../../state/viewState.ts';
import { icon } from '../base/icons.ts';
import { ModelElement } from '../base/signalElement.ts';
import { hasFullScreen, togglePanel, turnFullScreen } from './room.ts';

/** `from`: on which side the camera then is. */
const ends: readonly { view: ViewName; axis: 'x' | 'y' | 'z'; direction: readonly [number, number, number]; words: string }[] = [
    { view: '-x', axis: 'x', direction: [1, 0, 0], words: '+x: look against x' },
    { view: '-y', axis: 'y', direction: [0, 1, 0], words: '+y: look against y' },
    { view: 'z', axis: 'z', direction: [0, 0, 1], words: '+z: look against z' },
    { view: 'x', axis: 'x', direction: [-1, 0, 0], words: '-x: look along x' },
    { view: 'y', axis: 'y', direction: [0, -1, 0], words: '-y: look along y' },
    { view: '-z', axis: 'z', direction: [0, 0, -1], words: '-z: look along z' },
];
const armPx = 30;

export interface ViewButtonsModel {
    view: Pick<ViewState, 'orthographic' | 'panelFolded'>;
    scene: Pick<FlowScene, 'controls' | 'loop' | 'onDraw' | 'view'>;
}

export class ViewButtons extends ModelElement<ViewButtonsModel> {
    private listening = false;
    /** The camera that the marker is drawn for. */
    private turned = '';

    static override styles = css`
        :host {
            display: grid;
            justify-items: end;
            gap: 6px;
        }
        .buttons {
            display: flex;
            gap: 4px;
        }
        .sign {
            display: grid;
            place-content: center;
            min-width: 28px;
            padding: 3px;
        }
        svg {
            overflow: visible;
        }
        line {
            stroke-width: 2;
        }
        circle {
            stroke-width: 2;
            cursor: pointer;
        }
        g:focus-visible circle {
            stroke: var(--text);
        }
        text {
            fill: #0b1018;
            font: 700 11px system-ui, sans-serif;
            text-anchor: middle;
            dominant-baseline: central;
            pointer-events: none;
        }
        .x {
            stroke: #ff8a80;
            --end: #ff8a80;
        }
        .y {
            stroke: #7ee2a8;
            --end: #7ee2a8;
        }
        .z {
            stroke: #8ab8ff;
            --end: #8ab8ff;
        }
        circle.reach {
            fill: transparent;
            stroke: none;
        }
        .towards circle:not(.reach) {
            fill: var(--end);
        }
        .away circle:not(.reach) {
            fill: rgb(128 140 160 / 0.25);
        }
    `;

    override render(): TemplateResult {
        const { view, scene } = this.model;
        const parallel = view.orthographic.value;
        return html`<div class="buttons" role="group" aria-label="View">
                <button type="button" title="Fit the whole domain" aria-label="Fit the whole domain" @click=${() => this.look('oblique')}>
                    Fit
                </button>
                <button
                    type="button"
                    aria-pressed=${parallel ? 'true' : 'false'}
                    title="No perspective: lengths can be compared"
                    @click=${() => {
                        view.orthographic.value = !parallel;
                        scene.controls.setOrthographic(!parallel);
                        scene.loop.request();
                    }}
                >
                    Parallel
                </button>
                ${
                    hasFullScreen()
                        ? html`<button type="button" class="sign" aria-label="Full screen" title="Full screen (Shift+F)" @click=${turnFullScreen}>
                              ${icon('whole')}
                          </button>`
                        : nothing
                }
                <button
                    type="button"
                    class="sign"
                    aria-label="Panel"
                    title="Show or fold away the panel (P)"
                    aria-expanded=${view.panelFolded.value ? 'false' : 'true'}
                    @click=${() => togglePanel(view)}
                >
                    ${icon(view.panelFolded.value ? 'unfold' : 'fold')}
                </button>
            </div>
            <svg width="92" height="92" viewBox="-46 -46 92 92" role="group" aria-label="Axes">
                ${ends.map((end) => this.end(end))}
            </svg>`;
    }

    protected override updated(): void {
        if (this.listening) return;
        this.listening = true;
        this.model.scene.onDraw((view) => this.turn(view));
        this.turn(this.model.scene.view());
    }

    private end({ view, axis, words }: (typeof ends)[number]): SVGTemplateResult {
        const towards = words.startsWith('+');
        return svg`<g role="button" tabindex="0" aria-label=${words} data-view=${view}
                class=${`${axis} ${towards ? 'towards' : 'away'}`}
                @click=${() => this.look(view)}
                @keydown=${(event: KeyboardEvent) => {
                    if (event.key !== 'Enter' && event.key !== ' ') return;
                    event.preventDefault();
                    this.look(view);
                }}>
            <title>${words}</title>
            ${towards ? svg`<line x1="0" y1="0" x2="0" y2="0" />` : ''}
            <circle class="reach" r="12" />
            <circle r=${towards ? 9 : 6} />
            ${towards ? svg`<text>${axis}</text>` : ''}
        </g>`;
    }

    private look(view: ViewName): void {
        this.model.scene.controls.show(view);
        this.model.scene.loop.request();
    }

    /** The ends as the camera sees them, what is nearer over what is behind. */
    private turn({ camera }: View): void {
        const drawing = this.renderRoot.querySelector('svg[role="group"]');
        if (drawing === null) return;
        // Most frames are not of a turning camera, and drawing this again costs as much as a small surface
        // does.
        const turned = camera.quaternion.toArray().join();
        if (turned === this.turned) return;
        this.turned = turned;
        const inverse = camera.quaternion.clone().invert();
        const placed = ends.map(({ view, direction }) => {
            const { x, y } = new Vector3(...direction).applyQuaternion(inverse);
            return { shape: drawing.querySelector<SVGGElement>(`[data-view='${view}']`), x: x * armPx, y: -y * armPx };
        });
        for (const { shape, x, y } of placed) {
            if (shape === null) continue;
            for (const circle of shape.querySelectorAll('circle')) {
                circle.setAttribute('cx', x.toFixed(1));
                circle.setAttribute('cy', y.toFixed(1));
            }
            const line = shape.querySelector('line');
            line?.setAttribute('x2', x.toFixed(1));
            line?.setAttribute('y2', y.toFixed(1));
            const text = shape.querySelector('text');
            text?.setAttribute('x', x.toFixed(1));
            text?.setAttribute('y', y.toFixed(1));
        }
    }
}

customElements.define('wakesurf-view-buttons', ViewButtons);

const tools: readonly { tool: Tool; label: string; words: string; edits: boolean }[] = [
    { tool: 'probe', label: 'Probe', words: 'Show the flow under the pointer; click to keep the point', edits: false },
    { tool: 'measure', label: 'Measure', words: 'Measure the distance between two clicks', edits: false },
    { tool: 'annotate', label: 'Note', words: 'Click to place a note', edits: true },
];

export interface ToolsModel {
    state: Pick<AppState, 'role'>;
    view: Pick<ViewState, 'plot' | 'tool'>;
    comparison: { right: ReadonlySignal<object | null>; whyNot: ReadonlySignal<string>; toggle: () => Promise<void> };
}

/** What a click on the picture does, and the plot below it. */
export class ToolButtons extends ModelElement<ToolsModel> {
    static override styles = css`
        div {
            display: grid;
            gap: 4px;
        }
        @media (max-width: 760px), (max-height: 500px) {
            div {
                grid-auto-flow: column;
            }
            /* The handles of the rake need the room; the panel offers both, too. */
            #plot,
            #compare {
                display: none;
            }
        }
        button[aria-pressed='true'] {
            border-color: var(--accent);
            background: var(--accent);
            color: var(--ground);
        }
    `;

    override render(): TemplateResult {
        const { view, state, comparison } = this.model;
        const viewer = state.role.value === 'viewer';
        return html`<div role="group" aria-label="Tools">
            ${tools.map(({ tool, label, words, edits }) => {
                const chosen = view.tool.value === tool;
                return html`<button
                    type="button"
                    title=${viewer && edits ? `${words} (your link is for looking)` : words}
                    aria-pressed=${chosen ? 'true' : 'false'}
                    ?disabled=${viewer && edits}
                    @click=${() => (view.tool.value = chosen ? 'none' : tool)}
                >
                    ${label}
                </button>`;
            })}
            <button
                type="button"
                id="plot"
                title="Plot values along the rake or a line, over time, or numbers of the surface"
                aria-pressed=${view.plot.value === null ? 'false' : 'true'}
                @click=${() => (view.plot.value = view.plot.value === null ? 'rake' : null)}
            >
                Plot
            </button>
            <button
                type="button"
                id="compare"
                title=${comparison.whyNot.value || 'Another dataset, another time or other settings beside this picture'}
                aria-pressed=${comparison.right.value === null ? 'false' : 'true'}
                ?disabled=${comparison.whyNot.value !== '' && comparison.right.value === null}
                @click=${() => void comparison.toggle()}
            >
                Side by side
            </button>
        </div>`;
    }
}

customElements.define('wakesurf-tool-buttons', ToolButtons);
