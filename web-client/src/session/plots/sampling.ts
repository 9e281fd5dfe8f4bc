// Samples what a plot shows: at all points of a line at one time, or at one point at one time after the other.
import type { DatasetDescription, ParamsOf, ResultOf, Vec3 } from '../../protocol/messages.ts';
import type { Column, Plot, Series } from './plot.ts';
import { fieldsOf, type Quantity, valuesOf } from './quantities.ts';
import type { PointsAlong } from './plotLine.ts';

export type Sample = (params: ParamsOf<'probe.sample'>, signal: AbortSignal) => Promise<ResultOf<'probe.sample'>>;

interface Sampled {
    dataset: DatasetDescription;
    quantities: readonly Quantity[];
    lengthUnit: string;
    timeUnit: string;
}

export interface LineWish extends Sampled {
    line: PointsAlong;
    time: number;
    title: string;
}

export async function sampleLine(wish: LineWish, sample: Sample, signal: AbortSignal): Promise<Plot> {
    const { dataset, quantities, line, time, lengthUnit, timeUnit } = wish;
    const fields = fieldsOf(dataset, quantities);
    const found = await sample({ dataset: dataset.dataset, points: line.points, time, fields }, signal);
    const series = quantities.map((each): Series => ({ ...each, values: valuesOf(dataset, each, found) }));
    const inside = found.inside.filter(Boolean).length;
    const lacking = series.filter(({ values }) => values.every(Number.isNaN));
    const notes =
        inside === 0
            ? ['No point of this line is in the fluid.']
            : lacking.map(({ name }) => `${name} has no values along this line at this time.`);
    return {
        title: wish.title,
        x: { name: 'distance', unit: lengthUnit, values: line.distances },
        places: [...coordinates(line.points, lengthUnit), { name: 'time', unit: timeUnit, values: line.points.map(() => time) }],
        series,
        notes,
    };
}

export interface HistoryWish extends Sampled {
    point: Vec3;
    times: readonly number[];
    title: string;
}

/** Of one time: whether the point is in the fluid, and a value for each quantity. */
interface Moment {
    inside: boolean;
    values: number[];
}

/** As many times are asked for at once: more than one, so that none waits for the way of the last. */
const atOnce = 2;

/** What is known is asked for no more. One for each place, field and state of the data. */
export class History {
    private readonly known = new Map<number, Moment>();

    /** Asks for one time after the other. @param drawn  told how far it is, after each */
    async sample(wish: HistoryWish, sample: Sample, signal: AbortSignal, drawn: (part: number) => void): Promise<void> {
        const { dataset, point, quantities } = wish;
        const missing = wish.times.filter((time) => !this.known.has(time));
        const fields = fieldsOf(dataset, quantities);
        let next = 0;
        let failed = false;
        let done = wish.times.length - missing.length;
        const goOn = async (): Promise<void> => {
            while (next < missing.length && !signal.aborted && !failed) {
                const time = missing[next++]!;
                const found = await sample({ dataset: dataset.dataset, points: [point], time, fields }, signal).catch(
                    (error: unknown) => {
                        failed = true;
                        throw error;
                    },
                );
                // What came beside one that failed is kept for the next try, and not drawn over its words.
                const values = quantities.map((each) => valuesOf(dataset, each, found)[0] ?? Number.NaN);
                this.known.set(time, { inside: found.inside[0] === true, values });
                ++done;
                if (!failed) drawn(done / wish.times.length);
            }
        };
        await Promise.all(Array.from({ length: atOnce }, goOn));
    }

    /** Of what is known by now. */
    plot({ quantities, point, times, title, timeUnit, lengthUnit }: HistoryWish): Plot {
        const moments = times.map((time) => this.known.get(time));
        const known = moments.filter((each) => each !== undefined);
        const series = quantities.map((each, i): Series => ({
            ...each,
            values: moments.map((moment) => moment?.values[i] ?? Number.NaN),
        }));
        const inFluid = known.filter(({ inside }) => inside).length;
        return {
            title,
            x: { name: 'time', unit: timeUnit, values: times },
            places: coordinates(
                times.map(() => point),
                lengthUnit,
            ),
            series,
            notes: known.length > 0 && inFluid === 0 ? ['This point is not in the fluid.'] : lacks(quantities, known),
        };
    }
}

function lacks(quantities: readonly Quantity[], known: readonly Moment[]): string[] {
    const inside = known.filter((each) => each.inside);
    const outside = known.length - inside.length;
    return [
        ...(outside > 0 ? [`Not in the fluid at ${outside} of ${known.length} times.`] : []),
        ...quantities.flatMap(({ name }, i) => {
            const lacking = inside.filter(({ values }) => Number.isNaN(values[i])).length;
            return lacking === 0 ? [] : [`${name} has no values at ${lacking} of ${known.length} times.`];
        }),
    ];
}

function coordinates(points: readonly Vec3[], unit: string): Column[] {
    return ['x', 'y', 'z'].map((name, axis) => ({ name, unit, values: points.map((point) => point[axis]!) }));
}
