// The picture as a file: at any size, with or without what lies over it, before any ground or none.
import { html, nothing, type TemplateResult } from 'lit';
import { type Signal, signal } from '@preact/signals-core';
import { type FigureBackground, sizeFault } from '../../scene/capture.ts';
import type { Figure } from '../../session/out/figure.ts';
import { coarseCaption, pictureIsCoarse, timeInName } from '../../session/out/exportNames.ts';
import { timeWords } from '../../session/picture/writtenNumbers.ts';
import { shownTime } from '../../session/time/timeSteps.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { exportStyles } from './exportStyles.ts';
import { checkRow, type Choice, selectRow } from '../base/rows.ts';
import { fileName, saveFile } from '../base/saveFile.ts';
import { ModelElement } from '../base/signalElement.ts';
import { SizeChoice } from './sizeChoice.ts';

const backgrounds: readonly Choice<FigureBackground>[] = [
    { value: 'shown', words: 'as shown' },
    { value: 'white', words: 'white' },
    { value: 'clear', words: 'transparent' },
];
// Kept while the panel shows another tab.
const choice = new SizeChoice('picture', [
    { width: 1920, height: 1080 },
    { width: 3840, height: 2160 },
    { width: 7680, height: 4320 },
]);

export interface PictureExportModel {
    state: AppState;
    view: Pick<ViewState, 'units'>;
    figure: Figure;
}

export class PictureExport extends ModelElement<PictureExportModel> {
    private readonly fault = signal('');

    static override styles = exportStyles;

    override render(): TemplateResult {
        const { figure, state, view } = this.model;
        return html`
            ${choice.render(figure.shownSize)}
            ${selectRow('background', 'Background', backgrounds, figure.background.value, (chosen) => (figure.background.value = chosen))}
            <div class="checks">
                ${this.check('Scalar bar', figure.bar)} ${this.check('Box and axes', figure.axes)}
                ${this.check('Rake', figure.rake)}
                ${pictureIsCoarse(state) ? this.check('Say that it is coarse', figure.coarse) : nothing}
            </div>
            <div class="row"><button type="button" id="save-picture" @click=${this.save}>Save PNG</button></div>
            <p class="hint" id="picture-time">As it is shown, at t = ${timeWords(state, view, shownTime(state))}. The name of the file says so.</p>
            ${this.fault.value === '' ? nothing : html`<p class="hint" role="alert">${this.fault.value}</p>`}
        `;
    }

    private check(label: string, on: Signal<boolean>): TemplateResult {
        return checkRow(label, on.value, (checked) => (on.value = checked));
    }

    private async save(): Promise<void> {
        const { figure, state } = this.model;
        const size = choice.size(figure.shownSize);
        this.fault.value = sizeFault(size) ?? '';
        if (this.fault.value !== '') return;
        try {
            const coarse = pictureIsCoarse(state);
            const picture = figure.draw(size, coarse && figure.coarse.value ? coarseCaption : null);
            const file = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, 'image/png'));
            if (file === null) throw new Error('This browser does not have enough memory for a picture of this size.');
            if (figure.barLeftOut) this.fault.value = 'The picture is too small for the scalar bar, which is left out.';
            saveFile(
                file,
                fileName(
                    state.dataset.value?.name,
                    `${timeInName(shownTime(state))}${coarse ? '-coarse' : ''}-${size.width}x${size.height}.png`,
                ),
            );
        } catch (error) {
            this.fault.value = error instanceof Error ? error.message : String(error);
        }
    }
}

customElements.define('wakesurf-picture-export', PictureExport);
