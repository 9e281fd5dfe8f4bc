// Writes what the tabs of the panel show as the steps of a script that makes the same again.
import type { RakeRecord, Vec3 } from '../../protocol/messages.ts';
import type { AppState } from '../../state/appState.ts';
import type { ViewState } from '../../state/viewState.ts';
import { type CallStep, type MeshFile, type ScriptStep, ScriptVariable } from './scripts.ts';

/** The surface that is being worked on, with what it hangs on. */
export function surfaceSteps(state: AppState): ScriptStep[] {
    const record = state.surface.value;
    const second = state.rakes.value.get(record?.rake2 ?? '');
    const rake = state.rake.value;
    if (record === undefined || (record.rake !== undefined && rake === undefined)) return [];
    const { surface: _surface, rev: _rev, epoch: _epoch, fields, ...setting } = record;
    const params = {
        ...setting,
        ...(rake === undefined ? {} : { rake: new ScriptVariable('rake') }),
        ...(second === undefined ? {} : { rake2: new ScriptVariable('rake2') }),
        ...(fields === undefined || fields.length === 0 ? {} : { fields }),
    };
    const otherwise: CallStep[] = [
        ...(rake === undefined ? [] : [rakeStep(rake, state.rakePoints.value, 'rake')]),
        ...(second === undefined ? [] : [rakeStep(second, second.points, 'rake2')]),
        { method: 'surface.set', params, variable: 'surface' },
    ];
    return [{ there: record.surface, otherwise }];
}

/** Downloads the mesh of the surface that is being worked on. */
export function meshSteps(state: AppState, mesh: MeshFile): ScriptStep[] {
    const surface = state.activeSurface.value;
    return surface === null ? [] : [{ mesh, surface }];
}

function rakeStep({ kind, seeds, name, colour }: RakeRecord, points: readonly Vec3[], variable: string): CallStep {
    const shown = points.map((point) => [...point]);
    return { method: 'rake.set', params: { kind, points: shown, seeds, name, colour }, variable };
}

/** The saved views, and what the probe asks, where it is now. */
export function viewSteps(state: AppState, view: ViewState): ScriptStep[] {
    return [...bookmarkSteps(state), ...probeSteps(state, view)];
}

function probeSteps(state: AppState, view: ViewState): ScriptStep[] {
    const description = state.dataset.value;
    const reading = view.probe.value;
    if (description === null || reading === null) return [];
    const { point, time, values } = reading;
    const fields = values.map(({ name }) => name);
    const requested = fields.length === 0 ? {} : { fields };
    return [{ method: 'probe.sample', params: { dataset: description.dataset, points: [point], time, ...requested } }];
}

/** A link for others, who may edit, and the notes. */
export function shareSteps(state: AppState): ScriptStep[] {
    const link: CallStep = { method: 'session.share', params: { role: 'editor' } };
    return [...(state.role.value === 'host' ? [link] : []), ...noteSteps(state)];
}

function noteSteps(state: AppState): CallStep[] {
    return [...state.annotations.value.values()].map(({ text, position }) => ({
        method: 'annotation.set',
        params: { text, position },
    }));
}

function bookmarkSteps(state: AppState): CallStep[] {
    return [...state.bookmarks.value.values()].map(({ name, view, time }) => ({
        method: 'bookmark.set',
        params: { name, view, time },
    }));
}
