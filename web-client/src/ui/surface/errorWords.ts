// Says how far a surface may be from where it truly is, in words.
import type { SurfaceStats } from '../../protocol/messages.ts';
import { shortNumber } from '../../scene/base/numbers.ts';
import { withUnit } from '../../session/picture/unitsInPicture.ts';
import { countWords } from '../base/statusWords.ts';

type StatedError = Pick<SurfaceStats, 'error99' | 'uncertain' | 'vertices'>;

/** Returns whether so many vertices are uncertain that the 99th percentile of all would exceed the
 *  separation. */
export function isDoubtful(stats: StatedError | undefined): boolean {
    return stats?.uncertain !== undefined && 100 * stats.uncertain > stats.vertices;
}

/** Returns words like "99 % of vertices within 0.004 m, 12 are uncertain". Nothing of a distance where too
 *  many are. */
export function errorWords(stats: StatedError, unit: string): string {
    const uncertain = stats.uncertain ?? 0;
    if (isDoubtful(stats)) return `${countWords(uncertain)} of ${countWords(stats.vertices)} vertices uncertain`;
    const within = `99 % of vertices within ${withUnit(shortNumber(Number((stats.error99 ?? 0).toPrecision(2))), unit)}`;
    return uncertain === 0 ? within : `${within}, ${countWords(uncertain)} uncertain`;
}
