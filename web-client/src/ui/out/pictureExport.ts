// The picture as a file, at any size, with or without what lies over it, before any ground or none; and a film of the playback, frame by
// frame.
import { type Signal, signal } from '@preact/signals-core';
import { html, nothing, type TemplateResult } from 'lit';
import { live } from 'lit/directives/live.js';
import { type FigureBackground, sizeFault } from '../../scene/capture.ts';
import { pictureIsCoarse, timeInName } from '../../session/out/exportNames.ts';
import type { Figure } from '../../session/out/figure.ts';
import { type FilmMaker, type FilmProgress, maxFrames, frameTimes } from '../../session/out/film.ts';
import type { FilmFormat } from '../../session/out/filmFile.ts';
import { pngWith } from '../../session/out/recipes.ts';
import { canEncode } from '../../session/out/videoEncoding.ts';
import { timeText, timeWords } from '../../session/picture/writtenNumbers.ts';
import type { Playback } from '../../session/time/playback.ts';
import { shownTime } from '../../session/time/timeSteps.ts';
import type { AppState } from '../../state/appState.ts';
import type { CameraPose } from '../../scene/camera/cameraControls.ts';
import { isolated } from '../../state/announcements.ts';
import { readPageView } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import '../base/locked.ts';
import type { OwnCopyButton } from '../base/locked.ts';
import { checkRow, type Choice, numberRow, selectRow } from '../base/rows.ts';
import { ModelElement } from '../base/signalElement.ts';
import { fileName, saveFile } from '../base/copyAndSave.ts';
import { exportStyles, SizeChoice } from './exportParts.ts';

const backgrounds: readonly Choice<FigureBackground>[] = [
    { value: 'shown', words: 'as shown' },
    { value: 'white', words: 'white' },
    { value: 'clear', words: 'transparent' },
];
// Kept while the panel shows another tab.
const pictureSize = new SizeChoice('picture', [
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
            ${pictureSize.render(figure.sizeOfBoth)}
            ${selectRow('background', 'Background', backgrounds, figure.background.value, (chosen) => (figure.background.value = chosen))}
            <div class="checks">
                ${this.check('Scalar bar', figure.bar)} ${this.check('Box and axes', figure.axes)}
                ${this.check('Length scale', figure.scale)} ${this.check('Rake', figure.rake)}
                ${this.check('Notes and marks', figure.marks)}
                ${pictureIsCoarse(state) || figure.beside()?.coarse === true ? this.check('Say that it is coarse', figure.coarse) : nothing}
            </div>
            <div class="row">
                <label for="figure-text">Text</label>
                <input
                    id="figure-text"
                    maxlength="120"
                    placeholder="at the top left"
                    .value=${live(figure.text.value)}
                    @change=${(event: Event) => (figure.text.value = (event.target as HTMLInputElement).value)}
                />
            </div>
            <div class="row"><button type="button" id="save-picture" @click=${this.save}>Save PNG</button></div>
            <p class="hint" id="picture-time">As it is shown, at t = ${timeWords(state, view, shownTime(state))}. The name of the file says so.
                ${figure.beside() === null ? nothing : 'With both halves of the comparison.'}</p>
            ${this.fault.value === '' ? nothing : html`<p class="hint" role="alert">${this.fault.value}</p>`}
        `;
    }

    private check(label: string, on: Signal<boolean>): TemplateResult {
        return checkRow(label, on.value, (checked) => (on.value = checked));
    }

    private async save(): Promise<void> {
        const { figure, state } = this.model;
        const size = pictureSize.size(figure.sizeOfBoth);
        this.fault.value = sizeFault(size) ?? '';
        if (this.fault.value !== '') return;
        try {
            const coarse = pictureIsCoarse(state) || figure.beside()?.coarse === true;
            const picture = figure.drawBoth(size, pictureIsCoarse(state));
            const recipes = await figure.recipes();
            const drawn = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, 'image/png'));
            if (drawn === null) throw new Error('This browser does not have enough memory for a picture of this size.');
            if (figure.barLeftOut) this.fault.value = 'The picture is too small for the scalar bar, which is left out.';
            saveFile(
                pngWith(recipes, drawn),
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

const rates = [12, 24, 25, 30, 60].map((value) => ({ value, words: String(value) }));
// Kept while the panel shows another tab.
const filmSize = new SizeChoice('film', [
    { width: 1280, height: 720 },
    { width: 1920, height: 1080 },
    { width: 3840, height: 2160 },
]);
const fps = signal(25);
const seconds = signal(10);
const time = signal(true);
const formats: readonly Choice<FilmFormat>[] = [
    { value: 'webm', words: 'WebM' },
    { value: 'mp4', words: 'MP4 (H.264)' },
];
const format = signal<FilmFormat>('webm');
/** Saved views that the camera goes through, in the order in which they were chosen. */
const path = signal<readonly string[]>([]);

export interface FilmExportModel {
    state: Pick<AppState, 'bookmarks' | 'dataset' | 'participants' | 'role' | 'surfaces'>;
    view: Pick<ViewState, 'units'>;
    playback: Pick<Playback, 'mode' | 'span'>;
    figure: Pick<Figure, 'beside' | 'shownSize'>;
    film: Pick<FilmMaker, 'record' | 'cancel' | 'progress'>;
    ownCopy: OwnCopyButton['model'];
}

/** A film of the playback. */
export class FilmExport extends ModelElement<FilmExportModel> {
    private readonly fault = signal('');

    static override styles = exportStyles;

    override render(): TemplateResult {
        const { film, figure, playback, state } = this.model;
        const reason = this.whyNot();
        if (reason !== null) return html`<p class="hint">${reason}</p>`;
        if (state.role.value === 'viewer' && playback.mode.value !== 'none') {
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
        const still = playback.mode.value === 'none' && this.poses().length < 2;
        const others = state.participants.value.size > 1 && playback.mode.value === 'clock';
        return html`
            ${figure.beside() === null ? nothing : html`<p class="hint">A film has the left half only.</p>`}
            ${filmSize.render(figure.shownSize)}
            ${selectRow('film-fps', 'Frames per second', rates, fps.value, (rate) => (fps.value = rate))}
            ${numberRow('Length in seconds', {
                ...{ id: 'film-seconds', min: 0.1, max: maxFrames / fps.value, shown: String(seconds.value) },
                change: (typed) => void (seconds.value = typed),
            })}
            ${checkRow('Time in the picture', time.value, (on) => (time.value = on))}
            ${selectRow('film-format', 'Format', formats, format.value, (chosen) => (format.value = chosen))} ${this.cameraPath()}
            <div class="row">
                <button type="button" id="record-film" ?disabled=${still} @click=${this.record}>Record</button>
            </div>
            ${still ? html`<p class="hint">Nothing here changes with time: choose two saved views for the camera to go between.</p>` : nothing}
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
        return canEncode() ? null : 'Recording needs a current browser over HTTPS (or on localhost).';
    }

    /** Those that have one, of the views that were chosen and are still there. */
    private poses(): CameraPose[] {
        const { bookmarks } = this.model.state;
        return path.value.flatMap((id) => readPageView(bookmarks.value.get(id)?.view).camera ?? []);
    }

    private cameraPath(): TemplateResult {
        const { bookmarks } = this.model.state;
        const views = [...bookmarks.value.values()].filter(({ view }) => readPageView(view).camera !== undefined);
        if (views.length < 2) {
            return html`<p class="hint">The camera stays where it is. Keep two views or more (View, Saved views), and it can go through them.</p>`;
        }
        return html`<fieldset>
            <legend>Camera through saved views</legend>
            ${views.map(({ bookmark, name }) => {
                const place = path.value.filter((each) => bookmarks.value.has(each)).indexOf(bookmark);
                const words = place < 0 ? isolated(name) : `${isolated(name)}, ${place + 1}`;
                const change = (on: boolean): void => {
                    path.value = on ? [...path.value, bookmark] : path.value.filter((each) => each !== bookmark);
                };
                return checkRow(words, place >= 0, change);
            })}
            <p class="hint">${this.poses().length < 2 ? 'None or one: the camera stays where it is.' : 'In this order, evenly over the film.'}</p>
        </fieldset>`;
    }

    private async record(): Promise<void> {
        const { film, figure, state, view } = this.model;
        const size = filmSize.size(figure.shownSize);
        this.fault.value = sizeFault(size) ?? '';
        if (this.fault.value !== '') return;
        const file = await film.record({
            ...size,
            fps: fps.value,
            seconds: seconds.value,
            time: time.value,
            unit: view.units.value.time,
            format: format.value,
            path: this.poses().length < 2 ? [] : this.poses(),
        });
        if (file !== null) saveFile(file, fileName(state.dataset.value?.name, `film.${format.value}`));
    }
}

customElements.define('wakesurf-film-export', FilmExport);
