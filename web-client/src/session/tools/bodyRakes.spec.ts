import { expect, it } from 'vitest';
import type { Vec3 } from '../../protocol/messages.ts';
import type { RakeShape } from '../../scene/rake/rakeShape.ts';
import { newBodyRake } from '../../state/viewState.ts';
import { settled } from '../../testing/fakes.ts';
import { PageBench } from '../../testing/pageBench.ts';
import { BodyRakes, type BodyRakesOptions } from './bodyRakes.ts';

/** Over a square of side 10, seen from above, where a pixel is a unit; from 90 on there is a body of another dataset. */
function overSquare() {
    const page = new PageBench();
    const made: RakeShape[] = [];
    const server = { makes: true };
    const patches = [{ name: 'square', kind: 'wall' as const, triangles: 1 }];
    page.state.dataset.value = { ...page.state.dataset.value!, patches };
    const body = {
        positions: new Float32Array([0, 0, 0, 10, 0, 0, 10, 10, 0, 0, 10, 0]),
        indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
    };
    const scene = {
        body: { triangles: { ...body, shown: body.indices } },
        pickGrid: ({ x, y }: { x: number; y: number }, radius: number) => {
            const [corner, size] = [{ x: x - radius, y: y - radius }, 2 * radius + 1];
            const places = Array.from({ length: size ** 2 }, (_, i): Vec3 => [
                corner.x + (i % size),
                corner.y + Math.floor(i / size),
                0,
            ]);
            const isSeen = ([at]: Vec3): boolean => at <= 10 || at >= 90;
            return { corner, size, hits: places.map((point) => (isSeen(point) ? { surface: null, point } : null)) };
        },
        view: () => ({ outside: [5, 5, 100], worldPerPx: () => 0.1 }),
        pointerTools: { add: () => undefined },
    };
    const tool = new BodyRakes({
        ...{ state: page.state, view: page.view, scene: scene as unknown as BodyRakesOptions['scene'] },
        actions: { newRake: (shape) => Promise.resolve(server.makes && made.push(shape!) > 0) },
    });
    const click = (x: number, y: number): boolean => tool.click({ at: { x, y }, time: 0, shift: false });
    return { state: page.state, view: page.view, tool, made, server, click, patch: patches[0]! };
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

it('a line that could not be made into a rake is still there', async () => {
    const { view, tool, made, server, click } = overSquare();
    view.chosenThing.value = newBodyRake;
    click(1, 2);
    click(8, 2);
    server.makes = false;
    const ended = tool.end();
    expect(tool.canEnd).toBe(false);
    await ended;
    expect([view.chosenThing.value, view.bodyWay.value.clicked.length, tool.canEnd]).toEqual([newBodyRake, 2, true]);
    server.makes = true;
    await Promise.all([tool.end(), tool.end()]);
    expect([made.length, view.chosenThing.value]).toEqual([1, null]);
});

it('the outline of a patch becomes a rake, but not while nothing can be changed', async () => {
    const { state, view, tool, made, patch } = overSquare();
    view.chosenThing.value = newBodyRake;
    state.stage.value = 'starting';
    expect([tool.canMake.value, tool.outline(patch), view.chosenThing.value]).toEqual([false, null, newBodyRake]);
    expect(made).toEqual([]);
    state.stage.value = 'running';
    expect(tool.outline(patch)).toBeNull();
    await settled();
    expect([made[0]?.points.length, view.chosenThing.value]).toEqual([5, null]);
    expect(tool.outline({ ...patch })).toContain('Show the patch');
});

it('who may only look on draws no line', () => {
    const { state, view, click } = overSquare();
    view.chosenThing.value = newBodyRake;
    click(1, 2);
    state.role.value = 'viewer';
    expect([view.chosenThing.value, view.bodyWay.value.clicked.length]).toEqual([null, 0]);
});

it('what was drawn and typed goes with its dataset, not with a time that is added to it', () => {
    const { state, view, tool, click } = overSquare();
    view.chosenThing.value = newBodyRake;
    click(1, 2);
    tool.typedOff.value = 0.5;
    state.dataset.value = { ...state.dataset.value!, times: [0, 1] };
    expect([view.bodyWay.value.clicked.length, tool.off.value]).toEqual([1, 0.5]);
    state.dataset.value = { ...state.dataset.value, dataset: 'other' };
    expect([view.chosenThing.value, view.bodyWay.value.clicked.length, tool.typedOff.value]).toEqual([null, 0, null]);
});

it('a line does not begin on a body of another dataset', () => {
    const { view, click } = overSquare();
    view.chosenThing.value = newBodyRake;
    click(95, 2);
    expect(view.besidePointer.value?.words).toBe('There is no body of this dataset here.');
    expect(view.bodyWay.value.clicked).toEqual([]);
});

it('a click near a sharp edge, or a little beside it, follows it; elsewhere words say that there is none', async () => {
    const { view, tool, made, click } = overSquare();
    view.chosenThing.value = newBodyRake;
    tool.alongEdge.value = true;
    click(5, 5);
    expect([view.besidePointer.value?.words, tool.canEnd]).toEqual(['There is no sharp edge here. Click closer to one.', false]);
    click(9, 5);
    expect([view.bodyWay.value.way.length, tool.canEnd]).toEqual([2, true]);
    click(5, 5);
    expect([view.bodyWay.value.way.length, tool.canEnd]).toEqual([0, false]);
    click(15, 5);
    tool.typedOff.value = 0.5;
    await tool.end();
    expect(made.map(({ points }) => points)).toEqual([
        [
            [10, 0, 0.5],
            [10, 10, 0.5],
        ],
    ]);
});

it('an edge is no part of a line: what was clicked goes with the choice between them', () => {
    const { view, tool, click } = overSquare();
    view.chosenThing.value = newBodyRake;
    click(1, 2);
    tool.alongEdge.value = true;
    expect(view.bodyWay.value.clicked).toEqual([]);
});
