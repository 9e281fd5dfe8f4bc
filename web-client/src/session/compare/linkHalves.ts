// Links the halves of a comparison: camera, looks and what colours mean both ways, the time of the right half by that of the left, rakes,
// slices and streamlines where they are to move together. Ids of records are the same in both, since one is a copy of the other.
import { effect, type ReadonlySignal, type Signal, untracked } from '@preact/signals-core';
import type { CameraPose } from '../../scene/camera/cameraControls.ts';
import { chosenRake, type Visibility } from '../../state/pageView.ts';
import type { ViewState } from '../../state/viewState.ts';
import { thingsThere } from '../picture/chosenThings.ts';
import { automaticRanges } from '../picture/surfaceStyleOf.ts';
import { type OtherTime, otherTime } from '../time/otherTime.ts';
import type { Half } from './half.ts';
import { moves } from './moveTogether.ts';

const looks = [
    'looks',
    'clip',
    'body',
    'slices',
    'lines',
    'orthographic',
    'theme',
    'contactShade',
    'exactWhenStill',
    'probeHeld',
] as const satisfies readonly (keyof ViewState)[];

export interface Links {
    time: ReadonlySignal<OtherTime>;
    moveTogether: ReadonlySignal<boolean>;
}

/** Returns how to end it. */
export function linkHalves(left: Half, right: Half, { time, moveTogether }: Links): () => void {
    const ends = [
        linkCameras(left, right),
        ...looks.flatMap((name) => same(left.view[name] as Signal<unknown>, right.view[name] as Signal<unknown>)),
        ...showAlone(left, right),
        chooseToo(left, right),
        chooseToo(right, left),
        effect(() => {
            // Notes and paint would be those of a copy that is not kept.
            const tool = left.view.tool.value;
            right.view.tool.value = tool === 'probe' || tool === 'measure' ? tool : 'none';
        }),
        effect(() => {
            right.view.rangesBeside.value = automaticRanges(left.state, left.view);
        }),
        effect(() => {
            left.view.rangesBeside.value = automaticRanges(right.state, right.view);
        }),
        effect(() => {
            const then = otherTime(time.value, left.playback.time.value);
            if (right.state.stage.value !== 'running') return;
            // Slices and streamlines alone have the time of the clock.
            const mode = right.playback.mode.value;
            untracked(() => (mode === 'none' ? right.clock.set(then) : right.playback.goTo(then)));
        }),
        effect(() => {
            const together = moveTogether.value;
            left.edits.onMove = together ? moves(left, right) : null;
            right.edits.onMove = together ? moves(right, left) : null;
        }),
    ];
    left.colours.join(right.colours);
    right.colours.join(left.colours);
    return () => {
        for (const end of ends) end();
        left.view.rangesBeside.value = new Map();
        left.colours.join(null);
        right.colours.join(null);
        left.edits.onMove = null;
    };
}

/** The value of the first at first. */
function same<T>(a: Signal<T>, b: Signal<T>): (() => void)[] {
    return [
        effect(() => {
            b.value = a.value;
        }),
        effect(() => {
            a.value = b.value;
        }),
    ];
}

/** What is hidden, and shown alone: of what the other half does not have it shows everything rather than nothing. */
function showAlone(left: Half, right: Half): (() => void)[] {
    const told = new Set<Visibility>();
    const lead = (from: Half, to: Half): (() => void) =>
        effect(() => {
            const visibility = from.view.visibility.value;
            if (told.delete(visibility)) return;
            untracked(() => {
                const { only } = visibility;
                const has = only === null || only === chosenRake || thingsThere(to.state).has(only);
                const shown = has ? visibility : { ...visibility, only: null };
                if (shown === to.view.visibility.value) return;
                told.add(shown);
                to.view.visibility.value = shown;
            });
        });
    return [lead(left, right), lead(right, left)];
}

/** What is chosen in one is chosen in the other, where it is there. */
function chooseToo(from: Half, to: Half): () => void {
    return effect(() => {
        const [rake, surface] = [from.state.activeRake.value, from.state.activeSurface.value];
        untracked(() => {
            const { state, edits } = to;
            if (surface !== null && surface !== state.activeSurface.value && state.surfaces.value.has(surface)) {
                edits.chooseSurface(surface);
            } else if (rake !== null && rake !== state.activeRake.value && state.rakes.value.has(rake)) edits.chooseRake(rake);
        });
    });
}

/** A part of the distance to the target: less than can be seen. */
const sameView = 1e-6;

function linkCameras(left: Half, right: Half): () => void {
    const lead = (from: Half, to: Half) => (): void => {
        if (agree(from.scene.controls.pose, to.scene.controls.pose)) return;
        to.scene.controls.follow(from.scene.controls.pose);
        to.scene.loop.request();
    };
    const ends = [
        left.scene.controls.onMove(lead(left, right)),
        right.scene.controls.onMove(lead(right, left)),
        // Also where it follows someone, of which it does not tell as of a movement.
        left.scene.onDraw(lead(left, right)),
    ];
    lead(left, right)();
    return () => ends.forEach((end) => end());
}

function agree(a: CameraPose, b: CameraPose): boolean {
    const distance = Math.hypot(...a.position.map((each, k) => each - a.target[k]!));
    const apart = [...a.position, ...a.target].map((each, k) => Math.abs(each - [...b.position, ...b.target][k]!));
    return a.orthographic === b.orthographic && Math.max(...apart) <= sameView * distance;
}
