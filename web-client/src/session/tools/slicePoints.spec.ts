import { describe, expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import { dot, minus } from '../../scene/rake/rakeShape.ts';
import { ViewState } from '../../state/viewState.ts';
import { nothingThere } from './pointTools.ts';
import { SlicePoints } from './slicePoints.ts';

/** The tool in hand, over places that are under the pointer one after the other. */
function clicked(places: readonly (Vec3 | null)[]) {
    const view = new ViewState();
    view.tool.value = 'slice';
    const added: { origin: Vec3; normal: Vec3 }[] = [];
    let next = 0;
    const tool = new SlicePoints({
        view,
        pick: () => null,
        rakeAt: () => places[next++]!,
        add: (origin, normal) => added.push({ origin, normal }),
    });
    for (const _ of places) tool.click({ at: { x: 0, y: 0 }, time: 0, shift: false });
    return { view, added };
}

describe('three clicks', () => {
    it('make the slice that goes through all of them, and put the tool away', () => {
        const points: Vec3[] = [
            [1, 0, 0],
            [0, 2, 0],
            [0, 0, 3],
        ];
        const { view, added } = clicked(points);
        expect(added).toHaveLength(1);
        for (const point of points) expect(dot(minus(point, added[0]!.origin), added[0]!.normal)).toBeCloseTo(0, 12);
        expect(view.tool.value).toBe('none');
    });

    it('say what is missing after each', () => {
        expect(clicked([[1, 0, 0]]).view.besidePointer.value?.words).toBe('Click a second point.');
        expect(clicked([[1, 0, 0], null]).view.besidePointer.value?.words).toBe(nothingThere);
    });

    it('on one line make none, and the next is the third', () => {
        const line: Vec3[] = [
            [0, 0, 0],
            [1e6, 1e6, 0],
            [2e6, 2e6, 1],
        ];
        const { view, added } = clicked(line);
        expect(added).toEqual([]);
        expect(view.besidePointer.value?.words).toContain('one line');
        expect(clicked([...line, [0, 0, 5e5]]).added).toHaveLength(1);
    });
});
