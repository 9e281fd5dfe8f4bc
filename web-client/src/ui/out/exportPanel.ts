// The tab "Export": what one takes away.
import { html, type TemplateResult } from 'lit';
import './filmExport.ts';
import type { FilmExportModel } from './filmExport.ts';
import './meshExport.ts';
import type { MeshExportModel } from './meshExport.ts';
import './pictureExport.ts';
import type { PictureExportModel } from './pictureExport.ts';

export interface ExportModel {
    picture: PictureExportModel;
    film: FilmExportModel;
    mesh: MeshExportModel;
}

export function exportBody(model: ExportModel): TemplateResult {
    return html`
        <section aria-labelledby="picture-head">
            <h2 id="picture-head">Picture</h2>
            <wakesurf-picture-export .model=${model.picture}></wakesurf-picture-export>
        </section>
        <section aria-labelledby="film-head">
            <h2 id="film-head">Film of the playback</h2>
            <wakesurf-film-export .model=${model.film}></wakesurf-film-export>
        </section>
        <section aria-labelledby="mesh-head">
            <h2 id="mesh-head">Mesh of the surface</h2>
            <wakesurf-mesh-export .model=${model.mesh}></wakesurf-mesh-export>
        </section>
    `;
}
