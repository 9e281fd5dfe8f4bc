// Lines, ribbons and arrows that are shown instead of all of the selected surface.
import { html, nothing, type TemplateResult } from 'lit';
import type { PieceKind, SurfaceLook } from '../../state/surfaceLook.ts';
import { seedLinesOf } from '../../session/out/exportNames.ts';
import { changeLookWithFields } from '../../session/picture/surfaceFields.ts';
import { hasFlow, pieceLengths } from '../../session/picture/surfaceStyleOf.ts';
import type { SurfaceRecord } from '../../protocol/messages.ts';
import type { LinesModel } from './linesPanel.ts';
import { type Choice, numberRow, selectRow } from '../base/rows.ts';
import { LookGroup } from './lookStyles.ts';

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
