// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { PageBench } from '../../testing/pageBench.ts';
import { displayedOf } from '../../testing/records.ts';
import { rested, ShownPanel } from '../../testing/shownPanel.ts';
import './numbersPanel.ts';

let bench: PageBench;
let panel: ShownPanel;
let asked: Record<string, string>[];
let answer: { text: string | null; fault: string };

beforeEach(async () => {
    bench = new PageBench();
    asked = [];
    answer = {
        text: 'area [m^2],area_error [m^2],area_interval_error [m^2],flux,notes\n3.2123,0.0213,,,it is torn\n',
        fault: '',
    };
    const numbers = (_session: string, _surface: string, query: Record<string, string>) => {
        asked.push(query);
        return Promise.resolve(answer);
    };
    panel = await ShownPanel.of('wakesurf-numbers', Object.assign(bench, { mesh: { numbers } }));
});

async function arrived(stateSum: number, phase: 'final' | 'coarse' = 'final'): Promise<void> {
    const epoch = bench.surfaces[0]?.epoch ?? 0;
    bench.state.displayed.value = new Map([['surface-1', displayedOf('surface-1', { epoch, stateSum, phase })]]);
    await rested();
}

async function opened(): Promise<void> {
    const details = panel.get<HTMLDetailsElement>('#numbers');
    details.open = true;
    details.dispatchEvent(new Event('toggle'));
    await rested();
}

describe('the numbers of a surface', () => {
    it('are asked for once a complete state, and only where they are looked at', async () => {
        await arrived(1);
        expect(asked).toEqual([]);
        await opened();
        await rested();
        expect(asked).toEqual([{ fields: 'U' }]);
        await arrived(2, 'coarse');
        expect(asked).toHaveLength(1);
        await arrived(3);
        expect(asked).toHaveLength(2);
    });

    it('have their error, no error that is not known, and say why', async () => {
        await arrived(1);
        await opened();
        expect(panel.get<HTMLElement>('[data-name=area]').textContent).toBe('3.212 ± 0.021 m^2');
        expect(panel.all('[data-name=flux]')).toEqual([]);
        expect(panel.get<HTMLElement>('#numbers-notes').textContent).toBe('it is torn');
    });

    it('are taken where a plane or a box is named, and a wrong one is refused in words', async () => {
        await arrived(1);
        await opened();
        answer = { text: null, fault: 'it is neither' };
        const field = panel.get('#through');
        field.value = ' ball:1 ';
        field.dispatchEvent(new Event('change'));
        await rested();
        expect(asked.at(-1)).toMatchObject({ through: 'ball:1' });
        expect(panel.get<HTMLElement>('[role=alert]').textContent).toBe('it is neither');
    });
});
