// The rules of the mesh beside its separation: how many quads it may have, and when quads are joined and
// refined. For those who ask.
import { css, html, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { surfaceSetRanges } from '../../protocol/generated/surface.ts';
import type { SurfaceIntent } from '../../session/edits/surfaceIntent.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { numberRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';

type Rule = 'maxQuads' | 'merge' | 'angle';

const rules: readonly { rule: Rule; words: string; title: string; step?: number }[] = [
    {
        rule: 'maxQuads',
        words: 'Quad limit',
        title: 'With more quads than this the surface is made coarser, and says so',
        step: 1,
    },
    {
        rule: 'merge',
        words: 'Join below',
        title: 'Quads smaller than this part of the separation are joined; 0: never',
    },
    {
        rule: 'angle',
        words: 'Refine above (°)',
        title: 'Neighbouring quads at a larger angle are refined; 180: never',
    },
];

export interface MeshRulesModel {
    edits: Pick<Edits, 'changeSurface' | 'intent'>;
}

export class MeshRules extends ModelElement<MeshRulesModel> {
    static override styles = css`
        :host {
            display: block;
        }
        .row {
            margin-top: 6px;
        }
        input.number {
            width: 9em;
        }
    `;

    override render(): TemplateResult {
        const intent = this.model.edits.intent.value;
        if (intent === null) return html``;
        return html`<details id="mesh-rules">
            <summary class="quiet">Mesh</summary>
            ${rules.map((each) => this.field(each, intent))}
            <label
                class="row"
                for="refine"
                title="Off: the grid that the rake begins with stays as it is, with a column a seed, as in smoke surfaces"
            >
                <span>Refine the grid</span>
                <input id="refine" type="checkbox" .checked=${live(intent.refine === 'on')} @change=${this.refineChanged} />
            </label>
        </details>`;
    }

    private readonly refineChanged = (event: Event): void => {
        this.model.edits.changeSurface({ refine: (event.target as HTMLInputElement).checked ? 'on' : 'off' });
    };

    private field({ rule, words, title, step }: (typeof rules)[number], intent: SurfaceIntent): TemplateResult {
        const [least, most] = surfaceSetRanges[rule];
        return numberRow(words, {
            ...{ id: rule, title, min: least, max: most, shown: String(intent[rule]) },
            change: (value) => {
                const may = step === undefined || Number.isInteger(value / step);
                if (may) this.model.edits.changeSurface({ [rule]: value });
                return may;
            },
        });
    }
}

customElements.define('wakesurf-mesh-rules', MeshRules);
