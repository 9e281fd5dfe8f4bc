// The surface as a file for other programs.
import { html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import { meshSteps } from '../../session/out/panelSteps.ts';
import type { MeshFormat } from '../../session/out/scriptStep.ts';
import type { AppModel } from '../base/appModel.ts';
import './copyAs.ts';
import { exportStyles } from './exportStyles.ts';
import { fileName, saveFile } from '../base/saveFile.ts';
import { sharedStyles } from '../base/sharedStyles.ts';
import { SignalElement } from '../base/signalElement.ts';

const formats: readonly { format: MeshFormat; words: string }[] = [
    { format: 'vtp', words: 'vtp: ParaView, VTK' },
    { format: 'glb', words: 'glb: glTF, Draco' },
    { format: 'ply', words: 'ply: MeshLab, Blender' },
    { format: 'obj', words: 'obj: any program' },
    { format: 'drc', words: 'drc: Draco alone' },
];
const chosen = signal<MeshFormat>('vtp');

export class MeshExport extends SignalElement {
    static override properties = { model: { attribute: false } };
    declare model: AppModel;

    static override styles = [sharedStyles, exportStyles];

    override render(): TemplateResult {
        const { mesh, state } = this.model;
        const { state: progress, words } = mesh.progress.value;
        const waiting = progress === 'waiting';
        return html`
            <label
                >Format
                <select id="mesh-format" @change=${this.formatChosen}>
                    ${formats.map(
                        ({ format, words: label }) =>
                            html`<option value=${format} .selected=${format === chosen.value}>${label}</option>`,
                    )}
                </select>
            </label>
            <div class="row">
                <button
                    type="button"
                    id="download-mesh"
                    ?disabled=${waiting || state.surface.value === undefined}
                    @click=${this.download}
                >
                    Download mesh
                </button>
                ${waiting ? html`<button type="button" @click=${() => mesh.cancel()}>Cancel</button>` : nothing}
            </div>
            ${words === '' ? nothing : html`<p role=${progress === 'failed' ? 'alert' : 'status'}>${words}</p>`}
            <wakesurf-copy-as
                .model=${this.model}
                .calls=${() => meshSteps(state, chosen.value)}
            ></wakesurf-copy-as>
        `;
    }

    private formatChosen(event: Event): void {
        const { value } = event.target as HTMLSelectElement;
        chosen.value = formats.find(({ format }) => format === value)?.format ?? 'vtp';
    }

    private async download(): Promise<void> {
        const { mesh, state } = this.model;
        const format = chosen.value;
        const { activeSurface, session, surface } = state;
        if (activeSurface.value === null || session.value === null) return;
        const kind = surface.value?.kind ?? 'surface';
        const file = await mesh.fetch(session.value, activeSurface.value, format);
        if (file !== null) saveFile(file, fileName(state.dataset.value?.name, `${kind}.${format}`));
    }
}

customElements.define('wakesurf-mesh-export', MeshExport);
