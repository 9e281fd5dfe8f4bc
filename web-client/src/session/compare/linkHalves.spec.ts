// Two halves that are looked at together: what one does, the other does, until the comparison ends.
import { signal } from '@preact/signals-core';
import { beforeEach, expect, it } from 'vitest';
import type { CameraPose } from '../../scene/camera/cameraControls.ts';
import { AppState } from '../../state/appState.ts';
import { usualLook } from '../../state/surfaceLook.ts';
import { ViewState } from '../../state/viewState.ts';
import { answering } from '../../testing/fakes.ts';
import { surfaceOf } from '../../testing/records.ts';
import { FieldColours } from '../picture/fieldColours.ts';
import type { OtherTime } from '../time/otherTime.ts';
import type { Half } from './half.ts';
import { linkHalves } from './linkHalves.ts';

class FakeHalf implements Half {
    readonly state = new AppState();
    readonly view = new ViewState();
    readonly colours = new FieldColours();
    readonly worker = answering(() => ({}));
    readonly times: number[] = [];
    readonly clockTimes: (number | null)[] = [];
    readonly moves: [string, object][] = [];
    readonly mode = signal<'none' | 'frozen' | 'clock'>('clock');
    readonly time = signal(0);
    readonly playback = { mode: this.mode, time: this.time, goTo: (time: number) => void this.times.push(time) };
    readonly clock = { set: (time: number | null) => void this.clockTimes.push(time) };
    readonly edits: Half['edits'] = {
        onMove: null,
        follow: ({ id }, change) => void this.moves.push([id, change]),
        turnToo: () => Promise.resolve(),
        chooseRake: () => undefined,
        chooseSurface: (surface) => void (this.state.activeSurface.value = surface),
    };
    followed = 0;
    private moved = (): void => undefined;
    private pose: CameraPose = { position: [0, 0, 5], target: [0, 0, 0], orthographic: false };
    readonly scene: Half['scene'];

    constructor() {
        this.state.stage.value = 'running';
        this.scene = {
            onDraw: () => () => undefined,
            loop: { request: () => undefined },
            controls: {
                pose: this.pose,
                onMove: (listener: () => void) => {
                    this.moved = listener;
                    return () => (this.moved = () => undefined);
                },
                follow: (pose: CameraPose) => {
                    ++this.followed;
                    this.scene.controls = { ...this.scene.controls, pose };
                },
            },
        };
    }

    move(x: number): void {
        this.scene.controls = { ...this.scene.controls, pose: { ...this.pose, position: [x, 0, 5] } };
        this.moved();
    }

    add(surface: string, low: number, high: number): void {
        this.state.surfaces.value = new Map(this.state.surfaces.value).set(surface, surfaceOf(surface));
        const range = { attribute: 'speed', low, high, least: low, greatest: high };
        this.state.valueRanges.value = new Map(this.state.valueRanges.value).set(surface, [range]);
    }
}

let left: FakeHalf;
let right: FakeHalf;
const time = signal<OtherTime>({ kind: 'same' });
const moveTogether = signal(true);
let end: () => void;

beforeEach(() => {
    [left, right] = [new FakeHalf(), new FakeHalf()];
    time.value = { kind: 'same' };
    moveTogether.value = true;
    end = linkHalves(left, right, { time, moveTogether });
});

it('turns either camera with the other, and no more once it has ended', () => {
    left.move(1);
    expect(right.scene.controls.pose.position).toEqual([1, 0, 5]);
    right.move(2);
    expect(left.scene.controls.pose.position).toEqual([2, 0, 5]);
    const before = right.followed;
    left.move(2 + 1e-9);
    expect(right.followed, 'what nobody can see').toBe(before);
    end();
    left.move(7);
    expect(right.scene.controls.pose.position).toEqual([2, 0, 5]);
});

it('gives both the looks that one is given, and one range of colours', () => {
    left.add('s1', 0, 1);
    right.add('s1', -2, 0.5);
    right.view.looks.value = new Map([['s1', { ...usualLook, bands: 7 }]]);
    expect(left.view.lookOf('s1').bands).toBe(7);
    expect(left.view.rangesBeside.value.get('speed')).toMatchObject({ low: -2, high: 0.5 });
    expect(right.view.rangesBeside.value.get('speed')).toMatchObject({ low: 0, high: 1 });
    left.colours.show('c1', 'p', [0, 10]);
    right.colours.show('c1', 'p', [4, 20]);
    expect(left.colours.meanings.value.get('c1')!.range).toEqual([0, 20]);
    expect(right.colours.meanings.value.get('c1')!.range).toEqual([0, 20]);
    end();
    expect(left.view.rangesBeside.value.size).toBe(0);
    left.view.looks.value = new Map();
    expect(right.view.lookOf('s1').bands).toBe(7);
});

it('shows the right half at the same time, so much later, or at a time of its own', () => {
    left.time.value = 3;
    expect(right.times.at(-1)).toBe(3);
    time.value = { kind: 'offset', by: 0.5 };
    left.time.value = 4;
    expect(right.times.at(-1)).toBe(4.5);
    time.value = { kind: 'at', time: 9 };
    left.time.value = 5;
    expect(right.times.at(-1)).toBe(9);
    right.mode.value = 'none';
    expect(right.clockTimes.at(-1), 'slices alone have the time of the clock').toBe(9);
    expect(left.times).toEqual([]);
});

it('moves things together unless that is unticked, and chooses in both what is there', () => {
    left.edits.onMove?.({ noun: 'rake', id: 'r1' }, { seeds: 7 }, 'g1');
    expect(right.moves).toEqual([['r1', { seeds: 7 }]]);
    moveTogether.value = false;
    expect(left.edits.onMove).toBeNull();
    left.add('s1', 0, 1);
    right.add('s1', 0, 1);
    left.add('s2', 0, 1);
    left.state.activeSurface.value = 's1';
    expect(right.state.activeSurface.value).toBe('s1');
    left.state.activeSurface.value = 's2';
    expect(right.state.activeSurface.value, 'which the copy does not have').toBe('s1');
});

it('moves no rake of a session that one may only look at', () => {
    left.state.role.value = 'viewer';
    right.edits.onMove?.({ noun: 'rake', id: 'r1' }, { seeds: 7 }, 'g1');
    expect(left.moves).toEqual([]);
});

it('hides the same in both, and shows everything of what does not have the thing that is shown alone', () => {
    left.add('s1', 0, 1);
    right.add('s1', 0, 1);
    left.add('s2', 0, 1);
    left.view.changeVisibility({ only: 's1', hidden: new Set(['p1']) });
    expect(right.view.visibility.value).toMatchObject({ only: 's1', hidden: new Set(['p1']) });
    left.view.changeVisibility({ only: 's2' });
    expect([left.view.visibility.value.only, right.view.visibility.value.only]).toEqual(['s2', null]);
    right.view.changeVisibility({ only: null, hidden: new Set() });
    expect(left.view.visibility.value).toMatchObject({ only: null, hidden: new Set() });
});

it('lends the tools that look to both, and those that write to neither', () => {
    left.view.tool.value = 'probe';
    expect(right.view.tool.value).toBe('probe');
    left.view.tool.value = 'annotate';
    expect(right.view.tool.value).toBe('none');
});
