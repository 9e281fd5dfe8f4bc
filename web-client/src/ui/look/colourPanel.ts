// Shows what the selected surface is coloured by, with which colours, over which range.
import { css, html, nothing, type TemplateResult } from 'lit';
import { colourTable, isBands, mostBands, tableSize } from '../../scene/surface/colourMap.ts';
import { changeLookWithFields } from '../../session/picture/surfaceFields.ts';
import { ownerColour } from '../../session/picture/surfaceOwner.ts';
import { attributeOf, isLogarithmic, isSigned, knownRange } from '../../session/picture/surfaceStyleOf.ts';
import { colourMaps, type SurfaceLook } from '../../state/surfaceLook.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { Edits } from '../../session/edits/edits.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { colourChoices, mapNames } from './colourNames.ts';
import '../base/locked.ts';
import type { OwnCopyButton } from '../base/locked.ts';
import { checkRow, numberField, pairRow, selectRow } from '../base/rows.ts';
import { LookGroup, lookStyles } from './lookStyles.ts';

// Nobody needs it before the first picture.
void import('./histogramPanel.ts');

export interface ColourModel {
    state: AppState;
    view: ViewState;
    edits: Pick<Edits, 'changeSurface'>;
    scene: Pick<FlowScene, 'surfaces' | 'view'>;
    ownCopy: OwnCopyButton['model'];
}

export class ColourPanel extends LookGroup<ColourModel> {
    static override styles = [
        lookStyles,
        css`
            fieldset {
                display: grid;
                grid-template-columns: 1fr 1fr;
                gap: 4px;
                margin: 6px 0 8px;
                padding: 0;
                border: 0;
            }
            legend {
                padding: 0;
                margin-bottom: 4px;
            }
            .map {
                position: relative;
                display: grid;
                gap: 2px;
                padding: 4px 6px;
                border: 1px solid var(--line);
                border-radius: 6px;
                background: var(--raised);
                font-size: 12px;
                cursor: pointer;
            }
            .map input {
                position: absolute;
                opacity: 0;
                inset: 0;
                margin: 0;
                cursor: pointer;
            }
            .map:has(:checked) {
                border-color: var(--accent);
                box-shadow: inset 0 0 0 1px var(--accent);
            }
            .map:has(:focus-visible) {
                outline: 2px solid var(--accent);
                outline-offset: 2px;
            }
            canvas {
                width: 100%;
                height: 10px;
                border-radius: 3px;
            }
            .checks {
                display: grid;
                grid-template-columns: 1fr 1fr;
            }
            .checks .row {
                min-height: 28px;
            }
            .checks .row .number {
                width: 56px;
            }
            .checks .number {
                width: 80px;
                text-align: right;
            }
        `,
    ];

    override render(): TemplateResult {
        const { state, scene } = this.model;
        const id = state.activeSurface.value;
        const record = state.surface.value;
        // Again with every state on the screen: automatic ranges follow it.
        void state.displayed.value;
        if (id === null || record === undefined) return html``;
        const { look } = this;
        const isThere = (field: string): boolean => state.role.value !== 'viewer' || record.fields.includes(field);
        const choices = colourChoices(state.dataset.value, record, isThere);
        const range = look.range ?? scene.surfaces.spanOf(id)?.colours ?? ([0, 1] as const);
        return html`
            ${selectRow('colour-by', 'Colour by', choices, look.colourBy, (colourBy) => this.colourBy(colourBy))}
            ${
                state.role.value === 'viewer'
                    ? html`<p class="quiet">
                      What has no values on this surface yet can be chosen in a copy of your own.
                      <wakesurf-own-copy .model=${this.model.ownCopy}></wakesurf-own-copy>
                  </p>`
                    : nothing
            }
            ${this.waiting(id, look)}
            ${look.colourBy === 'constant' ? this.constant(look) : html`${this.maps(look)} ${this.range(look, range)}`}
        `;
    }

    private colourBy(colourBy: string): void {
        const { look: before } = this;
        const record = this.model.state.surface.value;
        if (record === undefined) return;
        const signed = isSigned(colourBy);
        const wasSigned = before.map === 'coolToWarm' && before.centre !== null;
        const map = signed ? 'coolToWarm' : wasSigned ? 'viridis' : before.map;
        const change = { colourBy, range: null, log: isLogarithmic(colourBy), centre: signed ? 0 : null, map };
        changeLookWithFields(this.model, record, change);
    }

    private waiting(id: string, look: SurfaceLook): TemplateResult | typeof nothing {
        const wanted = attributeOf(look.colourBy);
        const style = this.model.scene.surfaces.spanOf(id)?.style;
        if (wanted === null || style === undefined || style.scalar === wanted) return nothing;
        const { state } = this.model;
        const asked = wanted === 'speed' || state.editsPending.value || state.surface.value?.fields.includes(wanted);
        const words = asked
            ? 'The colours will change when the values arrive from the server.'
            : 'The server does not send this field with the surface. Choose it again, or choose another.';
        return html`<p class="quiet" role="status">${words}</p>`;
    }

    private constant(look: SurfaceLook): TemplateResult {
        const colour = look.colour ?? ownerColour(this.model.state.surface.value!, this.model.state.rake.value);
        const own = look.colour !== null;
        return html`${checkRow(this.model.state.rake.value === undefined ? 'A different colour' : 'A different colour from the rake', own, (on) => this.change({ colour: on ? colour : null }), { id: 'own-colour' })}
            <label class="row" for="surface-colour"
                ><span>Colour</span>
                <input
                    id="surface-colour"
                    type="color"
                    .value=${colour}
                    ?disabled=${!own}
                    @input=${(event: Event) => this.change({ colour: (event.target as HTMLInputElement).value })}
                />
            </label>`;
    }

    private maps(look: SurfaceLook): TemplateResult {
        return html`<fieldset>
            <legend>Colours</legend>
            ${colourMaps.map(
                (map) =>
                    html`<label class="map"
                        ><canvas data-map=${map} width=${tableSize} height="1" aria-hidden="true"></canvas>
                        <input
                            type="radio"
                            name="map"
                            value=${map}
                            .checked=${look.map === map}
                            @change=${() => this.change({ map })}
                        />${mapNames[map]}</label
                    >`,
            )}
        </fieldset>`;
    }

    private range(look: SurfaceLook, range: readonly [number, number]): TemplateResult {
        const locked = look.range !== null;
        const below = range[0] < 0;
        const { dataset, speedRange } = this.model.state;
        const known = knownRange(look.colourBy, dataset.value, speedRange.value) !== null && look.colourBy !== 's';
        return html`
            ${
                known
                    ? checkRow(
                          'Over all the data, not this surface',
                          !locked && look.rangeOf === 'data',
                          (on) => this.change({ range: null, rangeOf: on ? 'data' : 'surface' }),
                          { id: 'data-range' },
                      )
                    : nothing
            }
            ${checkRow(locked ? 'Range locked at' : 'Lock the range', locked, (on) => this.change({ range: on ? range : null }), {
                id: 'lock-range',
            })}
            ${pairRow('range', 'Range', range, (pair) => this.change({ range: pair }))}
            <wakesurf-histogram .model=${this.model}></wakesurf-histogram>
            <div class="checks">
                ${checkRow('Inverted', look.invert, (invert) => this.change({ invert }), { id: 'invert' })}
                ${checkRow(
                    'Logarithmic',
                    look.log,
                    (log) => this.change({ log, root: false, centre: log ? null : look.centre }),
                    {
                        id: 'log',
                        title: below ? 'Values below zero have no logarithm' : 'Colours follow the logarithm of the values',
                        disabled: below && !look.log,
                    },
                )}
                ${checkRow('Root', look.root, (root) => this.change({ root, log: false }), {
                    id: 'root',
                    title: 'Colours follow the root of the values, with their sign: what is small is told apart',
                })}
                <label class="row" for="bands"
                    ><span>Bands</span>${numberField({
                        ...{
                            id: 'bands',
                            title: 'Bands of one colour; 0: none',
                            min: 0,
                            max: mostBands,
                            shown: String(look.bands),
                        },
                        change: (bands) => isBands(bands) && this.change({ bands }),
                    })}</label
                >
                ${checkRow(
                    'Symmetric around',
                    look.centre !== null,
                    (on) => this.change({ centre: on ? 0 : null, log: on ? false : look.log }),
                    { id: 'centred' },
                )}
                ${numberField({
                    ...{ label: 'Value at the centre', shown: String(look.centre ?? 0), disabled: look.centre === null },
                    change: (centre) => this.change({ centre }),
                })}
            </div>
            <p class="quiet">Values outside the range have the colours of its ends${look.log ? '; values below zero are grey' : ''}${
                below && !look.log ? '. Values below zero have no logarithm' : ''
            }.</p>
        `;
    }

    protected override updated(): void {
        for (const canvas of this.renderRoot.querySelectorAll('canvas')) {
            const map = colourMaps.find((each) => each === canvas.dataset['map']);
            if (map === undefined || canvas.dataset['drawn'] === map) continue;
            canvas.dataset['drawn'] = map;
            const pixels = new Uint8ClampedArray(colourTable(map).buffer);
            canvas.getContext('2d')?.putImageData(new ImageData(pixels, tableSize, 1), 0, 0);
        }
    }
}

customElements.define('wakesurf-colour', ColourPanel);
