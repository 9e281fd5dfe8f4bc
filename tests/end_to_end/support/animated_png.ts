// Pictures as one animated PNG of 256 colours, which browsers and GitHub show without a click. Of each frame only the part that
// has changed is in the file.
import { crc32, deflateSync } from 'node:zlib';

export interface Frame {
    width: number;
    height: number;
    /** RGBA; opaque. */
    pixels: Uint8Array;
}

type Colour = readonly [number, number, number];

const colours = 256;

/** Of a colour, the part that the palette is chosen by: five bits of red, six of green, five of blue. */
function bucket(red: number, green: number, blue: number): number {
    return ((red >> 3) << 11) | ((green >> 2) << 5) | (blue >> 3);
}

interface Box {
    buckets: { colour: Colour; count: number }[];
    axis: 0 | 1 | 2;
    spread: number;
    count: number;
}

function boxOf(buckets: Box['buckets']): Box {
    let axis: Box['axis'] = 0;
    let spread = -1;
    for (const each of [0, 1, 2] as const) {
        const values = buckets.map(({ colour }) => colour[each]);
        const extent = Math.max(...values) - Math.min(...values);
        if (extent > spread) [axis, spread] = [each, extent];
    }
    return { buckets, axis, spread, count: buckets.reduce((sum, { count }) => sum + count, 0) };
}

function halves({ buckets, axis, count }: Box): [Box, Box] {
    const sorted = buckets.toSorted((a, b) => a.colour[axis] - b.colour[axis]);
    let [at, below] = [0, 0];
    while (at < sorted.length - 1 && (at === 0 || below < count / 2)) below += sorted[at++]!.count;
    return [boxOf(sorted.slice(0, at)), boxOf(sorted.slice(at))];
}

/** Median cut (Heckbert, Color Image Quantization for Frame Buffer Display, 1982), of all frames together. */
function paletteOf(frames: readonly Frame[]): Colour[] {
    const counts = new Map<number, { colour: Colour; count: number }>();
    for (const { pixels } of frames) {
        for (let at = 0; at < pixels.length; at += 4) {
            const colour: Colour = [pixels[at]!, pixels[at + 1]!, pixels[at + 2]!];
            const found = counts.get(bucket(...colour));
            if (found === undefined) counts.set(bucket(...colour), { colour, count: 1 });
            else ++found.count;
        }
    }
    const boxes = [boxOf([...counts.values()])];
    while (boxes.length < colours) {
        const weight = ({ buckets, spread, count }: Box): number => (buckets.length < 2 ? -1 : spread * Math.sqrt(count));
        const widest = boxes.reduce((best, each, i) => (weight(each) > weight(boxes[best]!) ? i : best), 0);
        if (boxes[widest]!.buckets.length < 2) break;
        boxes.splice(widest, 1, ...halves(boxes[widest]!));
    }
    return boxes.map(({ buckets, count }) => {
        const mean = (axis: 0 | 1 | 2): number =>
            Math.round(buckets.reduce((sum, each) => sum + each.colour[axis] * each.count, 0) / count);
        return [mean(0), mean(1), mean(2)];
    });
}

/** Places of the nearest colours, looked up once for each bucket. */
function indexed({ pixels }: Frame, palette: readonly Colour[], known: Map<number, number>): Uint8Array {
    const out = new Uint8Array(pixels.length / 4);
    for (let i = 0; i < out.length; ++i) {
        const [red, green, blue] = [pixels[4 * i]!, pixels[4 * i + 1]!, pixels[4 * i + 2]!];
        const key = bucket(red, green, blue);
        let found = known.get(key);
        if (found === undefined) {
            const distance = ([r, g, b]: Colour): number => (r - red) ** 2 + (g - green) ** 2 + (b - blue) ** 2;
            found = palette.reduce((best, each, at) => (distance(each) < distance(palette[best]!) ? at : best), 0);
            known.set(key, found);
        }
        out[i] = found;
    }
    return out;
}

function chunk(type: string, data: Uint8Array): Buffer {
    const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
    const out = Buffer.alloc(body.length + 8);
    out.writeUInt32BE(data.length, 0);
    body.copy(out, 4);
    out.writeUInt32BE(crc32(body), body.length + 4);
    return out;
}

function words(...values: number[]): Buffer {
    const out = Buffer.alloc(4 * values.length);
    values.forEach((value, i) => out.writeUInt32BE(value, 4 * i));
    return out;
}

interface Part {
    left: number;
    top: number;
    width: number;
    height: number;
}

/** The smallest part that holds all that differs; one pixel where nothing does. */
function changed(now: Uint8Array, before: Uint8Array | undefined, { width, height }: Frame): Part {
    if (before === undefined) return { left: 0, top: 0, width, height };
    let [left, right, top, bottom] = [width, -1, height, -1];
    for (let i = 0; i < now.length; ++i) {
        if (now[i] === before[i]) continue;
        const [x, y] = [i % width, Math.floor(i / width)];
        [left, right, top, bottom] = [Math.min(left, x), Math.max(right, x), Math.min(top, y), Math.max(bottom, y)];
    }
    return right < 0
        ? { left: 0, top: 0, width: 1, height: 1 }
        : { left, top, width: right - left + 1, height: bottom - top + 1 };
}

function rows(pixels: Uint8Array, full: number, { left, top, width, height }: Part): Buffer {
    const out = Buffer.alloc((width + 1) * height); // each row begins with its filter: none
    for (let y = 0; y < height; ++y) {
        const start = (top + y) * full + left;
        out.set(pixels.subarray(start, start + width), y * (width + 1) + 1);
    }
    return deflateSync(out, { level: 9 });
}

/** @param lastSeconds  how long the last frame stays before the film begins again */
export function animatedPng(frames: readonly Frame[], framesPerSecond: number, lastSeconds = 1.5): Buffer {
    const { width, height } = frames[0]!;
    const palette = paletteOf(frames);
    const known = new Map<number, number>();
    const header = Buffer.concat([words(width, height), Buffer.from([8, 3, 0, 0, 0])]);
    const out = [
        Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]),
        chunk('IHDR', header),
        chunk('acTL', words(frames.length, 0)),
        chunk('PLTE', Buffer.from(palette.flat())),
    ];
    let [sequence, before]: [number, Uint8Array | undefined] = [0, undefined];
    frames.forEach((frame, i) => {
        const now = indexed(frame, palette, known);
        const part = changed(now, before, frame);
        const delay = Buffer.alloc(6); // numerator and denominator of seconds; leave what is there; put over it
        delay.writeUInt16BE(i + 1 === frames.length ? Math.round(1000 * lastSeconds) : Math.round(1000 / framesPerSecond), 0);
        delay.writeUInt16BE(1000, 2);
        out.push(chunk('fcTL', Buffer.concat([words(sequence++, part.width, part.height, part.left, part.top), delay])));
        const data = rows(now, width, part);
        out.push(before === undefined ? chunk('IDAT', data) : chunk('fdAT', Buffer.concat([words(sequence++), data])));
        before = now;
    });
    return Buffer.concat([...out, chunk('IEND', Buffer.alloc(0))]);
}
