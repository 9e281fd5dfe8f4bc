import { describe, expect, it } from 'vitest';
import type { MethodName } from '../../protocol/messages.ts';
import { AppState } from '../../state/appState.ts';
import { ViewState } from '../../state/viewState.ts';
import { datasetOf } from '../../testing/records.ts';
import { adoptSnapshot, applyPatches } from '../recordMirror.ts';
import { showUnits, typeUnits, withUnit } from './writtenNumbers.ts';

function bench() {
    const state = new AppState();
    const view = new ViewState();
    const atAxes: string[] = [];
    state.session.value = 'main';
    showUnits(state, view, { setUnit: (unit) => void atAxes.push(unit) });
    const told = (units?: { length: string; time: string }): void => {
        const record = { session: 'main', name: 'main', ...(units === undefined ? {} : { units }) };
        applyPatches(state, [{ op: 'put', type: 'session', id: 'main', record }]);
    };
    return { state, view, atAxes, told };
}

describe('units', () => {
    it('are those of the data, until someone in the session types others', () => {
        const { state, view, atAxes, told } = bench();
        expect(view.units.value).toEqual({ length: '', time: '' });
        state.dataset.value = datasetOf({ lengthUnit: 'm', timeUnit: 's' });
        expect(view.units.value).toEqual({ length: 'm', time: 's' });
        told({ length: 'D', time: '' });
        expect(view.units.value).toEqual({ length: 'D', time: 's' });
        told();
        expect(view.units.value).toEqual({ length: 'm', time: 's' });
        expect(atAxes).toEqual(['', 'm', 'D', 'm']);
    });

    it('come with the session to whoever joins', () => {
        const { state, view } = bench();
        const clock = { time: null, from: null, to: null, playing: false, speed: 1, loop: false };
        const none = { rakes: [], surfaces: [], slices: [], lines: [], bookmarks: [], annotations: [], clock };
        adoptSnapshot(state, { session: 'main', name: 'main', units: { length: 'mm', time: 'ms' }, ...none });
        expect(view.units.value).toEqual({ length: 'mm', time: 'ms' });
        adoptSnapshot(state, { session: 'other', name: 'other', ...none });
        expect(view.units.value).toEqual({ length: '', time: '' });
    });

    it('that are typed are shown at once, told to the session, and go back where they are refused', async () => {
        const { state, view } = bench();
        const asked: unknown[] = [];
        let answer: object | null = { session: 'main', name: 'main' };
        const calls = {
            try: ((method: MethodName, params: object) => {
                asked.push([method, params]);
                return Promise.resolve(answer);
            }) as never,
        };
        const typing = typeUnits(state, calls, { length: 'mm' });
        expect(view.units.value.length).toBe('mm');
        await typing;
        expect(asked).toEqual([['session.setUnits', { session: 'main', length: 'mm', time: '' }]]);
        answer = null;
        await typeUnits(state, calls, { time: 'h' });
        expect(view.units.value).toEqual({ length: 'mm', time: '' });
    });

    it('stand behind their number', () => {
        expect(withUnit('7.3', 'mm')).toBe('7.3 mm');
        expect(withUnit('7.3', '')).toBe('7.3');
    });
});
