import { signal } from '@preact/signals-core';
import { beforeEach, describe, expect, it } from 'vitest';
import { AppState, type DisplayedSurface } from '../../state/appState.ts';
import { type SurfaceLook, usualLook } from '../../state/surfaceLook.ts';
import { displayedOf, surfaceOf } from '../../testing/records.ts';
import { unfinished } from './scriptedPicture.ts';

describe('a picture for a program', () => {
    let state: AppState;
    let look: SurfaceLook;
    const waiting = signal(false);
    const status = signal<'off' | 'waiting' | 'shown'>('off');

    beforeEach(() => {
        state = new AppState();
        state.stage.value = 'running';
        state.surfaces.value = new Map([['s1', surfaceOf('s1', { kind: 'streak', from: 0, to: 4, fields: ['deformation'] })]]);
        look = { ...usualLook, smoke: 1 };
        drawn({});
    });

    const drawn = (change: Partial<DisplayedSurface>): void => {
        state.displayed.value = new Map([['s1', displayedOf('s1', { time: 4, ...change })]]);
    };
    const why = (time: number | null = null): string => unfinished(state, { lookOf: () => look }, { status }, { waiting }, time);

    it('is whole when the newest surface is drawn at its finest, at the time that is asked for', () => {
        expect(why()).toBe('');
        expect(why(4)).toBe('');
        expect(why(2)).toBe('s1 is shown at 4');
        drawn({ phase: 'coarse' });
        expect(why()).toBe('s1 is coarse');
        drawn({});
        state.requestedEpochs.value = new Map([['s1', 2]]);
        expect(why()).toBe('s1 is not there');
    });

    it('is not whole while the values along the body are on their way', () => {
        status.value = 'waiting';
        expect(why()).toBe('the values along the body are not there');
        status.value = 'shown';
        expect(why()).toBe('');
    });

    it('is not whole while a slice or lines are on their way', () => {
        waiting.value = true;
        expect(why()).toBe('a slice or a set of lines is not there');
        waiting.value = false;
        expect(why()).toBe('');
    });

    it('is not whole without an attribute that its look needs and that has come', () => {
        drawn({ withheld: ['s', 'deformation'] });
        expect(why()).toBe('s1 has no deformation yet');
        look = { ...look, smoke: 0 };
        expect(why()).toBe('');
        look = { ...look, smoke: 1, colourBy: 'speed' };
        drawn({ withheld: ['speed'] });
        expect(why()).toBe('s1 has no speed yet');
    });

    it('is not whole while cells are flat that its look curves', () => {
        look = { ...usualLook, curved: true };
        expect(why()).toBe('the cells of s1 are not curved yet');
        drawn({ curved: true });
        expect(why()).toBe('');
    });

    it('waits for no surface that is hidden, and for none that failed', () => {
        drawn({ phase: 'coarse' });
        state.hiddenSurfaces.value = new Set(['s1']);
        expect(why()).toBe('');
        state.hiddenSurfaces.value = new Set();
        state.surfaceErrors.value = new Map([['s1', { epoch: 1, text: 'no data', stopped: false }]]);
        expect(why()).toBe('!s1: no data');
    });
});
