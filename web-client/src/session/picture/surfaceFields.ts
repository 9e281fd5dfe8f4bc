// What is sent with a surface for a look, to every user. There is room for few fields, and other people's looks use them too: what a look
// can do without takes no user's place, and what has to go is said, as is what looks need and their surfaces do not carry, after a link or
// a bookmark.
import { effect } from '@preact/signals-core';
import { normalNames } from '../../mesh/meshChange.ts';
import { limits } from '../../protocol/generated/limits.ts';
import type { SurfaceRecord } from '../../protocol/messages.ts';
import { flowNames } from '../../scene/surface/surfaceMesh.ts';
import type { AppState } from '../../state/appState.ts';
import type { SurfaceLook } from '../../state/surfaceLook.ts';
import type { ViewState } from '../../state/viewState.ts';
import type { Edits } from '../edits/edits.ts';
import type { TurnAlong } from '../edits/undoHistory.ts';
import type { OwnCopy } from '../sessions/ownCopy.ts';
import { attributeOf, attributesOf, deformation, intervalError, needsFlow } from './surfaceStyleOf.ts';

export interface FieldsWanted {
    fields: string[];
    /** Those of before that have no room any more. */
    gone: string[];
    /** Those that the look would have used, and does without. */
    missing: string[];
}

/** What goes first where there is no room: of one of these, nothing is left without the others. */
const dispensable: readonly (readonly string[])[] = [[intervalError], normalNames, [deformation], flowNames];

/** Returns what a look cannot be drawn without. */
function neededFields(look: SurfaceLook): string[] {
    const colour = attributeOf(look.colourBy);
    return [...new Set([...(colour === null || colour === 'speed' ? [] : [colour]), ...(needsFlow(look) ? flowNames : [])])];
}

/** A surface's fields with those that a look needs.
 *  @param hatch it is to be hatched from now on */
export function fieldsWith(fields: readonly string[], look: SurfaceLook, hatch = false): FieldsWanted {
    const wanted = neededFields(look);
    let others = fields.filter((name) => !wanted.includes(name));
    const tooMany = (): boolean => others.length + wanted.length > limits.fields;
    for (const group of dispensable) if (tooMany()) others = others.filter((name) => !group.includes(name));
    while (tooMany()) others.shift();
    const all = [...others, ...wanted];
    const gone = fields.filter((name) => !all.includes(name));
    const missing: string[] = [];
    for (const group of [look.smoke > 0 ? [deformation] : [], look.curved ? normalNames : [], hatch ? [intervalError] : []]) {
        const more = group.filter((name) => !all.includes(name));
        if (all.length + more.length <= limits.fields) all.push(...more);
        else missing.push(...more.filter((name) => !fields.includes(name)));
    }
    return { fields: all, gone, missing };
}

export interface FieldsOptions {
    edits: Pick<Edits, 'changeSurface'>;
    state: Pick<AppState, 'notices' | 'role'>;
    view: Pick<ViewState, 'changeLook' | 'lookOf'>;
}

/** Changes the look of a surface, asks for what that needs and is not there, and says what there is no room
 *  for. It is asked for everybody: who may only look has what is there. */
export function changeLookWithFields(
    { edits, state, view }: FieldsOptions,
    record: SurfaceRecord,
    change: Partial<SurfaceLook>,
): void {
    const { surface } = record;
    const before = view.lookOf(surface);
    const look = { ...before, ...change };
    view.changeLook(surface, change);
    const { fields: carried } = record;
    const isNew = (name: string): boolean =>
        !attributesOf(before, carried).includes(name) && !['speed', ...carried].includes(name);
    const hatch = change.hatched === true && !carried.includes(intervalError);
    if (state.role.value === 'viewer' || !(hatch || attributesOf(look, carried).some(isNew))) return;
    const { fields, gone, missing } = fieldsWith(carried, look, hatch);
    const added = fields.some((name) => !record.fields.includes(name));
    // What has nothing to make room for stays.
    if (added) edits.changeSurface({ fields }, undefined, null, turnedAlong(view, surface, before, change));
    const room = `A surface carries ${limits.fields} fields for everybody`;
    const words = [
        ...(added && gone.length > 0
            ? [`${gone.join(', ')} ${gone.length > 1 ? 'are' : 'is'} no longer sent with this one.`]
            : []),
        ...(missing.length > 0 ? [`${missing.join(', ')} ${missing.length > 1 ? 'have' : 'has'} no room.`] : []),
    ];
    if (words.length === 0) state.notices.solved(about);
    else state.notices.sayUntil('press', about, `${room}: ${words.join(' ')}`);
}

const about = 'fields';

/** Takes back a change of a look, where it has not been changed to another since, and makes it again. */
function turnedAlong(view: FieldsOptions['view'], surface: string, before: SurfaceLook, change: Partial<SurfaceLook>): TurnAlong {
    const needed = neededFields(before);
    const more = neededFields({ ...before, ...change }).filter((name) => !needed.includes(name));
    const keys = Object.keys(change) as (keyof SurfaceLook)[];
    const old = Object.fromEntries(keys.map((key) => [key, before[key]]));
    return {
        undo: () => {
            const now = neededFields(view.lookOf(surface));
            if (more.every((name) => now.includes(name))) view.changeLook(surface, old);
        },
        redo: () => view.changeLook(surface, change),
    };
}

export interface MissingFieldsOptions {
    state: Pick<AppState, 'stage' | 'role' | 'surfaces' | 'hiddenSurfaces' | 'editsPending' | 'notices'>;
    view: Pick<ViewState, 'lookOf'>;
    ownCopy: Pick<OwnCopy, 'begin'>;
}

const missingNotice = 'lacked fields';

export function announceMissingFields({ state, view, ownCopy }: MissingFieldsOptions): void {
    effect(() => {
        // Those that are being asked for are on their way.
        if (state.stage.value !== 'running' || state.editsPending.value) return;
        const missing = [...state.surfaces.value.values()].flatMap(({ surface, fields }) => {
            const names = neededFields(view.lookOf(surface)).filter((name) => !fields.includes(name));
            return names.length === 0 || state.hiddenSurfaces.value.has(surface) ? [] : [`${names.join(', ')} with ${surface}`];
        });
        if (missing.length === 0) {
            state.notices.solved(missingNotice);
            return;
        }
        const looksOn = state.role.value === 'viewer';
        state.notices.say(
            missingNotice,
            `This view needs what the server does not send: ${missing.join('; ')}. It is drawn without. ` +
                (looksOn ? 'Someone who can edit, or you in a copy, can choose it under Look.' : 'Choose it again under Look.'),
            looksOn ? { label: 'Continue in a copy', act: () => void ownCopy.begin() } : null,
        );
    });
}
