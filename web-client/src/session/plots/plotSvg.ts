// A plot as a picture of lines and text, for papers: the same axes, numbers and colours as on the page, on white.
import { axesOf, lineColours, rangeOf, type PlotAxis, ticksAcross, ticksUp, withShared } from './plotAxes.ts';
import { type Plot, titleOf } from './plot.ts';

interface Frame {
    left: number;
    right: number;
    top: number;
    bottom: number;
}

const [width, height] = [800, 420];
const axisWidth = 78;
const ink = '#17202d';
const grid = '#d5dbe4';

export function plotSvg(plot: Plot): string {
    const axes = axesOf(plot);
    const frame = { left: axisWidth, right: width - Math.max(20, axisWidth * (axes.length - 1)), top: 58, bottom: height - 58 };
    const [low, high] = rangeOf(plot.x.values) ?? [0, 1];
    const across = (value: number): number => place(value, [low, high], frame.left, frame.right);
    const parts = [
        `<rect width="${width}" height="${height}" fill="#ffffff"/>`,
        text(plot.title, frame.left, 22, 'font-weight="600"'),
        ...legend(plot, frame),
        ...lower(plot, frame, [low, high], across),
        ...axes.flatMap((axis, i) => upright(axis, i, frame)),
        `<rect x="${frame.left}" y="${frame.top}" width="${frame.right - frame.left}" height="${frame.bottom - frame.top}" fill="none" stroke="${ink}"/>`,
        ...axes.flatMap((axis) => axis.series.map((i) => line(plot, i, axis, frame, across))),
    ];
    return [
        `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" ` +
            `font-family="Helvetica, Arial, sans-serif" font-size="13" fill="${ink}">`,
        ...parts,
        '</svg>',
        '',
    ].join('\n');
}

function place(value: number, [low, high]: readonly [number, number], from: number, to: number): number {
    return Number((from + ((to - from) * (value - low)) / (high - low || 1)).toFixed(2));
}

function lower(plot: Plot, frame: Frame, [low, high]: [number, number], across: (value: number) => number): string[] {
    const ticks = ticksAcross(low, high, frame.right - frame.left);
    return [
        ...ticks.ticks.flatMap(({ value, label }) => [
            `<path d="M${across(value)} ${frame.top}V${frame.bottom}" stroke="${grid}"/>`,
            text(label, across(value), frame.bottom + 19, 'text-anchor="middle"'),
        ]),
        text(withShared(titleOf(plot.x), ticks), (frame.left + frame.right) / 2, frame.bottom + 42, 'text-anchor="middle"'),
    ];
}

/** The first on the left, with lines across; the others on the right. */
function upright({ range, title }: PlotAxis, index: number, frame: Frame): string[] {
    const ticks = ticksUp(...range, frame.bottom - frame.top);
    const up = (value: number): number => place(value, range, frame.bottom, frame.top);
    const first = index === 0;
    const x = first ? frame.left : frame.right + axisWidth * (index - 1);
    const turned = first ? x - 58 : x + 62;
    const middle = (frame.top + frame.bottom) / 2;
    return [
        ...ticks.ticks.flatMap(({ value, label }) => [
            first
                ? `<path d="M${frame.left} ${up(value)}H${frame.right}" stroke="${grid}"/>`
                : `<path d="M${x} ${up(value)}h5" stroke="${ink}"/>`,
            text(label, first ? x - 7 : x + 9, up(value) + 4.5, first ? 'text-anchor="end"' : ''),
        ]),
        index > 1 ? `<path d="M${x} ${frame.top}V${frame.bottom}" stroke="${ink}"/>` : '',
        text(withShared(title, ticks), turned, middle, `text-anchor="middle" transform="rotate(-90 ${turned} ${middle})"`),
    ].filter((part) => part !== '');
}

function legend({ series }: Plot, { left }: Frame): string[] {
    let x = left;
    return series.flatMap(({ name }, i) => {
        const at = x;
        x += 40 + 7.5 * name.length;
        return [
            `<path d="M${at} 39h20" stroke="${lineColours[i % lineColours.length]}" stroke-width="2"/>`,
            text(name, at + 26, 43.5),
        ];
    });
}

/** Broken where there are no values; a value alone is a dot. */
function line({ x, series }: Plot, index: number, { range }: PlotAxis, frame: Frame, across: (value: number) => number): string {
    const { values } = series[index]!;
    const there = (i: number): boolean => Number.isFinite(values[i] ?? Number.NaN);
    const d = values.map((value, i) => {
        if (!there(i)) return '';
        const at = `${across(x.values[i]!)} ${place(value, range, frame.bottom, frame.top)}`;
        if (there(i - 1)) return `L${at}`;
        return there(i + 1) ? `M${at}` : `M${at}h0`;
    });
    const colour = lineColours[index % lineColours.length];
    return `<path d="${d.join('')}" fill="none" stroke="${colour}" stroke-width="2" stroke-linejoin="round" stroke-linecap="round"/>`;
}

function text(words: string, x: number, y: number, rest = ''): string {
    const safe = words.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
    return `<text x="${x}" y="${y}"${rest === '' ? '' : ` ${rest}`}>${safe}</text>`;
}
