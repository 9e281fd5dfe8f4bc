// What of a style goes into an animation: how the surface is coloured and drawn, without what belongs to the session or to the page.
// Whoever reads it cannot know who wrote it: what is not of the right type is as usual.
import { colourMapNames, isBands } from './colourMap.ts';
import { plainStyle, type SurfaceStyle } from './surfaceStyle.ts';

const saved = [
    ...(['source', 'scalar', 'colour', 'map', 'inverted', 'logarithmic', 'root', 'bands', 'range'] as const),
    ...(['centre', 'backSide'] as const),
    ...(['points', 'opacity', 'angleOpacity', 'smoke', 'fixedGrid', 'areaPerSeed', 'silhouettes', 'hatchAbove'] as const),
    ...(['lines', 'pieces', 'pieceEvery', 'pieceWidth', 'rakeCloses', 'density', 'texture', 'sWindow', 'ageWindow'] as const),
];
type Saved = (typeof saved)[number];
export type SavedLook = Partial<Pick<SurfaceStyle, Saved>>;

/** Those that belong to the value that is shown in colours. */
const colouring = ['source', 'scalar', 'colour', 'map', 'inverted', 'logarithmic', 'root', 'bands', 'range', 'centre'] as const;

/** What differs from the plain style. A range that nobody has chosen is left out: an animation has its own. */
export function savedLook(style: SurfaceStyle): SavedLook {
    const chosen = style.rangeOf === 'locked' || style.rangeOf === 'data';
    const differs = (name: Saved): boolean => JSON.stringify(style[name]) !== JSON.stringify(plainStyle[name]);
    const kept = saved.filter(
        (name) => name === 'source' || name === 'scalar' || (differs(name) && (name !== 'range' || chosen)),
    );
    return Object.fromEntries(kept.map((name) => [name, style[name]]));
}

/** Never throws. */
export function readLook(value: unknown): SavedLook {
    if (typeof value !== 'object' || value === null) return {};
    const given = Object.entries(value).filter(
        ([name, each]) => (saved as readonly string[]).includes(name) && fits(name as Saved, each),
    );
    return Object.fromEntries(given);
}

/** The look of another value: the same surface, with the colours as usual. */
export function withoutColours(look: SavedLook): SavedLook {
    return Object.fromEntries(Object.entries(look).filter(([name]) => !(colouring as readonly string[]).includes(name)));
}

function fits(name: Saved, value: unknown): boolean {
    if (name === 'map') return (colourMapNames as readonly unknown[]).includes(value);
    if (name === 'colour') return typeof value === 'string' && /^#[0-9a-f]{6}$/i.test(value);
    if (name === 'bands') return isBands(value);
    if (name === 'centre' || name === 'hatchAbove') return typeof value === 'number';
    if (name === 'range' || name === 'sWindow' || name === 'ageWindow') {
        return Array.isArray(value) && value.length === 2 && value.every((each) => typeof each === 'number');
    }
    return typeof value === typeof plainStyle[name];
}
