import { beforeAll, describe, expect, it } from 'vitest';
import { dequantise } from '../protocol/lattice.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { dracoPoints } from '../protocol/testing/golden.ts';
import { Dice, lattice, randomUpdates, seededRandom } from '../protocol/testing/randomSurface.ts';
import type { AnimationDescription } from './animationFile.ts';
import { AnimationSteps } from './animationSteps.ts';

let points: DracoPoints;
beforeAll(async () => {
    points = await dracoPoints();
});

const updates = randomUpdates(7, 30);
const frames = updates.flatMap((update) => update.frames);
const attributes = ['speed', 's', 't'];
const description = { lattice, attributes, times: updates.map((_, i) => i) } as unknown as AnimationDescription;

/** The positions that the picture has after the changes so far. */
class Picture {
    private positions = new Float32Array(0);
    private readonly steps: AnimationSteps;

    constructor(steps: AnimationSteps) {
        this.steps = steps;
    }

    at(step: number): Float32Array {
        while (!this.steps.approach(step)) expect(this.steps.awayFrom(step)).toBeGreaterThan(0);
        const { vertices, fromVertex, positions } = this.steps.take({ attributes: ['speed'], parts: null, trimmed: true });
        const whole = new Float32Array(3 * vertices);
        whole.set(this.positions.subarray(0, 3 * Math.min(fromVertex, vertices)));
        whole.set(positions, 3 * fromVertex);
        this.positions = whole;
        return whole;
    }
}

function written(step: number): Float32Array {
    const nodes = Int32Array.from(updates[step]!.state.positions.flat());
    const positions = new Float32Array(nodes.length);
    dequantise(lattice, nodes, positions);
    return positions;
}

describe('the steps of an animation', () => {
    it('are those that were written, in whatever order they are asked for', () => {
        const picture = new Picture(new AnimationSteps({ description, frames }, points));
        const dice = new Dice(seededRandom(3));
        const order = [0, 1, 2, 29, 28, 15, 0, ...Array.from({ length: 20 }, () => dice.below(30))];
        for (const step of order) expect(picture.at(step), `step ${step}`).toEqual(written(step));
    });

    it('are reached from the nearest state that is kept', () => {
        const steps = new AnimationSteps({ description, frames }, points);
        while (!steps.approach(29));
        expect(steps.awayFrom(28)).toBeLessThanOrEqual(2);
        expect(steps.awayFrom(29)).toBe(0);
    });

    it('are refused where the file ends before the last', () => {
        expect(() => new AnimationSteps({ description, frames: frames.slice(0, 10) }, points)).toThrow(/not whole/);
    });
});
