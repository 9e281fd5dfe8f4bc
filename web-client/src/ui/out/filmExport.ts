// A film of the playback, frame by frame.
import { html, nothing, type TemplateResult } from 'lit';
import { signal } from '@preact/signals-core';
import { sizeFault } from '../../scene/capture.ts';
import { timeText } from '../../session/picture/writtenNumbers.ts';
import { type FilmMaker, type FilmProgress, framesAtMost, frameTimes } from '../../session/out/film.ts';
import { canEncode } from '../../session/out/videoEncoding.ts';
import type { Figure } from '../../session/out/figure.ts';
import type { Playback } from '../../session/time/playback.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { exportStyles } from './exportStyles.ts';
import { fileName, saveFile } from '../base/saveFile.ts';
import { ModelElement } from '../base/signalElement.ts';
import '../share/ownCopy.ts';
import type { OwnCopyButton } from '../share/ownCopy.ts';
import { checkRow, numberRow, selectRow } from '../base/rows.ts';
import { SizeChoice } from './sizeChoice.ts';

const rates = [12, 24, 25, 30, 60].map((value) => ({ value, words: String(value) }));
// Kept while the panel shows another tab.
const choice = new SizeChoice('film', [
    { width: 1280, height: 720 },
    { width: 1920, height: 1080 },
    { width: 3840, height: 2160 },
]);
const fps = signal(25);
const seconds = signal(10);
const time = signal(true);

export interface FilmExportModel {
    state: Pick<AppState, 'dataset' | 'participants' | 'role' | 'surfaces'>;
    view: Pick<ViewState, 'units'>;
    playback: Pick<Playback, 'mode' | 'span'>;
    figure: Pick<Figure, 'shownSize'>;
    film: Pick<FilmMaker, 'record' | 'cancel' | 'progress'>;
    ownCopy: OwnCopyButton['model'];
}

export class FilmExport extends ModelElement<FilmExportModel> {
    private readonly fault = signal('');

    static override styles = exportStyles;

    override render(): TemplateResult {
        const { film, figure, playback, state } = this.model;
        const reason = this.whyNot();
        if (reason !== null) return html`<p class="hint">${reason}</p>`;
        if (state.role.value === 'viewer') {
            return html`<p class="hint">
                Recording changes the time for everyone, which your link does not allow.
                <wakesurf-own-copy .model=${this.model.ownCopy}></wakesurf-own-copy>
            </p>`;
        }
        const progress = film.progress.value;
        if (progress.state === 'measuring' || progress.state === 'recording') return this.recording(progress);
        const [from, to] = playback.span.value;
        const frames = frameTimes([from, to], { fps: fps.value, seconds: seconds.value }).length;
        const words = this.fault.value === '' ? progress.words : this.fault.value;
        const others = state.participants.value.size > 1 && playback.mode.value === 'clock';
        return html`
            ${choice.render(figure.shownSize)}
            ${selectRow('film-fps', 'Frames per second', rates, fps.value, (rate) => (fps.value = rate))}
            ${numberRow('Length in seconds', {
                ...{ id: 'film-seconds', min: 0.1, max: framesAtMost / fps.value, shown: String(seconds.value) },
                change: (typed) => void (seconds.value = typed),
            })}
            ${checkRow('Time in the picture', time.value, (on) => (time.value = on))}
            <div class="row">
                <button type="button" id="record-film" @click=${this.record}>Record WebM</button>
            </div>
            ${words === '' ? nothing : html`<p class="hint" role="alert">${words}</p>`}
            <p class="hint">
                From t = ${timeText(state, from)} to ${timeText(state, to)} in ${frames} frames, each drawn when its
                surface is there. Colours mean the same in all of them: their range is looked up first. Background, bar, axes and rake as above.
                ${others ? 'The others in this session see the time change while you record.' : ''}
            </p>
        `;
    }

    private recording({ state, done, frames }: FilmProgress): TemplateResult {
        const words = state === 'measuring' ? 'Looking up the range of the colours' : 'Frame';
        return html`<label class="row" for="film-progress">${words} ${done} of ${frames}</label>
            <progress id="film-progress" max=${frames} .value=${done}></progress>
            <div class="row"><button type="button" @click=${() => this.model.film.cancel()}>Cancel</button></div>
            <p class="hint">Keep this page visible: browsers do not draw hidden pages.</p>`;
    }

    private whyNot(): string | null {
        const { playback } = this.model;
        if (!canEncode()) {
            return 'Recording needs a current browser over HTTPS (or on localhost).';
        }
        return playback.mode.value === 'none' ? 'The data have only one time-step: there is nothing to play.' : null;
    }

    private async record(): Promise<void> {
        const { film, figure, state, view } = this.model;
        const size = choice.size(figure.shownSize);
        this.fault.value = sizeFault(size) ?? '';
        if (this.fault.value !== '') return;
        const file = await film.record({
            ...size,
            fps: fps.value,
            seconds: seconds.value,
            time: time.value,
            unit: view.units.value.time,
        });
        if (file !== null) saveFile(file, fileName(state.dataset.value?.name, 'film.webm'));
    }
}

customElements.define('wakesurf-film-export', FilmExport);
