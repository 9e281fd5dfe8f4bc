import { expect, it, vi } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import type { RakeShape } from '../../scene/rake/rakeShape.ts';
import { newBodyRake } from '../../state/viewState.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { BodyRakes, type BodyRakesOptions } from './bodyRakes.ts';

/** Over a square of side 10, seen from above, where a pixel is a unit. */
function overSquare() {
    vi.stubGlobal('addEventListener', () => undefined);
    const page = new PageBench();
    const made: RakeShape[] = [];
    const body = {
        positions: new Float32Array([0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0]),
        indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
    };
    const scene = {
        body: { triangles: { ...body, shown: body.indices } },
        pickGrid: ({ x, y }: { x: number; y: number }) => ({
            hits: [x <= 10 ? { surface: null, point: [x, y, 0] as Vec3 } : null],
        }),
        view: () => ({ outside: [5, 5, 100] }),
        pointerTools: { add: () => undefined },
    };
    const tool = new BodyRakes({
        ...{ state: page.state, view: page.view, scene: scene as unknown as BodyRakesOptions['scene'] },
        actions: { newRake: (shape) => Promise.resolve(void made.push(shape!)) },
    });
    const click = (x: number, y: number): boolean => tool.click({ at: { x, y }, time: 0, shift: false });
    return { view: page.view, tool, made, click };
}

it('a line that is clicked on a body becomes a rake off it', async () => {
    const { view, tool, made, click } = overSquare();
    expect(click(1, 2)).toBe(false);
    view.chosenThing.value = newBodyRake;
    expect(view.tool.value).toBe('bodyRake');
    click(1, 2);
    expect(tool.canEnd).toBe(false);
    click(50, 2);
    expect(view.besidePointer.value?.words).toContain('no body');
    click(8, 2);
    click(8, 9);
    tool.typedOff.value = 0.5;
    expect(view.bodyWay.value.way[0]).toEqual([1, 2, 0.5]);
    await tool.end();
    expect(made[0]!.kind).toBe('polyline');
    expect(made[0]!.points).toHaveLength(3);
    made[0]!.points.forEach((point, i) =>
        point.forEach((each, k) => expect(each).toBeCloseTo([1, 2, 0.5, 8, 2, 0.5, 8, 9, 0.5][3 * i + k]!, 6)),
    );
    expect([view.tool.value, view.chosenThing.value, view.bodyWay.value.clicked.length]).toEqual(['none', null, 0]);
});

it('what was clicked is forgotten with the tool', () => {
    const { view, click, made } = overSquare();
    view.chosenThing.value = newBodyRake;
    click(1, 2);
    view.tool.value = 'none'; // as Esc does
    expect([view.chosenThing.value, view.bodyWay.value.clicked.length, view.besidePointer.value]).toEqual([null, 0, null]);
    expect(made).toEqual([]);
});
