// What is in the picture, as rows of one list: rakes with their surfaces, isosurfaces, slices, streamlines, the body.
import type { ReadonlySignal } from '@preact/signals-core';
import type { RakeRecord, SurfaceRecord } from '../../protocol/messages.ts';
import type { Edits } from '../../session/edits/edits.ts';
import { surfacesOf } from '../../session/edits/selection.ts';
import { holderOf, rakeColour } from '../../session/picture/rakesInPicture.ts';
import { planeWords } from '../../session/picture/planeWords.ts';
import type { Lines } from '../../session/picture/linesInPicture.ts';
import type { Slices } from '../../session/picture/slicesInPicture.ts';
import { isosurfaceWords, ownerColour } from '../../session/picture/surfaceOwner.ts';
import { attributeOf, qCriterion } from '../../session/picture/surfaceStyleOf.ts';
import { isolated } from '../../state/announcements.ts';
import type { AppState } from '../../state/appState.ts';
import { bodyId, opacityOf, shows } from '../../state/pageView.ts';
import { seedsWords } from '../lines/linesPlaces.ts';
import { hasBoundary } from '../../state/bodyPatches.ts';
import type { ViewState } from '../../state/viewState.ts';

export interface PictureListModel {
    state: AppState;
    view: ViewState;
    edits: Edits;
    /** Null: not loaded yet. */
    slices: ReadonlySignal<{ slices: Pick<Slices, 'places' | 'remove'> } | null>;
    lines: ReadonlySignal<{ lines: Pick<Lines, 'places' | 'remove'> } | null>;
}

export interface PicturedThing {
    /** Of the record, or bodyId. */
    id: string;
    kind: 'rake' | 'isosurface' | 'slice' | 'lines' | 'body';
    name: string;
    /** What it is, and what it is coloured by, in short words. */
    about: string;
    /** Names of the data that it is of, where the picture has several. */
    data?: string;
    /** The whole of it. */
    title: string;
    /** Null: it has none of its own. */
    colour: string | null;
    shown: boolean;
    chosen: boolean;
    choose: () => void;
    /** Null: there is nothing that could be seen through. */
    opacity: { value: number; change: (opacity: number) => void } | null;
    /** Null: it is not the user's to delete. */
    remove: (() => void) | null;
}

/** In the order of the list. */
const kinds: readonly ((model: PictureListModel) => PicturedThing[])[] = [rakes, isosurfaces, slices, lines, body];

/** Where there are several datasets, with which one each is of. */
export function picturedThings(model: PictureListModel): PicturedThing[] {
    const { state } = model;
    const things = kinds.flatMap((kind) => kind(model));
    if (state.pictured.value.length < 2) return things;
    return things.map((thing) => {
        const data = datasetsOf(state, thing).map((id) => isolated(state.described(id)?.name ?? id));
        return data.length === 0 ? thing : { ...thing, title: `${thing.title} of ${data.join(', ')}`, data: data.join(', ') };
    });
}

function datasetsOf({ lines, slices, surfaces }: AppState, { id, kind }: PicturedThing): string[] {
    if (kind === 'rake') {
        const own = [...surfaces.value.values()].filter(({ rake }) => rake === id);
        return [...new Set(own.map(({ dataset }) => dataset))];
    }
    const record = surfaces.value.get(id) ?? slices.value.get(id) ?? lines.value.get(id);
    return record === undefined ? [] : [record.dataset];
}

export function rakeName({ name, rake }: RakeRecord): string {
    return name === '' ? `Rake ${rake}` : name;
}

const shapeWords = { line: 'line', polyline: 'polyline', circle: 'circle', points: 'points' } as const;

function rakes(model: PictureListModel): PicturedThing[] {
    const { state, view, edits } = model;
    const { lockedRakes } = view.visibility.value;
    const you = state.participants.value.get(state.you.value ?? '')?.name;
    return [...state.rakes.value.values()].map((record) => {
        const id = record.rake;
        const own = surfacesOf(state, id).map((each) => state.surfaces.value.get(each)!);
        const holder = holderOf(state, record);
        const { author = '' } = record;
        const made = author === '' ? '' : `, ${author === you ? 'yours' : `by ${isolated(author)}`}`;
        const moved = holder === null ? '' : `${isolated(holder.name)} is moving it`;
        return {
            ...{ id, kind: 'rake', name: rakeName(record), colour: rakeColour(record, state.rakes.value) },
            about: moved === '' ? surfaceWords(model, own) : moved,
            title: moved === '' ? `${shapeWords[record.kind]}${made}` : moved,
            shown: shows(view.visibility.value, id, state.activeRake.value),
            chosen: view.chosenThing.value === null && id === state.activeRake.value,
            choose: () => {
                view.chosenThing.value = null;
                edits.chooseRake(id);
            },
            opacity: own.length === 0 ? null : surfaceOpacity(view, own),
            remove: lockedRakes.has(id) ? null : () => void edits.actions.deleteRake(id),
        };
    });
}

function isosurfaces(model: PictureListModel): PicturedThing[] {
    const { state, view, edits } = model;
    const levels = [...state.surfaces.value.values()].filter(({ rake }) => rake === undefined);
    return levels.map((record) => {
        const id = record.surface;
        const name = isosurfaceWords(record, state.described(record.dataset));
        const { colour } = view.lookOf(id);
        return {
            ...{ id, kind: 'isosurface', name, about: colourWords(view, id), title: 'isosurface' },
            colour: colour ?? ownerColour(record, undefined),
            shown: shows(view.visibility.value, id, state.activeRake.value),
            chosen: view.chosenThing.value === null && id === state.activeSurface.value,
            choose: () => {
                view.chosenThing.value = null;
                edits.chooseSurface(id);
            },
            opacity: surfaceOpacity(view, [record]),
            remove: () => void edits.actions.deleteSurface(id),
        };
    });
}

function slices({ view, slices: loaded }: PictureListModel): PicturedThing[] {
    const held = loaded.value?.slices;
    return [...(held?.places.value ?? [])].map(([id, { field, origin, normal, minus }]) => ({
        ...{
            id,
            kind: 'slice',
            name: planeWords(origin, normal),
            about: minus === null ? isolated(field) : `${isolated(field)}, difference`,
            title: 'slice',
            colour: null,
        },
        ...lookedAt(view, id),
        remove: () => void held?.remove(id),
    }));
}

function lines({ view, lines: loaded }: PictureListModel): PicturedThing[] {
    const held = loaded.value?.lines;
    return [...(held?.places.value ?? [])].map(([id, { field, ...seeds }]) => ({
        ...{ id, kind: 'lines', name: seedsWords(seeds), about: isolated(field), title: 'streamlines', colour: null },
        ...lookedAt(view, id),
        remove: () => void held?.remove(id),
    }));
}

function body({ state, view }: PictureListModel): PicturedThing[] {
    const several = state.pictured.value.filter((each) => hasBoundary(each));
    if (several.length === 0) return [];
    const { colourBy } = view.body.value;
    const about = colourBy === 'constant' ? 'grey' : byWords(colourBy);
    return [
        {
            id: bodyId,
            kind: 'body',
            name: several.length > 1 ? 'Bodies' : several[0]!.obstacle ? 'Body' : 'Sides',
            about,
            title: 'of the data',
            colour: null,
            ...lookedAt(view, bodyId),
            remove: null,
        },
    ];
}

/** What is of this page alone, of things that are no surfaces. */
function lookedAt(view: ViewState, id: string): Pick<PicturedThing, 'shown' | 'chosen' | 'choose' | 'opacity'> {
    const { opacities } = view.visibility.value;
    return {
        shown: shows(view.visibility.value, id),
        chosen: view.chosenThing.value === id,
        choose: () => (view.chosenThing.value = id),
        opacity: {
            value: opacityOf(view.visibility.value, id),
            change: (part) => {
                const changed = new Map(opacities);
                if (part < 1) changed.set(id, part);
                else changed.delete(id);
                view.changeVisibility({ opacities: changed });
            },
        },
    };
}

/** All surfaces of a rake get the same. */
function surfaceOpacity(view: ViewState, surfaces: readonly SurfaceRecord[]): PicturedThing['opacity'] {
    return {
        value: view.lookOf(surfaces[0]!.surface).opacity,
        change: (opacity) => {
            for (const { surface } of surfaces) view.changeLook(surface, { opacity });
        },
    };
}

function surfaceWords({ view }: PictureListModel, surfaces: readonly SurfaceRecord[]): string {
    const [first] = surfaces;
    if (first === undefined) return 'no surface';
    return surfaces.length > 1 ? `${surfaces.length} surfaces` : `${first.kind}, ${colourWords(view, first.surface)}`;
}

function colourWords(view: ViewState, surface: string): string {
    const { colourBy } = view.lookOf(surface);
    return colourBy === 'constant' ? 'plain' : byWords(colourBy);
}

function byWords(colourBy: string): string {
    const attribute = attributeOf(colourBy);
    if (attribute === null) return colourBy === 's' ? 'position' : colourBy;
    return attribute === qCriterion ? 'Q' : isolated(attribute.replaceAll('_', ' '));
}
