// The server's records as this page holds them: a snapshot replaces all of them, a patch some. Nothing else
// writes them.
import type { Patch, SessionSnapshot, SurfaceEpoch } from '../protocol/messages.ts';
import { type AppState, noUnits } from '../state/appState.ts';

/** What has become of surfaces. */
export interface SurfaceChanges {
    added: string[];
    removed: string[];
    /** Holds, for those that were set, new or not, the epoch that was asked for. */
    requested: SurfaceEpoch[];
}

export function adoptSnapshot(state: AppState, snapshot: SessionSnapshot): void {
    const { name, units, rakes, surfaces, slices, lines, bookmarks, annotations, clock } = snapshot;
    state.sessionName.value = name;
    state.typedUnits.value = units ?? noUnits;
    state.rakes.value = new Map(rakes.map((record) => [record.rake, record]));
    state.surfaces.value = new Map(surfaces.map((record) => [record.surface, record]));
    state.slices.value = new Map(slices.map((record) => [record.slice, record]));
    state.lines.value = new Map(lines.map((record) => [record.lines, record]));
    state.bookmarks.value = new Map(bookmarks.map((record) => [record.bookmark, record]));
    state.annotations.value = new Map(annotations.map((record) => [record.annotation, record]));
    state.requestedEpochs.value = new Map(surfaces.map((s) => [s.surface, s.epoch]));
    state.surfaceErrors.value = new Map();
    state.clock.value = clock;
}

export function applyPatches(state: AppState, patches: readonly Patch[]): SurfaceChanges {
    const changes: SurfaceChanges = { added: [], removed: [], requested: [] };
    const records = {
        rake: new Map(state.rakes.value),
        surface: new Map(state.surfaces.value),
        slice: new Map(state.slices.value),
        lines: new Map(state.lines.value),
        bookmark: new Map(state.bookmarks.value),
        annotation: new Map(state.annotations.value),
    };
    for (const patch of patches) {
        if (patch.op === 'delete') {
            records[patch.type].delete(patch.id);
            if (patch.type === 'surface') changes.removed.push(patch.id);
        } else if (patch.type === 'clock') state.clock.value = patch.record;
        else if (patch.type === 'session') {
            state.sessionName.value = patch.record.name;
            state.typedUnits.value = patch.record.units ?? noUnits;
        } else if (patch.type === 'surface') {
            if (!records.surface.has(patch.id)) changes.added.push(patch.id);
            records.surface.set(patch.id, patch.record);
            changes.requested.push({ surface: patch.id, epoch: patch.record.epoch });
        } else if (patch.type === 'rake') records.rake.set(patch.id, patch.record);
        else if (patch.type === 'slice') records.slice.set(patch.id, patch.record);
        else if (patch.type === 'lines') records.lines.set(patch.id, patch.record);
        else if (patch.type === 'bookmark') records.bookmark.set(patch.id, patch.record);
        else records.annotation.set(patch.id, patch.record);
    }
    const touched = new Set(patches.map(({ type }) => type));
    if (touched.has('rake')) state.rakes.value = records.rake;
    if (touched.has('surface')) state.surfaces.value = records.surface;
    if (touched.has('slice')) state.slices.value = records.slice;
    if (touched.has('lines')) state.lines.value = records.lines;
    if (touched.has('bookmark')) state.bookmarks.value = records.bookmark;
    if (touched.has('annotation')) state.annotations.value = records.annotation;
    return changes;
}
