// Shows in the picture what was probed, measured and noted.
import { effect, untracked } from '@preact/signals-core';
import type { FlowScene } from '../../scene/scene.ts';
import type { DatasetDescription, FieldDescription } from '../../protocol/messages.ts';
import { shortNumber, valueNumber } from '../../scene/base/numbers.ts';
import { type MarkedLine, type Marker, MarkerLayer } from '../../scene/tools/markers.ts';
import type { AppState } from '../../state/appState.ts';
import type { ProbeReading, ViewState } from '../../state/viewState.ts';
import { distance } from '../tools/pointTools.ts';
import { withUnit } from './writtenNumbers.ts';

const probeColour = '#f0e442';
const measureColour = '#56b4e9';
const noteColour = '#cc79a7';
const wordsOfNote = 40;
const gapPx = 14;

/** In every tab of the panel, and read aloud. What was said with one tool is nothing to another. */
function showBesidePointer(view: ViewState, labels: HTMLElement): void {
    const label = document.createElement('div');
    label.className = 'beside-pointer';
    label.setAttribute('role', 'status');
    labels.append(label);
    effect(() => {
        void view.tool.value;
        untracked(() => (view.besidePointer.value = null));
    });
    effect(() => {
        const said = view.besidePointer.value;
        label.textContent = said?.words ?? '';
        if (said === null) return;
        // To the side, and above or below, where there is more room.
        const { clientWidth: width, clientHeight: height } = labels;
        const across = said.at.x > width / 2 ? `calc(${said.at.x - gapPx}px - 100%)` : `${said.at.x + gapPx}px`;
        const down = said.at.y > height / 2 ? `calc(${said.at.y - gapPx}px - 100%)` : `${said.at.y + gapPx}px`;
        label.style.transform = `translate(${across}, ${down})`;
    });
}

export function showMarks(state: AppState, view: ViewState, scene: FlowScene): void {
    const layer = new MarkerLayer(scene.labels);
    scene.add(layer);
    showBesidePointer(view, scene.labels);
    effect(() => {
        const markers: Marker[] = [];
        const probe = view.tool.value === 'probe' ? view.probe.value : null;
        if (probe !== null) {
            markers.push({ at: probe.point, colour: probeColour, words: probeWords(probe, state.dataset.value) });
        }
        // With the probe in hand its own marker is there.
        const plotted = view.plot.value === 'point' && probe === null ? view.probeHeld.value : view.plotPlace.value;
        if (plotted !== null) markers.push({ at: plotted, colour: probeColour, words: '' });
        const [a, b] = view.measured.value;
        const { clicked, way } = view.bodyWay.value;
        for (const at of [...view.measured.value, ...view.slicePoints.value, ...clicked]) {
            markers.push({ at, colour: measureColour, words: '' });
        }
        for (const { position: at, text, author } of state.annotations.value.values()) {
            markers.push({ at, colour: noteColour, words: `${shortened(text)} – ${author}` });
        }
        const lines = way.slice(1).map((to, i): MarkedLine => ({ from: way[i]!, to, colour: measureColour, words: '' }));
        if (a !== undefined && b !== undefined) {
            lines.push({
                from: a,
                to: b,
                colour: measureColour,
                words: withUnit(shortNumber(distance(a, b)), view.units.value.length),
            });
        }
        layer.set(markers, lines);
        scene.loop.request();
    });
}

function probeWords({ inside, values }: ProbeReading, dataset: DatasetDescription | null): string {
    if (!inside) return 'no flow here';
    const words = values.map(({ name, value }) => {
        const { range, unit = '' } = dataset?.fields.find((field) => field.name === name) ?? noField;
        const said = withUnit(valueWords(value, range), value === null ? '' : unit);
        if (value === null || typeof value === 'number') return `${name} ${said}`;
        const parts = `(${value.map((each) => shortNumber(each)).join(', ')})`;
        return name === dataset?.velocity ? `speed ${said}, ${name} ${parts}` : `${name} ${said} ${parts}`;
    });
    return words.join(', ');
}

const noField: Partial<Pick<FieldDescription, 'range' | 'unit'>> = {};

/** Writes a value, and of a vector its length. */
function valueWords(value: ProbeReading['values'][number]['value'], range?: FieldDescription['range']): string {
    if (value === null) return '–';
    return valueNumber(typeof value === 'number' ? value : Math.hypot(...value), range);
}

function shortened(text: string): string {
    const [line = ''] = text.split('\n');
    return line.length > wordsOfNote || line.length < text.length ? `${line.slice(0, wordsOfNote)} …` : line;
}
