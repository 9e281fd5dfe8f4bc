// Ends for the colours of a surface: its own least and greatest value, rounded outward. It depends on nothing
// but those, so that every user who looks at the surface sees the same colours, and small changes, as while
// it plays, leave them as they are.
import { niceStep } from '../base/ticks.ts';

const parts = 10;

export function steadyRange(least: number, greatest: number): [number, number] {
    const step = niceStep((greatest - least) / parts);
    if (!(step > 0) || !Number.isFinite(step)) return [least, greatest];
    // As decimals: 3 * 0.1 is a little more than 0.3.
    const at = (steps: number): number => Number((steps * step).toPrecision(12));
    return [at(Math.floor(least / step + 1e-9)), at(Math.ceil(greatest / step - 1e-9))];
}
