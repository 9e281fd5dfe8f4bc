// The settings of one set of streamlines: where its seeds lie and how many, how far and which way the lines go, and their colours.
import { html, nothing, type TemplateResult } from 'lit';
import type { DatasetDescription, Vec3 } from '../../protocol/messages.ts';
import { fieldNumber, resolutionOf } from '../../scene/base/numbers.ts';
import { levelFields } from '../../session/edits/defaults.ts';
import type { LinesPlace } from '../../session/picture/linesInPicture.ts';
import type { FieldMeaning } from '../../session/picture/fieldColours.ts';
import { isolated } from '../../state/announcements.ts';
import { toggled } from '../../state/pageView.ts';
import { checkRow, numberRow, pairRow, selectRow, sliderRow, vectorFields } from '../base/rows.ts';
import { fieldWords } from '../../session/picture/surfaceOwner.ts';
import { type Bounds, diagonalOf, offWalls, patchNames } from './linesPlaces.ts';

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
/** At walls they go off with the flow, or lie on them and show what it is like there. */
const wallWays = [
    { value: 'walls', words: 'Off into the flow' },
    { value: 'along', words: 'Along the walls' },
] as const;
/** What the points of each kind are. */
const pointNames = {
    line: ['Start', 'End'],
    plane: ['Corner', 'Beside', 'Above'],
    sphere: ['Centre'],
    walls: [],
    along: [],
} as const;

/** Of one set; the slider of seeds goes by doublings. */
export function linesSettings({ place, dataset, meaning, change }: LinesSettings): TemplateResult {
    const { kind, points, distance, patches, seeds, direction, length, duration, field, range } = place;
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
        ${
            kind === 'walls' || kind === 'along'
                ? html`${selectRow('streamlines-course', 'Course', wallWays, kind, (way) => change(way === 'along' ? { kind: way, distance: 0 } : { kind: way, distance: offWalls(bounds).distance }))}
                  ${patchRows(dataset, patches, (chosen) => change({ patches: chosen }))}`
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

/** Which of the boundary; none of them: all walls of bodies, where there are any. */
function patchRows(
    { obstacle, patches: known }: DatasetDescription,
    chosen: readonly string[],
    change: (patches: string[]) => void,
): TemplateResult | typeof nothing {
    const names = patchNames(known);
    if (names.length === 0) return nothing;
    const row = (name: string): TemplateResult =>
        checkRow(isolated(name), chosen.includes(name), () => {
            const next = [...toggled(new Set(chosen), name)];
            change(next.length > 0 || obstacle ? next : [name]);
        });
    return html`<div class="patches" role="group" aria-label="Patches with seeds">
        <span title=${obstacle ? 'none ticked: all walls of bodies' : nothing}>Patches</span>
        ${names.map(row)}
    </div>`;
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
