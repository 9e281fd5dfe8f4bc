// The surface in motion, as one page that needs no server: its times, and how many of them.
import { signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit';
import type { SurfaceRecord } from '../../protocol/messages.ts';
import { savedLook } from '../../scene/surface/savedLook.ts';
import type { SurfaceStyle } from '../../scene/surface/surfaceStyle.ts';
import type { MeshDownload } from '../../session/out/meshDownload.ts';
import { timeField } from '../../session/picture/writtenNumbers.ts';
import type { AppState } from '../../state/appState.ts';
import { fileName, saveFile } from '../base/copyAndSave.ts';
import { numberRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { exportStyles } from './exportParts.ts';

/** As the server has it. */
const mostSteps = 2000;
// Kept while the panel shows another tab.
const steps = signal(200);
/** What a user has chosen, of one surface as it was then. */
const chosen = signal<{ of: string; from: number; to: number } | null>(null);

export interface AnimationExportModel {
    state: AppState;
    animation: Pick<MeshDownload, 'get' | 'cancel' | 'progress'>;
    /** How a surface is drawn; null: it is not. */
    styleOf: (surface: string) => SurfaceStyle | null;
}

export class AnimationExport extends ModelElement<AnimationExportModel> {
    static override styles = exportStyles;

    override render(): TemplateResult {
        const { animation, state } = this.model;
        const record = state.surface.value;
        const still = whyStill(record, state.dataset.value?.steady === true);
        if (record === undefined || still !== null) return html`<p class="hint">${still}</p>`;
        const { state: progress, words } = animation.progress.value;
        const waiting = progress === 'waiting';
        const { from, to } = times(record);
        const grows = record.kind === 'path' || record.kind === 'stream';
        return html`
            ${this.time('From', 'animation-from', from, (typed) => ({ from: typed, to }))}
            ${this.time('To', 'animation-to', to, (typed) => ({ from, to: typed }))}
            ${numberRow('Steps', {
                ...{ id: 'animation-steps', min: 2, max: mostSteps, shown: String(steps.value) },
                change: (typed) => void (steps.value = Math.round(typed)),
            })}
            <div class="row">
                <button type="button" id="download-animation" ?disabled=${waiting || from === to} @click=${() => this.save()}>
                    Download animation
                </button>
                ${waiting ? html`<button type="button" @click=${() => animation.cancel()}>Cancel</button>` : nothing}
            </div>
            <p class="hint">
                One .html for a talk or a mail, which any browser opens without a server: the surface
                ${grows ? 'grows' : record.kind === 'level' ? 'changes' : 'moves'}, with the colours that are shown and the body, and it can
                be turned. The file says how it was made, and wakesurf verify makes it again.
            </p>
            ${words === '' ? nothing : html`<p class="hint" role=${progress === 'failed' ? 'alert' : 'status'}>${words}</p>`}
        `;
    }

    private time(
        words: string,
        id: string,
        shown: number,
        change: (typed: number) => { from: number; to: number },
    ): TemplateResult {
        const record = this.model.state.surface.value!;
        const [low, high] = [Math.min(record.from, record.to), Math.max(record.from, record.to)];
        return numberRow(words, {
            ...{ id, min: low, max: high, shown: timeField(this.model.state, shown) },
            change: (typed) => void (chosen.value = { of: keyOf(record), ...change(typed) }),
        });
    }

    private async save(): Promise<void> {
        const { animation, state, styleOf } = this.model;
        const record = state.surface.value;
        if (record === undefined || state.session.value === null) return;
        const { from, to } = times(record);
        const style = styleOf(record.surface);
        const query = new URLSearchParams({
            times: `${from}:${to}:${Math.abs(to - from) / (steps.value - 1)}`,
            ...(style === null ? {} : { look: JSON.stringify(savedLook(style)) }),
        });
        const path = `animation.html?${query.toString()}`;
        const got = await animation.get(state.session.value, record.surface, path, `Building ${steps.value} steps …`);
        if (got !== null) saveFile(got.file, fileName(state.dataset.value?.name, `${record.kind}-animation.html`));
    }
}

function keyOf({ surface, from, to }: SurfaceRecord): string {
    return `${surface} ${from} ${to}`;
}

function times(record: SurfaceRecord): { from: number; to: number } {
    return chosen.value?.of === keyOf(record) ? chosen.value : record;
}

/** Says why there is nothing to see in motion; null: there is. */
function whyStill(record: SurfaceRecord | undefined, steady: boolean): string | null {
    if (record === undefined) return 'There is no surface yet.';
    if (record.from === record.to) return 'Nothing moves: the surface is of one time.';
    return record.kind === 'level' && steady
        ? 'Nothing moves: the level surface of a steady flow is the same at all times.'
        : null;
}

customElements.define('wakesurf-animation-export', AnimationExport);
