import { describe, expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { type SurfaceLook, usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { surfaceOf } from '../../testing/records.ts';
import { tellLackedFields } from './lackedFields.ts';

/** A page that shows one surface with these fields. */
function shown(fields: string[], look: Partial<SurfaceLook>, role: 'viewer' | 'editor' = 'viewer') {
    const state = new AppState();
    const view = new ViewState();
    const copies: string[] = [];
    const carry = (names: string[]): void => {
        state.surfaces.value = new Map([['s1', surfaceOf('s1', { fields: names })]]);
    };
    state.role.value = role;
    carry(fields);
    state.stage.value = 'running';
    view.looks.value = new Map([['s1', { ...usualLook, ...look }]]);
    tellLackedFields({ state, view, ownCopy: { begin: () => Promise.resolve(void copies.push('copy')) } });
    return { state, view, carry, copies, said: () => state.notices.all.value.get('lacked fields') ?? '' };
}

describe('what a view needs and a surface does not carry', () => {
    it('is named, with the way into a copy for who may only look on', () => {
        const page = shown(['p'], { colourBy: 'vorticity', opacity: 0.5, texture: true });
        expect(page.said()).toMatch(
            /does not send: vorticity, velocity_x, velocity_y, velocity_z with s1\. It is drawn without\./,
        );
        page.state.notices.remedyOf('lacked fields')!.act();
        expect(page.copies).toEqual(['copy']);
    });

    it('is chosen again by who may edit', () => {
        const page = shown([], { colourBy: 'field:p' }, 'editor');
        expect(page.said()).toMatch(/: p with s1\..*Choose it again under Look/);
        expect(page.state.notices.remedyOf('lacked fields')).toBeUndefined();
    });

    it('is no news when it comes, or while it is asked for, or where the look needs nothing', () => {
        expect(shown([], {}).said()).toBe('');
        expect(shown(['p'], { colourBy: 'field:p' }).said()).toBe('');
        const page = shown([], { colourBy: 'field:p' });
        expect(page.said()).not.toBe('');
        page.carry(['p']);
        expect(page.said()).toBe('');
        page.state.editsPending.value = true;
        page.carry([]);
        expect(page.said()).toBe('');
    });

    it('is not said of a hidden surface, nor of what a look can do without', () => {
        expect(shown([], { smoke: 1, curved: true }).said()).toBe('');
        const page = shown([], { colourBy: 'field:p' });
        page.state.hiddenSurfaces.value = new Set(['s1']);
        expect(page.said()).toBe('');
    });

    it('is said when somebody else takes it away', () => {
        const page = shown(['p'], { colourBy: 'field:p' });
        page.carry(['vorticity']);
        expect(page.said()).toContain('p with s1');
    });
});
