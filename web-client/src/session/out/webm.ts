// A WebM file of one track of pictures, from encoded frames.
import { BufferTarget, EncodedPacket, EncodedVideoPacketSource, Output, type VideoCodec, WebMOutputFormat } from 'mediabunny';

export interface EncodedFrame {
    data: Uint8Array;
    /** Seconds. */
    time: number;
    duration: number;
    key: boolean;
}

export interface Film {
    codec: Extract<VideoCodec, 'vp8' | 'vp9'>;
    /** The codec's name with its level, as the encoder was configured. */
    codecString: string;
    width: number;
    height: number;
    frames: readonly EncodedFrame[];
    /** Of the surfaces in it: a comment in the file. */
    recipes?: readonly string[];
}

/** Frames are in order of time; the first is a key frame. */
export async function webmFile({ codec, codecString, width, height, frames, recipes = [] }: Film): Promise<Blob> {
    const output = new Output({ format: new WebMOutputFormat(), target: new BufferTarget() });
    const track = new EncodedVideoPacketSource(codec);
    output.addVideoTrack(track);
    if (recipes.length > 0) output.setMetadataTags({ comment: recipes.join('\n') });
    await output.start();
    const decoderConfig = { codec: codecString, codedWidth: width, codedHeight: height };
    for (const { data, time, duration, key } of frames) {
        await track.add(new EncodedPacket(data, key ? 'key' : 'delta', time, duration), { decoderConfig });
    }
    await output.finalize();
    return new Blob([output.target.buffer!], { type: 'video/webm' });
}
