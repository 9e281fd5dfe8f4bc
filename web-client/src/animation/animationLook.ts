// How the surface of an animation is drawn: as the page drew it when the file was made, or coloured by another value.
import { steadyRange } from '../scene/surface/colourMap.ts';
import { readLook, withoutColours } from '../scene/surface/savedLook.ts';
import { flowNames } from '../scene/surface/surfaceMesh.ts';
import { plainStyle, type SurfaceStyle } from '../scene/surface/surfaceStyle.ts';
import type { ShowWish } from '../worker/workerMessages.ts';
import type { AnimatedValue, AnimationDescription } from './animationFile.ts';

/** What the frames call the time of release, or the age. */
const time = 't';

/** What the colours show. */
export interface ColourChoice {
    title: string;
    style: SurfaceStyle;
}

/** The first is what is shown at first. */
export function colourChoices(description: AnimationDescription): ColourChoice[] {
    const look = readLook(description.look);
    const base: SurfaceStyle = { ...plainStyle, ...timesOf(description), source: 'constant', scalar: '' };
    const plain = withoutColours(look);
    const others = description.values.map((value) => ({
        value,
        title: value.title,
        style: { ...base, ...plain, ...usual(value) },
    }));
    const { source } = look;
    if (source === undefined) return others;
    const name = source === 'age' ? time : (look.scalar ?? '');
    const own = others.find(({ value }) => (source === 'age' || source === 'scalar') && value.name === name);
    // What the file has not.
    if (own === undefined && source !== 's' && source !== 'constant') return others;
    const range = own === undefined ? null : rangeOf(own.value, look.logarithmic);
    const chosen = {
        title: own?.title ?? (source === 's' ? 'Place along the rake' : 'One colour'),
        style: { ...base, range, ...look, rangeOf: 'film' as const },
    };
    return [chosen, ...others.filter((each) => each !== own)];
}

function timesOf({ kind, from }: AnimationDescription): Pick<SurfaceStyle, 'from' | 'tIsRelease' | 'tOrigin'> {
    const isStreak = kind === 'streak';
    return { from, tIsRelease: isStreak, tOrigin: isStreak ? from : 0 };
}

function usual(value: AnimatedValue): Partial<SurfaceStyle> {
    const { name, signed } = value;
    const source = name === time ? 'age' : 'scalar';
    const common = { source, scalar: name, range: rangeOf(value), rangeOf: 'film' } as const;
    return signed ? { ...common, map: 'coolToWarm', centre: 0 } : common;
}

/** Over all steps, with the ends that the page would choose. */
function rangeOf({ name, range }: AnimatedValue, logarithmic = false): readonly [number, number] {
    return logarithmic || name === time ? range : steadyRange(...range);
}

/** What has to be computed of each step for that. */
export function wishOf({ source, scalar, texture, pieces, smoke, hatchAbove, rakeCloses, fixedGrid }: SurfaceStyle): ShowWish {
    const attributes = [
        ...(source === 'scalar' ? [scalar] : []),
        ...(texture || pieces === 'arrows' ? flowNames : []),
        ...(smoke > 0 ? ['deformation'] : []),
        ...(hatchAbove === null ? [] : ['interval_error']),
    ];
    return {
        attributes: [...new Set(attributes)],
        parts: null,
        trimmed: true,
        ...(pieces === 'whole' ? {} : { units: rakeCloses ? 'closed' : 'open' }),
        ...(smoke > 0 && fixedGrid ? { unresolved: true } : {}),
    };
}
