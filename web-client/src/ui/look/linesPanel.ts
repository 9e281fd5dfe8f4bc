// Stripes, lines and flow texture on the selected surface, and lines, ribbons and arrows that are shown instead of all of it.
import { html, nothing, type TemplateResult } from 'lit';
import type { SurfaceRecord } from '../../protocol/messages.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { seedLinesOf } from '../../session/out/exportNames.ts';
import { changeLookWithFields } from '../../session/picture/surfaceFields.ts';
import { canCome, hasFlow, intervalError, pieceLengths } from '../../session/picture/surfaceStyleOf.ts';
import type { AppState } from '../../state/appState.ts';
import type { LineKind, PieceKind, SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import '../base/locked.ts';
import type { OwnCopyButton } from '../base/locked.ts';
import { checkRow, type Choice, numberRow, selectRow, sliderRow } from '../base/rows.ts';
import { LookGroup } from './lookStyles.ts';

const kinds: readonly Choice<LineKind>[] = [
    { value: 'none', words: 'None' },
    { value: 'timelines', words: 'Along timelines' },
    { value: 'streamlines', words: 'Along the flow' },
    { value: 'grid', words: 'Grid of both' },
    { value: 'checker', words: 'Checkerboard' },
];

export interface LinesModel {
    state: Pick<AppState, 'activeSurface' | 'dataset' | 'notices' | 'surface' | 'role'>;
    view: ViewState;
    edits: Pick<Edits, 'changeSurface'>;
    ownCopy: OwnCopyButton['model'];
}

export class LinesPanel extends LookGroup<LinesModel> {
    override render(): TemplateResult {
        const { state } = this.model;
        const { look } = this;
        const { lines, density, texture, animated } = look;
        return html`
            ${selectRow('lines', 'Stripes', kinds, lines, (chosen) => this.change({ lines: chosen }))}
            ${checkRow('Flow texture', texture, (on) => this.textured(on), { id: 'texture', disabled: this.locked(look) })}
            ${checkRow('Moving with the flow', animated, (on) => this.change({ animated: on }), { id: 'animated', disabled: !texture })}
            ${
                matchMedia('(prefers-reduced-motion: reduce)').matches && animated && state.surface.value?.kind === 'stream'
                    ? html`<p class="quiet">Animation is off: your system asks for reduced motion.</p>`
                    : nothing
            }
            ${sliderRow({
                ...{ id: 'density', words: 'Density', value: Math.log2(density), low: -2, high: 2, step: 0.5 },
                shown: `× ${Number(density.toPrecision(2))}`,
                change: (power) => this.change({ density: 2 ** power }),
            })}
            ${this.hatching(look)} ${this.waiting(look)}
        `;
    }

    private hatching({ hatched }: SurfaceLook): TemplateResult | typeof nothing {
        const { state } = this.model;
        const record = state.surface.value;
        if (record === undefined || !canCome(state.dataset.value, intervalError)) return nothing;
        const carried = record.fields.includes(intervalError);
        return checkRow(
            'Hatched beyond the stored times',
            hatched && carried,
            (on) => changeLookWithFields(this.model, record, { hatched: on }),
            {
                id: 'hatched',
                title: 'Where interpolating between stored times may put the surface off by more than the separation, or by no one knows how much',
                disabled: !carried && state.role.value === 'viewer',
            },
        );
    }

    /** The velocity travels with the surface from then on, for every user. */
    private textured(on: boolean): void {
        const record = this.model.state.surface.value;
        const change = { texture: on, animated: on && this.look.animated };
        if (record !== undefined) changeLookWithFields(this.model, record, change);
    }

    private locked({ texture }: SurfaceLook): boolean {
        const { state } = this.model;
        const record = state.surface.value;
        return state.role.value === 'viewer' && !texture && record !== undefined && !hasFlow(record);
    }

    /** Last in the group: nothing that one is about to press may move. */
    private waiting(look: SurfaceLook): TemplateResult | typeof nothing {
        const { state, ownCopy } = this.model;
        const record = state.surface.value;
        if (record === undefined || hasFlow(record)) return nothing;
        if (this.locked(look)) {
            return html`<p class="quiet">
                The velocity does not come with this surface. It can be asked for in a copy of your own.
                <wakesurf-own-copy .model=${ownCopy}></wakesurf-own-copy>
            </p>`;
        }
        if (!look.texture) return nothing;
        return html`<p class="quiet" role="status">
            The texture appears when the velocity arrives from the server. If it does not, choose Flow texture again.
        </p>`;
    }
}

customElements.define('wakesurf-lines', LinesPanel);

function choicesFor({ kind }: Pick<SurfaceRecord, 'kind'>): Choice<PieceKind>[] {
    const along = seedLinesOf(kind);
    // All of a time surface is one age, and each of its points a particle of its own.
    const disabled = along === '';
    const named = along === '' ? 'Lines of a seed' : `${along[0]!.toUpperCase()}${along.slice(1)}`;
    return [
        { value: 'whole', words: 'All of it' },
        { value: 'timelines', words: 'Timelines', disabled },
        { value: 'seedlines', words: named, disabled },
        { value: 'timeribbons', words: 'Ribbons of timelines', disabled },
        { value: 'seedribbons', words: `Ribbons of ${along === '' ? 'a seed' : along}`, disabled },
        { value: 'arrows', words: 'Arrows' },
    ];
}

/** Lines, ribbons and arrows that are shown instead of all of the selected surface. */
export class PiecesPanel extends LookGroup<LinesModel> {
    override render(): TemplateResult | typeof nothing {
        const { state } = this.model;
        const { look } = this;
        const record = state.surface.value;
        if (record === undefined) return nothing;
        const { pieces } = look;
        const { pieceEvery, pieceWidth } = pieceLengths(look, state.dataset.value?.bounds);
        const hasWidth = pieces !== 'whole' && !pieces.endsWith('lines');
        return html`
            ${selectRow('pieces', 'Shown of it', choicesFor(record), pieces, (chosen) => this.choose(chosen))}
            ${pieces === 'whole' ? nothing : this.length('piece-every', 'One every', pieceEvery, (every) => ({ pieceEvery: every }))}
            ${hasWidth ? this.length('piece-width', 'Width', pieceWidth, (width) => ({ pieceWidth: width })) : nothing}
            ${this.waiting(look)}
        `;
    }

    private length(id: string, words: string, value: number, change: (value: number) => Partial<SurfaceLook>): TemplateResult {
        const changed = (typed: number): boolean => {
            if (typed > 0) this.change(change(typed));
            return typed > 0;
        };
        return numberRow(words, { id, min: 0, shown: String(Number(value.toPrecision(4))), change: changed });
    }

    /** Arrows point the way of the velocity, which travels with the surface from then on, for every user. */
    private choose(pieces: PieceKind): void {
        const record = this.model.state.surface.value;
        if (record !== undefined) changeLookWithFields(this.model, record, { pieces });
    }

    private waiting({ pieces }: SurfaceLook): TemplateResult | typeof nothing {
        const { state } = this.model;
        const record = state.surface.value;
        if (record === undefined || pieces !== 'arrows' || hasFlow(record)) return nothing;
        if (state.role.value === 'viewer') {
            return html`<p class="quiet">The velocity does not come with this surface, so it has no arrows.</p>`;
        }
        return html`<p class="quiet" role="status">Arrows appear when the velocity arrives from the server.</p>`;
    }
}

customElements.define('wakesurf-pieces', PiecesPanel);
