// The surface as a file for other programs.
import { html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import { meshIsCoarse, meshTimeWords, pieceText } from '../../session/out/exportNames.ts';
import type { MeshFile } from '../../session/out/scripts.ts';
import type { MeshDownload } from '../../session/out/meshDownload.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { exportStyles } from './exportParts.ts';
import { checkRow, type Choice, selectRow } from '../base/rows.ts';
import { fileName, saveFile } from '../base/copyAndSave.ts';
import { ModelElement } from '../base/signalElement.ts';

type FileChoice = MeshFile & Choice<string>;

const vtp: FileChoice = { value: 'vtp', format: 'vtp', words: '.vtp for ParaView and VTK' };
const choices: readonly FileChoice[] = [
    vtp,
    { value: 'glb-plain', format: 'glb', draco: false, words: '.glb for ParaView, glTF viewers' },
    { value: 'glb', format: 'glb', words: '.glb, small, for the web and Blender' },
    { value: 'ply', format: 'ply', words: '.ply for MeshLab and Blender' },
    { value: 'obj', format: 'obj', words: '.obj for most 3D programs' },
    { value: 'drc', format: 'drc', words: '.drc for programs that read Draco' },
];
const chosen = signal<FileChoice>(vtp);
/** Points, lines, ribbons and arrows that are shown of the surface go into the file instead of its mesh. */
const asShown = signal(true);

export interface MeshExportModel {
    state: AppState;
    view: Pick<ViewState, 'lookOf' | 'units'>;
    mesh: MeshDownload;
}

export class MeshExport extends ModelElement<MeshExportModel> {
    static override styles = exportStyles;

    override render(): TemplateResult {
        const { mesh, state, view } = this.model;
        const { state: progress, words } = mesh.progress.value;
        const waiting = progress === 'waiting';
        return html`
            ${selectRow('mesh-format', 'Format', choices, chosen.value.value, (value) => {
                chosen.value = choices.find((each) => each.value === value) ?? vtp;
            })}
            ${this.piecesRow()}
            <div class="row">
                <button
                    type="button"
                    id="download-mesh"
                    ?disabled=${waiting || state.surface.value === undefined}
                    @click=${() => downloadMesh(this.model)}
                >
                    Download mesh
                </button>
                ${meshIsCoarse(state) ? html`<button type="button" @click=${() => downloadMesh(this.model, true)}>As it is now</button>` : nothing}
                ${waiting ? html`<button type="button" @click=${() => mesh.cancel()}>Cancel</button>` : nothing}
            </div>
            <p class="hint" id="mesh-time">${meshTimeWords(state, view)}</p>
            ${words === '' ? nothing : html`<p class="hint" role=${progress === 'failed' ? 'alert' : 'status'}>${words}</p>`}
        `;
    }

    private piecesRow(): TemplateResult | typeof nothing {
        const pieces = shownPieces(this.model);
        if (pieces === null) return nothing;
        const none = !canHold(chosen.value, pieces);
        const wanting = pieces === 'points' ? 'points are for .ply alone' : 'a .drc has no lines';
        const words = none ? `The whole mesh: ${wanting}` : `Only what is shown of it, as ${pieces.split(':')[0]}`;
        return checkRow(words, asShown.value && !none, (on) => (asShown.value = on), { id: 'mesh-pieces', disabled: none });
    }
}

function shownPieces({ state, view }: Pick<MeshExportModel, 'state' | 'view'>): string | null {
    const record = state.surface.value;
    return record === undefined ? null : pieceText(view.lookOf(state.activeSurface.value), record, state.dataset.value?.bounds);
}

function canHold({ format }: MeshFile, pieces: string): boolean {
    return pieces === 'points' ? format === 'ply' : format !== 'drc';
}

/** Returns the file that the panel is set to. */
export function chosenMesh(model: Pick<MeshExportModel, 'state' | 'view'>): MeshFile {
    const lines = shownPieces(model);
    return lines !== null && asShown.value && canHold(chosen.value, lines) ? { ...chosen.value, lines } : chosen.value;
}

/** In the format that is chosen. @param now  also where it is not final yet, which the name says then */
export async function downloadMesh(model: Pick<MeshExportModel, 'mesh' | 'state' | 'view'>, now = false): Promise<void> {
    const { mesh, state } = model;
    const choice = chosenMesh(model);
    const { activeSurface, session, surface } = state;
    if (activeSurface.value === null || session.value === null) return;
    const kind = surface.value?.kind ?? 'surface';
    const got = await mesh.fetch(session.value, activeSurface.value, now ? { ...choice, now } : choice);
    if (got === null) return;
    const name = `${kind}${got.coarse ? '-coarse' : ''}.${choice.format}`;
    saveFile(got.file, fileName(state.dataset.value?.name, name));
}

customElements.define('wakesurf-mesh-export', MeshExport);
