// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { withEntry } from '../../state/appState.ts';
import { sampleStatistics } from '../../testing/records.ts';
import { PageBench, put } from '../../testing/pageBench.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './twinPanel.ts';

let bench: PageBench;
let panel: ShownPanel;

beforeEach(async () => {
    bench = new PageBench();
    panel = await ShownPanel.of('wakesurf-twin', bench);
});

const asked = (): unknown[] => bench.asked('surface.twin').map(({ gesture: _, ...rest }) => rest);

async function compared(twin: object, stats: object): Promise<void> {
    bench.tell([put('surface', 'surface-1', { ...bench.surfaces[0]!, twin })]);
    bench.state.outcomes.value = withEntry(bench.state.outcomes.value, 'surface-1', sampleStatistics(stats));
    await rested();
}

describe('a twin', () => {
    it('is chosen in words, and ends when nothing is to be compared', async () => {
        await panel.enter('#twin-with', 'Compare with', 'exact');
        expect(asked()).toEqual([{ surface: 'surface-1', twin: { accuracy: 'exact' } }]);
        await compared({ accuracy: 'exact' }, {});
        expect(panel.get<HTMLSelectElement>('#twin-with').value).toBe('exact');
        await panel.enter('#twin-with', 'Compare with', 'nothing');
        expect(asked()[1]).toEqual({ surface: 'surface-1' });
    });

    it('may begin beside the rake, by an offset that can be typed', async () => {
        await compared({ offset: [0.2, 0, 0] }, {});
        expect(panel.get<HTMLSelectElement>('#twin-with').value).toBe('moved');
        await panel.enter('input', 'Offset along y', 0.5);
        expect(asked()).toEqual([{ surface: 'surface-1', twin: { offset: [0.2, 0.5, 0] } }]);
    });

    it('is listed as a script asked for it where no choice says the same', async () => {
        await compared({ accuracy: 'exact', dataset: 'other-run' }, {});
        expect(panel.all('option').map((each) => each.textContent.trim())).toContain('accuracy exact, dataset other-run');
    });

    it('is apart by distances, a lag and a share that are said, and by age', async () => {
        const all = { age: 7.5, compared: 0.9512, p50: 0.0123, p90: 0.2, p99: 0.456, lag50: -0.031 };
        const ages = [{ ...all, age: 3.75, compared: 1, p99: 0.1 }, all];
        await compared({ accuracy: 'exact' }, { twin: { all, ages } });
        expect(panel.get<HTMLElement>('#twin-result').textContent).toBe(
            'Apart: half within 0.012, 90 % within 0.2, 99 % within 0.46. It comes 0.031 earlier at the median. 95.1 % of the particles are there in both.',
        );
        expect(panel.all('tbody tr').map((row) => row.textContent)).toEqual(['3.80.0120.20.1−0.031', '7.50.0120.20.46−0.031']);
        await panel.click('button', 'Colour by distance');
        expect(bench.surfaces[0]).toMatchObject({
            twin: { accuracy: 'exact' },
            fields: ['twin_distance'],
        });
        expect(bench.view.lookOf('surface-1').colourBy).toBe('twin_distance');
    });

    it('says why there is none', async () => {
        await compared({ dataset: 'other-run' }, { twinLeftOut: 'the twin: the rake is outside the domain' });
        expect(panel.get<HTMLElement>('#twin-result').textContent).toBe('The twin: the rake is outside the domain.');
    });
});
