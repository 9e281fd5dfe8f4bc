// The tab "Export": what one takes away.
import { html, type TemplateResult } from 'lit';
import type { AppModel } from '../base/appModel.ts';
import './filmExport.ts';
import './meshExport.ts';
import './pictureExport.ts';

export function exportBody(model: AppModel): TemplateResult {
    return html`
        <section aria-labelledby="picture-head">
            <h2 id="picture-head">Picture</h2>
            <wakesurf-picture-export .model=${model}></wakesurf-picture-export>
        </section>
        <section aria-labelledby="film-head">
            <h2 id="film-head">Film of the playback</h2>
            <wakesurf-film-export .model=${model}></wakesurf-film-export>
        </section>
        <section aria-labelledby="mesh-head">
            <h2 id="mesh-head">Mesh of the surface</h2>
            <wakesurf-mesh-export .model=${model}></wakesurf-mesh-export>
        </section>
    `;
}
