import { describe, expect, it } from 'vitest';
import { limits } from '../../protocol/generated/limits.ts';
import { AppState } from '../../state/appState.ts';
import { type SurfaceLook, usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { surfaceOf } from '../../testing/records.ts';
import { rested } from '../../testing/shownPanel.ts';
import type { SurfaceIntent } from '../edits/surfaceIntent.ts';
import { announceMissingFields, changeLookWithFields, fieldsWith } from './surfaceFields.ts';

const velocity = ['velocity_x', 'velocity_y', 'velocity_z'];
const normals = ['normal_x', 'normal_y', 'normal_z'];
const byPressure: SurfaceLook = { ...usualLook, hatched: false, colourBy: 'field:p' };

/** Returns what is asked for, and what is said, when a user with this look comes to a surface with these
 *  fields. */
function asked(fields: string[], look: Partial<SurfaceLook>) {
    const changes: string[][] = [];
    const [state, view] = [new AppState(), new ViewState()];
    const edits = { changeSurface: (change: Partial<SurfaceIntent>) => void changes.push([...change.fields!]) };
    changeLookWithFields({ edits, state, view }, surfaceOf('s1', { fields }), { hatched: false, ...look });
    return { changes, said: state.notices.all.value.get('fields') ?? '' };
}

describe('the fields of a surface', () => {
    it('have the error between stored times where the surface is to be hatched, and there is room', () => {
        expect(asked(['p'], { hatched: true }).changes).toEqual([['p', 'interval_error']]);
        expect(asked(['p', 'interval_error'], { hatched: true }).changes).toEqual([]);
        const { changes, said } = asked(['a', 'b', 'c', 'd', 'e'], { hatched: true });
        expect([changes, said]).toEqual([[], 'A surface carries 5 fields for everybody: interval_error has no room.']);
        expect(asked(['a', 'b', 'c', 'd', 'interval_error'], { colourBy: 'field:p' }).changes).toEqual([
            ['a', 'b', 'c', 'd', 'p'],
        ]);
    });

    it('have room for a flow texture, its colour and the colour of someone else', () => {
        const { changes, said } = asked(['vorticity'], { ...byPressure, texture: true });
        expect([changes, said]).toEqual([[['vorticity', 'p', ...velocity]], '']);
        expect(changes[0]).toHaveLength(limits.fields);
    });

    it('are not asked for again where they are', () => {
        expect(asked(['p'], byPressure)).toEqual({ changes: [], said: '' });
        expect(asked([...velocity, 'vorticity'], { texture: true })).toEqual({ changes: [], said: '' });
    });

    it('leave out what the look can do without, before the colours of someone else go, and say so', () => {
        const texture = { ...byPressure, texture: true };
        const smoke = asked(['vorticity'], { ...texture, smoke: 1 });
        expect(smoke.changes).toEqual([['vorticity', 'p', ...velocity]]);
        expect(smoke.said).toBe('A surface carries 5 fields for everybody: deformation has no room.');
        const curved = asked(['a', 'b', 'c'], { curved: true });
        expect(curved.changes).toEqual([]);
        expect(curved.said).toContain('normal_x, normal_y, normal_z have no room.');
        expect(fieldsWith(['a', 'b'], { ...usualLook, curved: true }).fields).toEqual(['a', 'b', ...normals]);
    });

    it('give up normals together, since curved cells need all three', () => {
        const { changes, said } = asked(['vorticity', ...normals], { ...byPressure, texture: true, curved: true });
        expect(changes).toEqual([['vorticity', 'p', ...velocity]]);
        expect(said).toBe(
            'A surface carries 5 fields for everybody: normal_x, normal_y, normal_z are no longer sent with this one.',
        );
    });

    it('give up the flow texture of someone else before colours, and the oldest colour last, in words', () => {
        expect(fieldsWith(['a', ...velocity, 'b'], byPressure)).toMatchObject({ fields: ['a', 'b', 'p'], gone: velocity });
        const { changes, said } = asked(['a', 'b', 'c', 'd', 'e'], byPressure);
        expect(changes).toEqual([['b', 'c', 'd', 'e', 'p']]);
        expect(said).toBe('A surface carries 5 fields for everybody: a is no longer sent with this one.');
    });
});

describe('undo of what a look needs', () => {
    const id = 'surface-1';
    const byVortices: Partial<SurfaceLook> = { colourBy: 'q_criterion', map: 'coolToWarm', centre: 0 };

    async function changed(change: Partial<SurfaceLook>): Promise<PageBench> {
        const bench = new PageBench();
        for (const way of ['undo', 'redo'] as const) {
            const answer = { [`${way}ne`]: [{}], undo: 0, redo: 0, skipped: [] };
            bench.answers[`history.${way}`] = () => answer;
        }
        changeLookWithFields(bench, bench.surfaces[0]!, change);
        await rested();
        return bench;
    }

    it.each([
        ['the colours', byVortices],
        ['the texture', { texture: true }],
        ['arrows', { pieces: 'arrows' as const }],
        ['curved cells', { curved: true }],
    ])('takes back %s with it, and redo brings them again', async (_, change) => {
        const bench = await changed(change);
        const { view, edits } = bench;
        expect(bench.asked('surface.set')).toHaveLength(1);
        expect(view.lookOf(id)).toEqual({ ...usualLook, ...change });
        await edits.undo();
        expect(view.lookOf(id)).toEqual(usualLook);
        await edits.redo();
        expect(view.lookOf(id)).toEqual({ ...usualLook, ...change });
    });

    it('leaves colours that were chosen since', async () => {
        const { view, edits } = await changed(byVortices);
        view.changeLook(id, { colourBy: 'age' });
        await edits.undo();
        expect(view.lookOf(id).colourBy).toBe('age');
    });

    it('asks for nothing where a user may only look on', () => {
        const bench = new PageBench();
        bench.state.role.value = 'viewer';
        changeLookWithFields(bench, bench.surfaces[0]!, { curved: true });
        expect([bench.view.lookOf(id).curved, bench.calls]).toEqual([true, []]);
    });
});

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
    announceMissingFields({ state, view, ownCopy: { begin: () => Promise.resolve(void copies.push('copy')) } });
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
