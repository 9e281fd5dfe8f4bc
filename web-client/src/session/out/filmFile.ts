// A file of one track of pictures, from encoded frames: WebM, or MP4, which slides and phones play.
import {
    BufferTarget,
    EncodedPacket,
    EncodedVideoPacketSource,
    Mp4OutputFormat,
    Output,
    type VideoCodec,
    WebMOutputFormat,
} from 'mediabunny';

export interface EncodedFrame {
    data: Uint8Array;
    /** Seconds. */
    time: number;
    duration: number;
    key: boolean;
}

export type FilmFormat = 'webm' | 'mp4';

export interface Film {
    format: FilmFormat;
    codec: Extract<VideoCodec, 'vp8' | 'vp9' | 'avc'>;
    /** The codec's name with its level, as the encoder was configured. */
    codecString: string;
    /** What the encoder says of its frames, without which those of H.264 cannot be read. */
    description?: AllowSharedBufferSource | undefined;
    width: number;
    height: number;
    frames: readonly EncodedFrame[];
    /** Of the surfaces in it: a comment in the file. */
    recipes?: readonly string[];
}

/** Frames are in order of time; the first is a key frame. */
export async function filmFile({ format, codec, codecString, description, frames, recipes = [], ...size }: Film): Promise<Blob> {
    const written = format === 'mp4' ? new Mp4OutputFormat() : new WebMOutputFormat();
    const output = new Output({ format: written, target: new BufferTarget() });
    const track = new EncodedVideoPacketSource(codec);
    output.addVideoTrack(track);
    if (recipes.length > 0) output.setMetadataTags({ comment: recipes.join('\n') });
    await output.start();
    const decoderConfig = {
        ...{ codec: codecString, codedWidth: size.width, codedHeight: size.height },
        ...(description === undefined ? {} : { description }),
    };
    for (const { data, time, duration, key } of frames) {
        await track.add(new EncodedPacket(data, key ? 'key' : 'delta', time, duration), { decoderConfig });
    }
    await output.finalize();
    return new Blob([output.target.buffer!], { type: `video/${format}` });
}
