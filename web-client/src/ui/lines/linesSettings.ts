// The settings of one set of streamlines: where its seeds lie and how many, how far and which way the lines go, and their colours.
import { html, nothing, type TemplateResult } from 'lit';
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf } from '../../scene/base/numbers.ts';
import { levelFields } from '../../session/edits/defaults.ts';
import type { LinesPlace } from '../../session/picture/linesInPicture.ts';
import type { FieldMeaning } from '../../session/picture/fieldColours.ts';
import { checkRow, numberRow, pairRow, selectRow, sliderRow, vectorFields } from '../base/rows.ts';
import { fieldWords } from '../../session/picture/surfaceOwner.ts';
import { type Bounds, diagonalOf } from './linesPlaces.ts';

export interface LinesSettings {
    place: LinesPlace;
    dataset: DatasetDescription;
    meaning: FieldMeaning | undefined;
    change: (change: Partial<LinesPlace>) => void;
}

const mostSeeds = 4096;
const directions = [
    { value: 'both', words: 'Both ways' },
    { value: 'forward', words: 'Downstream' },
    { value: 'backward', words: 'Upstream' },
] as const;
/** What the points of each kind are. */
const pointNames = { line: ['Start', 'End'], plane: ['Corner', 'Beside', 'Above'], sphere: ['Centre'], walls: [] } as const;

/** Of one set; the slider of seeds goes by doublings. */
export function linesSettings({ place, dataset, meaning, change }: LinesSettings): TemplateResult {
    const { kind, points, distance, seeds, direction, length, duration, field, range } = place;
    const bounds = dataset.bounds as unknown as Bounds;
    const diagonal = diagonalOf(bounds);
    const resolution = resolutionOf(0, diagonal);
    const names = levelFields(dataset);
    const choices = (names.includes(field) ? names : [field, ...names]).map((name) => ({
        value: name,
        words: fieldWords(name, dataset),
    }));
    const positive = (value: number): boolean => value > 0 && value <= diagonal;
    return html`
        ${selectRow('streamlines-field', 'Field', choices, field, (name) => change({ field: name, range: null }))}
        ${sliderRow({
            ...{ id: 'streamlines-seeds', words: 'Seeds', value: Math.log2(seeds), shown: String(seeds) },
            ...{ low: 0, high: Math.log2(mostSeeds), step: 0.25 },
            change: (value) => change({ seeds: Math.round(2 ** value) }),
        })}
        ${selectRow('streamlines-direction', 'Direction', directions, direction, (value) => change({ direction: value }))}
        ${pointNames[kind].map(
            (name, i) =>
                html`<div class="triple" role="group" aria-label=${`Seeds: ${name}`}>
                    <span>${name}</span>
                    ${vectorFields(
                        `Seeds ${name}`,
                        points[i] ?? [0, 0, 0],
                        (_, value) => fieldNumber(value, resolution),
                        (point) => change({ points: points.map((each, k): Vec3 => (k === i ? point : each)) }),
                    )}
                </div>`,
        )}
        ${
            kind === 'sphere' || kind === 'walls'
                ? numberRow(kind === 'sphere' ? 'Radius' : 'Distance', {
                      ...{ id: 'streamlines-distance', shown: fieldNumber(distance, resolution) },
                      change: (value) => {
                          if (positive(value)) change({ distance: value });
                          return positive(value);
                      },
                  })
                : nothing
        }
        ${endRow('streamlines-length', 'Longest', `length of a line each way; 0: ${fieldNumber(2 * diagonal, resolution)}`, length, (value) => change({ length: value }))}
        ${endRow('streamlines-duration', 'Time of flight', 'each way; 0: as long as it takes', duration, (value) => change({ duration: value }))}
        ${
            meaning === undefined || meaning.range[0] === meaning.range[1]
                ? nothing
                : html`${checkRow('Own range of colours', range !== null, (on) => change({ range: on ? meaning.range : null }), { id: 'streamlines-range' })}
                  ${range === null ? nothing : pairRow('streamlines-colours', 'Colours', range, (pair) => change({ range: pair }))}`
        }
    `;
}

/** 0 is none. */
function endRow(id: string, words: string, title: string, value: number, change: (value: number) => void): TemplateResult {
    return numberRow(words, {
        ...{ id, title, shown: String(Number(value.toPrecision(6))) },
        change: (typed) => {
            if (typed >= 0) change(typed);
            return typed >= 0;
        },
    });
}
