// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './rakePanel.ts';

let bench: PageBench;
let panel: ShownPanel;

beforeEach(async () => {
    bench = new PageBench();
    const interaction = { step: null, highlight: () => undefined, endNudge: () => undefined };
    panel = await ShownPanel.of('wakesurf-rake', Object.assign(bench, { scene: { interaction, rakes: {} } }));
});

/** What is said, by what it is about. */
const said = () => bench.state.problems.all.value;
const points = () => bench.rakes[0]!.points;

/** Types as a person does who presses Enter in a field: every edit ends what was said of the one before. */
async function type(name: string, value: number): Promise<void> {
    bench.edits.gestures.press();
    await panel.enter('input', name, value);
    bench.edits.gestures.release();
}

describe('a number that a rake cannot have', () => {
    it('is answered with those that it can, each in words of its own, until the next edit', async () => {
        await type('Seeds', 100_000);
        expect(said().get('seeds')).toContain('2 to 4096 seeds');
        expect(panel.get('#seeds').value).toBe('32');
        await type('End x', 99);
        expect(said().get('rake outside')).toContain('x = −3 to 12.92');
        expect(points()[1]![0]).toBe(12.92);
        expect([...said().keys()]).toEqual(['rake outside']);
        await type('Seeds', 20);
        expect(said().size).toBe(0);
        expect(bench.rakes[0]!.seeds).toBe(20);
    });

    it('does not move the other coordinates, on a map far from its origin', async () => {
        bench.state.dataset.value = { ...bench.state.dataset.value!, bounds: [512345, 512445, 5423700, 5423800, 0, 40] };
        await bench.worker.call('rake.set', {
            ...{ rake: 'rake-1', kind: 'line', seeds: 8 },
            points: [
                [512360, 5423712.125, 3],
                [512360, 5423712.125, 30],
            ],
        });
        await rested();
        const before = points();
        expect(panel.get('input', 'Start y').value).toBe('5423712.125');
        await type('Start x', -50);
        expect(points()).toEqual([[512345, before[0]![1], before[0]![2]], before[1]]);
        expect(said().get('rake outside')).toContain('x stops at 512345; y and z stay');
        expect(panel.get('input', 'Start x').value).toBe('512345');
    });
});

describe('the controls of a rake', () => {
    it('have names: each handle a button, each coordinate of the ends a field', () => {
        for (const name of ['Start', 'Middle', 'End']) expect(panel.all('button', name), name).toHaveLength(1);
        for (const end of ['Start', 'End']) {
            for (const axis of ['x', 'y', 'z']) expect(panel.all('input', `${end} ${axis}`), `${end} ${axis}`).toHaveLength(1);
        }
    });
});
