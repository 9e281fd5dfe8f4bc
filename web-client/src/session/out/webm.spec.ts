import { describe, expect, it } from 'vitest';
import { type EncodedFrame, webmFile } from './webm.ts';

interface Element {
    id: number;
    /** Offset of its first byte in the file, and of its content. */
    start: number;
    at: number;
    size: number;
    children: Element[];
}

const masters = new Set([0x1a45dfa3, 0x18538067, 0x1549a966, 0x1654ae6b, 0xae, 0xe0, 0x1c53bb6b, 0xbb, 0xb7, 0x1f43b675]);

/** The twin: elements of EBML (RFC 8794), whatever widths their numbers have. */
function parse(file: DataView, from: number, to: number): Element[] {
    const found: Element[] = [];
    let at = from;
    while (at < to) {
        const idLength = Math.clz32(file.getUint8(at)) - 23;
        let id = 0;
        for (let i = 0; i < idLength; ++i) id = id * 256 + file.getUint8(at + i);
        const sizeAt = at + idLength;
        const sizeLength = Math.clz32(file.getUint8(sizeAt)) - 23;
        let size = file.getUint8(sizeAt) & (0xff >> sizeLength);
        for (let i = 1; i < sizeLength; ++i) size = size * 256 + file.getUint8(sizeAt + i);
        const content = sizeAt + sizeLength;
        const children = masters.has(id) ? parse(file, content, content + size) : [];
        found.push({ id, start: at, at: content, size, children });
        at = content + size;
    }
    expect(at).toBe(to);
    return found;
}

function all(elements: readonly Element[], id: number): Element[] {
    return elements.flatMap((each) => [...(each.id === id ? [each] : []), ...all(each.children, id)]);
}

function whole(file: DataView, { at, size }: Element): number {
    let value = 0;
    for (let i = 0; i < size; ++i) value = value * 256 + file.getUint8(at + i);
    return value;
}

const frames: EncodedFrame[] = Array.from({ length: 130 }, (_, i) => ({
    data: Uint8Array.from({ length: 1 + ((i * 37) % 500) }, (_each, k) => (i + k) & 0xff),
    time: Math.round((i * 1000) / 25),
    key: i % 50 === 0,
}));

async function written(): Promise<{ file: DataView; elements: Element[] }> {
    const blob = webmFile({ codec: 'V_VP9', width: 640, height: 360, duration: 5200, frames });
    const file = new DataView(await blob.arrayBuffer());
    return { file, elements: parse(file, 0, file.byteLength) };
}

describe('a WebM file', () => {
    it('has every frame with its bytes, at its time', async () => {
        const { file, elements } = await written();
        const found = all(elements, 0x1f43b675).flatMap((cluster) => {
            const time = whole(file, all(cluster.children, 0xe7)[0]!);
            return all(cluster.children, 0xa3).map(({ at, size }) => ({
                data: new Uint8Array(file.buffer, at + 4, size - 4),
                time: time + file.getInt16(at + 1),
                key: (file.getUint8(at + 3) & 0x80) !== 0,
            }));
        });
        expect(found).toEqual(frames);
    });

    it('says what it is, how large and how long', async () => {
        const { file, elements } = await written();
        const number = (id: number): number => whole(file, all(elements, id)[0]!);
        expect([number(0xb0), number(0xba), number(0x2ad7b1)]).toEqual([640, 360, 1_000_000]);
        expect(file.getFloat64(all(elements, 0x4489)[0]!.at)).toBe(5200);
        const codec = all(elements, 0x86)[0]!;
        expect(new TextDecoder().decode(new Uint8Array(file.buffer, codec.at, codec.size))).toBe('V_VP9');
    });

    it('tells players where the key frames are', async () => {
        const { file, elements } = await written();
        const segment = all(elements, 0x18538067)[0]!;
        const clusters = all(elements, 0x1f43b675);
        const cues = all(elements, 0xbb).map((point) => ({
            time: whole(file, all(point.children, 0xb3)[0]!),
            start: segment.at + whole(file, all(point.children, 0xf1)[0]!),
        }));
        expect(cues).toEqual(clusters.map(({ start }, i) => ({ time: i * 2000, start })));
    });

    it('begins a new cluster before the times in it become too long', async () => {
        const long = Array.from({ length: 100 }, (_, i) => ({
            data: new Uint8Array(1),
            time: i * 1000,
            key: i === 0,
        }));
        const blob = webmFile({ codec: 'V_VP8', width: 16, height: 16, duration: 100_000, frames: long });
        const file = new DataView(await blob.arrayBuffer());
        const blocks = all(parse(file, 0, file.byteLength), 0xa3);
        expect(blocks).toHaveLength(100);
        for (const { at } of blocks) expect(file.getInt16(at + 1)).toBeGreaterThanOrEqual(0);
    });
});
