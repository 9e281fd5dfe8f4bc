// A WebM file of one track of pictures, from encoded frames. Twin: none; https://www.webmproject.org/docs/container and RFC 8794
// (EBML). Written by hand because the libraries for it weigh as much as a fifth of this page.

export interface EncodedFrame {
    data: Uint8Array;
    /** Milliseconds, whole. */
    time: number;
    key: boolean;
}

export interface Film {
    codec: 'V_VP8' | 'V_VP9';
    width: number;
    height: number;
    /** Milliseconds. */
    duration: number;
    frames: readonly EncodedFrame[];
}

type Part = Uint8Array<ArrayBuffer>;

/** Frames are in order of time; the first is a key frame. */
export function webmFile(film: Film): Blob {
    const clusters = clustersOf(film.frames);
    const before = [info(film), tracks(film)];
    const start = sizeOf(before) + cuesSize(clusters.length);
    let at = start;
    const cuePoints = clusters.map(({ time, parts }) => {
        const point = cuePoint(time, at);
        at += sizeOf(parts);
        return point;
    });
    const body = [...before, ...element(ids.cues, cuePoints), ...clusters.flatMap(({ parts }) => parts)];
    return new Blob([...head(), ...element(ids.segment, body)], { type: 'video/webm' });
}

const ids = {
    ...{ ebml: 0x1a45dfa3, version: 0x4286, readVersion: 0x42f7, maxIdLength: 0x42f2, maxSizeLength: 0x42f3 },
    ...{ docType: 0x4282, docTypeVersion: 0x4287, docTypeReadVersion: 0x4285, segment: 0x18538067 },
    ...{ info: 0x1549a966, timestampScale: 0x2ad7b1, duration: 0x4489, muxingApp: 0x4d80, writingApp: 0x5741 },
    ...{ tracks: 0x1654ae6b, trackEntry: 0xae, trackNumber: 0xd7, trackUid: 0x73c5, trackType: 0x83 },
    ...{ lacing: 0x9c, codecId: 0x86, video: 0xe0, pixelWidth: 0xb0, pixelHeight: 0xba },
    ...{
        cues: 0x1c53bb6b,
        cuePoint: 0xbb,
        cueTime: 0xb3,
        cueTrackPositions: 0xb7,
        cueTrack: 0xf7,
        cuePosition: 0xf1,
    },
    ...{ cluster: 0x1f43b675, timestamp: 0xe7, simpleBlock: 0xa3 },
};
const videoTrack = 1;
/** A block says its time in 16 bits, counted from its cluster's. */
const longestCluster = 30_000;

function head(): Part[] {
    return element(ids.ebml, [
        ...[whole(ids.version, 1), whole(ids.readVersion, 1), whole(ids.maxIdLength, 4), whole(ids.maxSizeLength, 8)],
        ...[text(ids.docType, 'webm'), whole(ids.docTypeVersion, 4), whole(ids.docTypeReadVersion, 2)],
    ]);
}

function info({ duration }: Film): Part {
    const nanosecondsPerTick = 1_000_000;
    return join(
        element(ids.info, [
            whole(ids.timestampScale, nanosecondsPerTick),
            join(element(ids.duration, [float(duration)])),
            text(ids.muxingApp, 'wakesurf'),
            text(ids.writingApp, 'wakesurf'),
        ]),
    );
}

function tracks({ codec, width, height }: Film): Part {
    const video = join(element(ids.video, [whole(ids.pixelWidth, width), whole(ids.pixelHeight, height)]));
    const entry = [
        ...[whole(ids.trackNumber, videoTrack), whole(ids.trackUid, 1), whole(ids.trackType, 1), whole(ids.lacing, 0)],
        ...[text(ids.codecId, codec), video],
    ];
    return join(element(ids.tracks, element(ids.trackEntry, entry)));
}

interface Cluster {
    time: number;
    parts: Part[];
}

/** One for each key frame, where a player may jump to. */
function clustersOf(frames: readonly EncodedFrame[]): Cluster[] {
    const groups: EncodedFrame[][] = [];
    for (const frame of frames) {
        const group = groups.at(-1);
        if (group === undefined || frame.key || frame.time - group[0]!.time > longestCluster) groups.push([frame]);
        else group.push(frame);
    }
    return groups.map((group) => {
        const { time } = group[0]!;
        const blocks = group.flatMap((frame) => block(frame, frame.time - time));
        return { time, parts: element(ids.cluster, [whole(ids.timestamp, time), ...blocks]) };
    });
}

function block({ data, key }: EncodedFrame, time: number): Part[] {
    const header = new Uint8Array([0x80 | videoTrack, time >> 8, time & 0xff, key ? 0x80 : 0]);
    return element(ids.simpleBlock, [header, new Uint8Array(data)]);
}

/** The same size for any place, so that places can be counted before they are written. */
function cuePoint(time: number, at: number): Part {
    const positions = [whole(ids.cueTrack, videoTrack), whole(ids.cuePosition, at, 8)];
    return join(element(ids.cuePoint, [whole(ids.cueTime, time, 8), ...element(ids.cueTrackPositions, positions)]));
}

function cuesSize(count: number): number {
    return sizeOf(
        element(
            ids.cues,
            Array.from({ length: count }, () => cuePoint(0, 0)),
        ),
    );
}

function element(id: number, body: readonly Part[]): Part[] {
    return [new Uint8Array([...bigEndian(id), ...sizeCode(sizeOf(body))]), ...body];
}

/** Always eight bytes: 01 and seven of the size. */
function sizeCode(size: number): number[] {
    return [1, ...bigEndian(size, 7)];
}

function whole(id: number, value: number, width?: number): Part {
    return join(element(id, [new Uint8Array(bigEndian(value, width))]));
}

function text(id: number, value: string): Part {
    return join(element(id, [new TextEncoder().encode(value)]));
}

function float(value: number): Part {
    const bytes = new Uint8Array(8);
    new DataView(bytes.buffer).setFloat64(0, value);
    return bytes;
}

function bigEndian(value: number, width?: number): number[] {
    const bytes: number[] = [];
    for (let rest = value; rest > 0; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
    while (bytes.length < (width ?? 1)) bytes.unshift(0);
    return bytes;
}

function sizeOf(parts: readonly Part[]): number {
    return parts.reduce((sum, part) => sum + part.length, 0);
}

function join(parts: readonly Part[]): Part {
    const joined = new Uint8Array(sizeOf(parts));
    let at = 0;
    for (const part of parts) {
        joined.set(part, at);
        at += part.length;
    }
    return joined;
}
