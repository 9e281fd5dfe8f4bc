// What a figure is to show, chosen once for pictures and films, the picture as it is now, and whether what is on the screen of a surface is
// all that a picture of it will have: what saved pictures and films wait for.
import { type Signal, signal } from '@preact/signals-core';
import type { SurfaceRecord } from '../../protocol/messages.ts';
import type { ScreenSize } from '../../scene/base/view.ts';
import { capture, type FigureBackground } from '../../scene/capture.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { attributesOf } from '../picture/surfaceStyleOf.ts';
import { clampTo, type Span } from '../time/timeSteps.ts';
import { coarseCaption } from './exportNames.ts';
import { type RecipeSource, shownRecipes } from './recipes.ts';

/** What is beside a picture, and what each of them shows, in words. */
export interface BesideFigure {
    figure: Figure;
    captions: readonly [string, string];
    /** Not final. */
    coarse: boolean;
}

export class Figure {
    readonly background = signal<FigureBackground>('shown');
    readonly bar = signal(true);
    readonly axes = signal(true);
    /** A bar of a round length. */
    readonly scale = signal(false);
    /** Notes, and what is probed and measured. */
    readonly marks = signal(true);
    /** Words at the top left. */
    readonly text = signal('');
    readonly rake = signal(false);
    /** Whether a picture that shows a surface before it is final says so. */
    readonly coarse = signal(true);
    /** The last one that was drawn had no room for it. */
    barLeftOut = false;
    /** What a picture has at its right; null: nothing. */
    beside: () => BesideFigure | null = () => null;
    private readonly scene: FlowScene;
    private readonly findBar: () => HTMLElement | null;
    private readonly source: RecipeSource;

    /** `findBar`: the scalar bar that lies over the picture. */
    constructor(scene: FlowScene, findBar: () => HTMLElement | null, source: RecipeSource) {
        this.scene = scene;
        this.findBar = findBar;
        this.source = source;
    }

    /** Returns the recipes of what has just been drawn. */
    async recipes(): Promise<string[]> {
        const beside = this.beside()?.figure.recipes() ?? [];
        return [...(await shownRecipes(this.source)), ...(await beside)];
    }

    /** Returns the size of the picture on the page, in pixels of the screen. */
    get shownSize(): ScreenSize {
        const ratio = Math.max(1, devicePixelRatio);
        const { width, height } = this.scene.size;
        return { width: Math.round(width * ratio), height: Math.round(height * ratio) };
    }

    /** With what is beside it. */
    get sizeOfBoth(): ScreenSize {
        const { width, height } = this.shownSize;
        return { width: width * (this.beside() === null ? 1 : 2), height };
    }

    /** As `draw`, with what is beside it, drawn as this one is. @param coarse  this one is not final */
    drawBoth(size: ScreenSize, coarse: boolean): HTMLCanvasElement {
        const right = this.beside();
        const captionOf = (isCoarse: boolean): string => (isCoarse && this.coarse.value ? coarseCaption : '');
        if (right === null) return this.draw(size, captionOf(coarse) || null);
        const all = document.createElement('canvas');
        Object.assign(all, size);
        const context = all.getContext('2d');
        if (context === null) throw new Error('This browser does not have enough memory for a picture of this size.');
        const width = Math.floor(size.width / 2);
        const [first, second] = [coarse, right.coarse].map((isCoarse, side) =>
            [right.captions[side], captionOf(isCoarse)].filter((each) => each !== '').join(', '),
        ) as [string, string];
        const left = this.draw({ width, height: size.height }, first);
        context.drawImage(left, 0, 0);
        const other = right.figure.drawAs(this, { width: size.width - width, height: size.height }, second);
        context.drawImage(other, width, 0);
        this.barLeftOut ||= right.figure.barLeftOut;
        return all;
    }

    private drawAs(figure: Figure, size: ScreenSize, caption: string): HTMLCanvasElement {
        for (const name of ['background', 'bar', 'axes', 'scale', 'marks', 'text', 'rake'] as const) {
            (this[name] as Signal<unknown>).value = figure[name].value;
        }
        return this.draw(size, caption);
    }

    /** Error: in words, where the graphics cannot draw it. */
    draw(size: ScreenSize, caption: string | null, background = this.background.value, tileSide?: number): HTMLCanvasElement {
        const bar = this.bar.value ? this.findBar() : null;
        const [axes, scale, rake, marks] = [this.axes.value, this.scale.value, this.rake.value, this.marks.value];
        const words = [this.text.value.trim(), caption ?? ''].filter((each) => each !== '').join(', ');
        const shownBar = bar?.hidden === true ? null : bar;
        const drawn = capture(
            this.scene,
            { ...size, background, axes, scale, rake, marks, caption: words === '' ? null : words, bar: shownBar },
            tileSide,
        );
        this.barLeftOut = drawn.barLeftOut;
        return drawn.figure;
    }
}

/** Why it is not; empty where it is. Of a failed surface it says what is missing, for ever. `time`: of the
 *  clock, null: as it is. */
export function unfinishedSurface(
    state: Pick<AppState, 'displayed' | 'hiddenSurfaces' | 'outcomes' | 'requestedEpochs'>,
    view: Pick<ViewState, 'lookOf'>,
    { surface, kind, from, to, fields }: SurfaceRecord,
    time: number | null,
): string {
    if (state.hiddenSurfaces.value.has(surface)) return '';
    const displayed = state.displayed.value.get(surface);
    if (displayed === undefined || displayed.epoch < (state.requestedEpochs.value.get(surface) ?? 0)) {
        return `${surface} is not there`;
    }
    if (displayed.phase !== 'final') return `${surface} is ${displayed.phase}`;
    // Without them it is drawn as if they never came: colours of before, smoke as the picture guesses it.
    const look = view.lookOf(surface);
    const missing = attributesOf(look, fields).filter((name) => displayed.withheld.includes(name));
    if (missing.length > 0) return `${surface} has no ${missing.join(', ')} yet`;
    if (state.outcomes.value.get(surface)?.intervalPending === true) return `the error of ${surface} is not estimated yet`;
    if (look.curved && !displayed.curved) return `the cells of ${surface} are not curved yet`;
    if (time !== null && kind !== 'stream' && !isShownAt({ from, to }, displayed.time, time)) {
        return `${surface} is shown at ${displayed.time}`;
    }
    return '';
}

/** Returns whether a surface that moves is drawn as it is at a time, or at its end that is nearer; backward
 *  ones end before `from`. */
export function isShownAt({ from, to }: { from: number; to: number }, shown: number, time: number): boolean {
    const span: Span = [Math.min(from, to), Math.max(from, to)];
    return Math.abs(shown - clampTo(span, time)) <= 1e-6 * (span[1] - span[0]);
}
