// Where the numbers of a scalar bar go: round ones, evenly or by powers of ten.
import { shortNumber } from '../base/numbers.ts';
import { niceTicks, type Tick, type Ticks } from '../base/ticks.ts';

const steps: readonly (readonly number[])[] = [[1, 2, 5], [1, 3], [1]];

export function colourTicks(low: number, high: number, logarithmic: boolean, wanted: number): Ticks {
    if (!logarithmic) return niceTicks(low, high, wanted);
    if (!(low > 0) || !(high > low)) return { ticks: [], shared: '' };
    const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
    // Less than a power of ten: as if it were even.
    if (high / low < 5) return niceTicks(low, high, wanted);
    const apart = Math.max(1, Math.ceil((last - first) / wanted));
    const ticksOf = (factors: readonly number[]): Tick[] => {
        const ticks: Tick[] = [];
        for (let power = first; power <= last; power += apart) {
            for (const factor of factors) {
                const value = Number(`${factor}e${power}`);
                if (value >= low * 0.9999 && value <= high * 1.0001) ticks.push({ value, label: shortNumber(value) });
            }
        }
        return ticks;
    };
    return { ticks: steps.map(ticksOf).find((ticks) => ticks.length <= wanted + 1) ?? ticksOf([1]), shared: '' };
}
