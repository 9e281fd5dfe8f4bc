// Shows what colours mean: a bar for each field that is seen, with the colour table and numbers, as text that
// can be read aloud.
import type { ReadonlySignal } from '@preact/signals-core';
import { css, html, nothing, type TemplateResult } from 'lit';
import { colourTable, colourTicks, fractionOf, scaleOf, tableSize } from '../../scene/surface/colourMap.ts';
import { placeNumbers, resolutionOf, shortNumber } from '../../scene/base/numbers.ts';
import type { DatasetDescription } from '../../protocol/messages.ts';
import type { SurfaceStyle } from '../../scene/surface/surfaceStyle.ts';
import type { FlowScene } from '../../scene/scene.ts';
import type { AppState } from '../../state/appState.ts';
import { bodyId, shows } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { BodyFields } from '../../session/picture/bodyFields.ts';
import { ownerName } from '../../session/picture/surfaceOwner.ts';
import type { FieldMeaning } from '../../session/picture/fieldColours.ts';
import type { Lines } from '../../session/picture/linesInPicture.ts';
import type { Slices } from '../../session/picture/slicesInPicture.ts';
import { intervalError } from '../../session/picture/surfaceStyleOf.ts';
import { withUnit } from '../../session/picture/writtenNumbers.ts';
import { colourTitle } from './colourNames.ts';
import { ModelElement } from '../base/signalElement.ts';

export interface ScalarBarModel {
    state: AppState;
    view: ViewState;
    scene: Pick<FlowScene, 'surfaces'>;
    bodyFields: Pick<BodyFields, 'span'>;
    /** Null: not loaded yet. */
    slices: ReadonlySignal<{ slices: Pick<Slices, 'meanings'> } | null>;
    /** Likewise. */
    lines: ReadonlySignal<{ lines: Pick<Lines, 'meanings'> } | null>;
}

const rangeWords = {
    surface: 'of this surface',
    surfaces: 'of all surfaces shown',
    data: 'of all the data',
    locked: 'locked',
    film: 'of the whole film',
    body: 'of the body',
};
const plainScale = { inverted: false, logarithmic: false, root: false, bands: 0 };
const scaleWords = { even: '', root: ', by the root', log: ', logarithmic' };
const shortScale = { even: '', root: ', root', log: ', log' };
/** More would cover the picture. */
const barsAtMost = 4;

/** What a bar shows, of all that it is true of. */
interface Bar extends Pick<SurfaceStyle, 'map' | 'inverted' | 'logarithmic' | 'root' | 'bands' | 'beyond'> {
    title: string;
    /** What is subtracted, in words. */
    less?: string;
    colours: readonly [number, number];
    rangeOf: keyof typeof rangeWords | null;
    of: string[];
}

export class ScalarBar extends ModelElement<ScalarBarModel> {
    private bars: Bar[] = [];
    /** What surfaces have no values of, and one colour instead. */
    private readonly missing = new Set<string>();

    static override styles = css`
        :host([hidden]) {
            display: none;
        }
        :host {
            display: block;
            width: 260px;
            padding: 8px 14px 6px;
            border-radius: 8px;
            background: light-dark(#f6f8fb, #0d131d);
            font-size: 12px;
            pointer-events: none;
        }
        figure {
            margin: 0;
        }
        figure + figure {
            margin-top: 8px;
        }
        canvas {
            display: block;
            width: 100%;
            height: 12px;
            border-radius: 3px;
        }
        figcaption {
            display: flex;
            flex-wrap: wrap;
            justify-content: space-between;
            gap: 0 8px;
            margin-bottom: 4px;
        }
        /* A line of its own where both do not fit: a figure repeats what stands here span by span, each in one line. */
        figcaption span {
            white-space: nowrap;
        }
        .range {
            color: var(--quiet);
            font-variant-numeric: tabular-nums;
        }
        p {
            margin: 4px 0;
            white-space: nowrap;
        }
        .ticks {
            position: relative;
            height: 18px;
            margin-top: 3px;
            font-variant-numeric: tabular-nums;
        }
        .ticks span {
            position: absolute;
            transform: translateX(-50%);
        }
    `;

    override render(): TemplateResult {
        const { state, view } = this.model;
        // Whenever one of these changes, what is drawn may.
        void [
            state.displayed.value,
            view.looks.value,
            state.speedRange.value,
            state.valueRanges.value,
            view.fixedRanges.value,
            view.rangesBeside.value,
        ];
        const all = this.barsShown();
        this.bars = all.slice(0, barsAtMost);
        this.hidden = this.bars.length + this.missing.size === 0;
        const more = all.length - this.bars.length;
        return html`${this.bars.map((bar) => this.bar(bar, all.length > 1))}
        ${more > 0 ? html`<p class="range">and ${more} more</p>` : nothing} ${this.errors()}
        ${[...this.missing].map((title) => html`<p class="range lacked">${title}: no values, so one colour</p>`)}`;
    }

    /** How far the selected surface may be off, for figures: they repeat what stands here. */
    private errors(): TemplateResult | typeof nothing {
        const { state, view } = this.model;
        const id = state.activeSurface.value ?? '';
        const { error99, intervalError99, intervalUnresolved = 0, separation = 0 } = state.outcomes.value.get(id) ?? {};
        if (intervalError99 === undefined) return nothing;
        const short = (value: number): string => withUnit(shortNumber(Number(value.toPrecision(2))), view.units.value.length);
        const hatched = view.lookOf(id).hatched && state.surfaces.value.get(id)?.fields.includes(intervalError) === true;
        return html`${error99 === undefined ? nothing : html`<p class="range">99 % traced within ${short(error99)}</p>`}
            <p class="range">between stored times within ${short(intervalError99)}</p>
            ${hatched && (intervalUnresolved > 0 || intervalError99 > separation) ? html`<p class="range">hatched: beyond the separation</p>` : nothing}`;
    }

    /** One for each meaning of colours that is seen, that of the selected surface first. */
    private barsShown(): Bar[] {
        const { state, view, scene } = this.model;
        const active = state.activeSurface.value ?? '';
        const ids = [...state.surfaces.value.keys()];
        const bars = new Map<string, Bar>();
        this.missing.clear();
        for (const id of [active, ...ids.filter((each) => each !== active)]) {
            const record = state.surfaces.value.get(id);
            const span = scene.surfaces.spanOf(id);
            if (record === undefined || span === null) continue;
            const { style, colours, lacks } = span;
            const { map, inverted, logarithmic, root, bands: bandCount, beyond } = style;
            const titleOf = (shown: Pick<SurfaceStyle, 'source' | 'scalar'>): string =>
                colourTitle(shown, state.described(record.dataset), record.kind, view.units.value);
            if (lacks !== '') this.missing.add(titleOf({ source: 'scalar', scalar: lacks }));
            if (style.source === 'constant') continue;
            const title = titleOf(style);
            const key = JSON.stringify([title, colours, map, inverted, logarithmic, root, bandCount, style.rangeOf]);
            const of = ownerName(state, record);
            const held = bars.get(key);
            const rangeOf = style.source === 'scalar' || style.rangeOf === 'film' ? style.rangeOf : null;
            if (held === undefined) {
                bars.set(key, { title, colours, map, inverted, logarithmic, root, bands: bandCount, beyond, rangeOf, of: [of] });
            } else if (!held.of.includes(of)) held.of.push(of);
        }
        return [...bars.values(), ...this.bodyBar(), ...this.barsOfFields()];
    }

    /** Slices and lines of which colours mean the same have one. */
    private barsOfFields(): Bar[] {
        const { state, slices, lines } = this.model;
        const bars = new Map<string, Bar>();
        const add = (
            of: string,
            records: ReadonlyMap<string, { dataset: string }>,
            meanings: Iterable<[string, FieldMeaning]>,
        ): void => {
            for (const [id, { field, less, map, range }] of meanings) {
                const title = this.titleOf(field, state.described(records.get(id)?.dataset ?? ''));
                const key = JSON.stringify([title, less, map, range]);
                const held = bars.get(key);
                if (held === undefined) {
                    const style = { ...plainScale, beyond: [null, null] as [null, null] };
                    bars.set(key, { title, less, colours: range, map, ...style, rangeOf: null, of: [of] });
                } else if (!held.of.includes(of)) held.of.push(of);
            }
        };
        add('slice', state.slices.value, slices.value?.slices.meanings.value ?? []);
        add('streamlines', state.lines.value, lines.value?.lines.meanings.value ?? []);
        return [...bars.values()];
    }

    /** @param field  as the server knows it */
    private titleOf(field: string, dataset: DatasetDescription | null): string {
        const { view } = this.model;
        const scalar = field === dataset?.velocity ? 'speed' : field;
        return colourTitle({ source: 'scalar', scalar }, dataset, undefined, view.units.value);
    }

    private bodyBar(): Bar[] {
        const span = this.model.bodyFields.span.value;
        if (span === null || !shows(this.model.view.visibility.value, bodyId)) return [];
        const { invert: inverted, range } = this.model.view.body.value;
        const { field, map, colours, beyond } = span;
        const title = this.titleOf(field, this.model.state.dataset.value);
        return [
            {
                title,
                colours,
                beyond,
                map,
                ...plainScale,
                inverted,
                rangeOf: range === null ? 'body' : 'locked',
                of: ['Body'],
            },
        ];
    }

    private bar({ title, less: subtracted = '', colours, of, rangeOf, ...style }: Bar, severalBars: boolean): TemplateResult {
        const [low, high] = colours;
        const scale = scaleOf(style);
        const resolution = resolutionOf(low, high);
        const written = (numbers: readonly [number, number]): string[] =>
            style.logarithmic ? numbers.map(shortNumber) : placeNumbers(numbers, resolution);
        const [from, to] = written(colours);
        const [below, above] = style.beyond;
        // Made symmetric, the ends may hold what the range did not.
        const less = below !== null && below < low ? shortNumber(below) : null;
        const more = above !== null && above > high ? shortNumber(above) : null;
        const beyond =
            less !== null && more !== null
                ? `the last 1 % at each end: from ${less}, to ${more}`
                : more !== null
                  ? `the last 1 %: to ${more}`
                  : less !== null
                    ? `the last 1 %: from ${less}`
                    : '';
        const whose = rangeOf === null ? '' : rangeWords[rangeOf];
        const { ticks, shared } = colourTicks(low, high, scale, 5);
        const said = [
            `${title} ${subtracted === '' ? '' : `${subtracted} `}from ${from} to ${to}${scaleWords[scale]}${style.bands === 0 ? '' : `, in ${style.bands} bands`}`,
            whose,
            beyond,
        ]
            .filter((each) => each !== '')
            .join(', ');
        return html`<figure aria-label=${`Colours: ${said}`} data-table=${`${style.map} ${style.inverted}${style.bands === 0 ? '' : ` ${style.bands}`}`}>
            <figcaption>
                <span>${title}</span>
                ${subtracted === '' ? nothing : html`<span>${subtracted}</span>`}
                <span class="range">${from} to ${to}${shortScale[scale]}</span>
                ${severalBars ? html`<span class="range">${of.join(', ')}</span>` : nothing}
                ${whose === '' ? nothing : html`<span class="range whose">${whose}</span>`}
                ${beyond === '' ? nothing : html`<span class="range beyond">${beyond}</span>`}
                ${shared === '' ? nothing : html`<span class="range shared">numbers below ${shared}</span>`}
            </figcaption>
            <canvas width=${tableSize} height="1" aria-hidden="true"></canvas>
            <div class="ticks" aria-hidden="true">
                ${ticks.map(({ value, label }) => html`<span data-at=${fractionOf(value, colours, scale)}>${label}</span>`)}
            </div>
        </figure>`;
    }

    protected override updated(): void {
        // Positions through the object model: the content security policy forbids style attributes.
        for (const tick of this.renderRoot.querySelectorAll<HTMLElement>('.ticks span')) {
            tick.style.left = `${Number(tick.dataset['at']) * 100}%`;
        }
        this.renderRoot.querySelectorAll('figure').forEach((figure, i) => {
            const canvas = figure.querySelector('canvas');
            const style = this.bars[i];
            // Ranges change with every state, colours seldom.
            if (canvas === null || style === undefined || canvas.dataset['painted'] === figure.dataset['table']) return;
            canvas.dataset['painted'] = figure.dataset['table'];
            const pixels = new Uint8ClampedArray(colourTable(style.map, style.inverted, style.bands).buffer);
            canvas.getContext('2d')?.putImageData(new ImageData(pixels, tableSize, 1), 0, 0);
        });
    }
}

customElements.define('wakesurf-scalar-bar', ScalarBar);
