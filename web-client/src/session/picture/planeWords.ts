// Where a plane lies, as short as it can be said: `x = 0.5`, or the direction.
import type { Vec3 } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';

const axes = ['x', 'y', 'z'] as const;

export function planeWords(origin: Vec3, normal: Vec3): string {
    const along = axes.findIndex((_, k) => normal.every((each, i) => (i === k) === (each !== 0)));
    if (along >= 0) return `${axes[along]} = ${shortNumber(origin[along]!)}`;
    const length = Math.hypot(...normal) || 1;
    return `across (${normal.map((each) => shortNumber(Number((each / length).toPrecision(2)))).join(', ')})`;
}
