// The streamlines of sets in the picture, as the server has them at a time. A set is asked for at once as a whole.
import type { LinesRecord } from '../../protocol/messages.ts';
import { type LinesFile, readLinesFile } from '../../protocol/linesFile.ts';
import { NewestValues, type NewestValuesOptions } from './newestValues.ts';

export type LinesWish = Omit<LinesRecord, 'lines' | 'rev' | 'low' | 'high'> & {
    /** Null: the data have one time. */
    time: number | null;
};

export class LinesValues extends NewestValues<LinesWish, LinesFile> {
    constructor(options: Omit<NewestValuesOptions<LinesWish, LinesFile>, 'path' | 'read' | 'detail'>) {
        super({ ...options, path: linesPath, read: readLinesFile, detail: { coarse: 1, full: 1, learn: () => undefined } });
    }
}

export function linesPath(wish: LinesWish): string {
    const { dataset, kind, points, distance, patches, seeds, direction, duration, length, field, time } = wish;
    const far = kind === 'sphere' || kind === 'walls' ? [distance] : [];
    const from = [kind, ...points.map((point) => point.join(',')), ...far].join(':');
    const query = new URLSearchParams({ from, seeds: String(seeds), direction, field });
    if (patches.length > 0) query.set('patch', patches.join('\n'));
    if (duration > 0) query.set('duration', String(duration));
    if (length > 0) query.set('length', String(length));
    if (time !== null) query.set('time', String(time));
    return `api/v1/datasets/${encodeURIComponent(dataset)}/lines.bin?${query.toString()}`;
}
