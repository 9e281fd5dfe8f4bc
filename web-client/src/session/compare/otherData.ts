// Makes the records of a copied session show another dataset: the same rakes and settings built in it. What that cannot have is left out,
// and why is said.
import type { DatasetDescription, SessionSnapshot, SurfaceSetting } from '../../protocol/messages.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import { settingForRecovery } from '../edits/surfaceIntent.ts';
import { canCome } from '../picture/surfaceStyleOf.ts';
import { clampTo } from '../time/timeSteps.ts';
import { Refusals } from '../view/sessionRecovery.ts';

/** Returns what could not be shown in it, in words; null: all is there. Throws where the dataset is not there. */
export async function showOtherData(
    worker: Pick<WorkerClient, 'call'>,
    { rakes, surfaces, slices, lines }: SessionSnapshot,
    dataset: string,
): Promise<string | null> {
    const description = await worker.call('dataset.describe', { dataset });
    const own = new Map(rakes.map(({ rake }) => [rake, rake]));
    const refusals = new Refusals();
    for (const record of surfaces) {
        const { surface } = record;
        const setting = settingForRecovery(record, own);
        const made = await refusals.of(
            'surface',
            setting === null ? null : () => worker.call('surface.set', { ...fitted(setting, description), surface, dataset }),
        );
        if (made === null) await worker.call('surface.delete', { surface });
    }
    for (const { slice, rev: _, ...setting } of slices) {
        const made = await refusals.of('slice', () => worker.call('slice.set', { ...setting, slice, dataset }));
        if (made === null) await worker.call('slice.delete', { slice });
    }
    for (const { lines: id, rev: _, ...setting } of lines) {
        const made = await refusals.of('set of streamlines', () => worker.call('lines.set', { ...setting, lines: id, dataset }));
        if (made === null) await worker.call('lines.delete', { lines: id });
    }
    return refusals.says(`Not shown in ${description.name}`);
}

/** With the times that the data have nearest to its own, and without values that they cannot give. A stream surface may end at any time. */
function fitted(wanted: SurfaceSetting, description: DatasetDescription): SurfaceSetting {
    const { times, steady } = description;
    const setting = { ...wanted, fields: (wanted.fields ?? []).filter((field) => canCome(description, field)) };
    const [first, last] = [times[0], times.at(-1)];
    if (first === undefined || last === undefined || steady || first === last) return setting;
    const from = clampTo([first, last], setting.from);
    if (setting.kind === 'stream') return { ...setting, from, to: from + (setting.to - setting.from) };
    const to = clampTo([first, last], setting.to);
    return { ...setting, from, to };
}
