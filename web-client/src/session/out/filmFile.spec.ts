import { ALL_FORMATS, BlobSource, EncodedPacketSink, Input } from 'mediabunny';
import { describe, expect, it } from 'vitest';
import { type EncodedFrame, filmFile } from './filmFile.ts';

const fps = 24;
const frames: EncodedFrame[] = Array.from({ length: 130 }, (_, i) => ({
    data: Uint8Array.from({ length: 10 + ((i * 37) % 500) }, (_each, k) => (i + k) & 0xff),
    time: i / fps,
    duration: 1 / fps,
    key: i % 48 === 0,
}));

async function written() {
    const blob = await filmFile({ format: 'webm', codec: 'vp9', codecString: 'vp09.00.41.08', width: 640, height: 360, frames });
    const input = new Input({ source: new BlobSource(blob), formats: ALL_FORMATS });
    const track = (await input.getPrimaryVideoTrack())!;
    return { blob, input, track };
}

describe('a WebM file', () => {
    it('has every frame with its bytes, at its time in whole milliseconds', async () => {
        const { track } = await written();
        const found = [];
        for await (const { data, timestamp, type } of new EncodedPacketSink(track).packets()) {
            found.push({ data, time: Math.round(1e6 * timestamp), key: type === 'key' });
        }
        expect(found).toEqual(frames.map(({ data, time, key }) => ({ data, time: 1000 * Math.round(1000 * time), key })));
    });

    it('says what it is, how large and how long', async () => {
        const { blob, input, track } = await written();
        expect([blob.type, await input.getMimeType()]).toEqual(['video/webm', expect.stringMatching(/^video\/webm/)]);
        expect([track.codec, track.codedWidth, track.codedHeight]).toEqual(['vp9', 640, 360]);
        expect(Math.abs((await input.getDurationFromMetadata())! - frames.length / fps)).toBeLessThan(0.001);
    });

    it('has the recipes of its surfaces as they are, and plays as without them', async () => {
        const recipes = ['wakesurf-recipe:abc=.', 'wakesurf-recipe:def.'];
        const film = { format: 'webm', codec: 'vp9', codecString: 'vp09.00.41.08', width: 640, height: 360, frames } as const;
        const blob = await filmFile({ ...film, recipes });
        expect(await blob.text()).toContain(recipes.join('\n'));
        const input = new Input({ source: new BlobSource(blob), formats: ALL_FORMATS });
        expect((await input.getMetadataTags()).comment).toBe(recipes.join('\n'));
        const sink = new EncodedPacketSink((await input.getPrimaryVideoTrack())!);
        expect((await sink.getKeyPacket(2.5, { verifyKeyPackets: true }))?.timestamp).toBe(2);
    });

    it('tells players where the key frames are', async () => {
        const { track } = await written();
        const sink = new EncodedPacketSink(track);
        for (const second of [0, 1.9, 2, 3.9, 5.4]) {
            expect((await sink.getKeyPacket(second, { verifyKeyPackets: true }))?.timestamp).toBe(2 * Math.floor(second / 2));
        }
    });
});

describe('an MP4 file', () => {
    // What an encoder says of H.264 at High profile, level 4: no more than the header of an empty list.
    const description = Uint8Array.of(1, 0x64, 0, 0x28, 0xff, 0xe0, 0);

    it('has every frame with its bytes at its time, its size, and the recipes', async () => {
        const film = { format: 'mp4', codec: 'avc', codecString: 'avc1.640028', width: 640, height: 360 } as const;
        const blob = await filmFile({ ...film, description, frames, recipes: ['wakesurf-recipe:abc=.'] });
        expect(blob.type).toBe('video/mp4');
        const input = new Input({ source: new BlobSource(blob), formats: ALL_FORMATS });
        const track = (await input.getPrimaryVideoTrack())!;
        expect([track.codec, track.codedWidth, track.codedHeight]).toEqual(['avc', 640, 360]);
        const found = [];
        for await (const { data, timestamp, type } of new EncodedPacketSink(track).packets()) {
            found.push({ data, time: Math.round(1000 * timestamp), key: type === 'key' });
        }
        expect(found).toEqual(frames.map(({ data, time, key }) => ({ data, time: Math.round(1000 * time), key })));
        expect((await input.getMetadataTags()).comment).toBe('wakesurf-recipe:abc=.');
    });
});
