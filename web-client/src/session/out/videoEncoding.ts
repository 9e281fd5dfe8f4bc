// Pictures to a film: the browser's own encoder (WebCodecs), one picture after the other, none left out.
import type { EncodedFrame, Film, FilmFormat } from './filmFile.ts';

const keyEverySeconds = 2;
const maxQueuedFrames = 3;
const bitsPerPixel = 0.18;

/** In the order in which they are tried; VP9's and H.264's end with their level, which bounds the size. */
const codecs: Record<FilmFormat, readonly Pick<Film, 'codec' | 'codecString'>[]> = {
    webm: [
        { codec: 'vp9', codecString: 'vp09.00.41.08' },
        { codec: 'vp9', codecString: 'vp09.00.61.08' },
        { codec: 'vp8', codecString: 'vp8' },
    ],
    mp4: [
        { codec: 'avc', codecString: 'avc1.640028' },
        { codec: 'avc', codecString: 'avc1.640034' },
        { codec: 'avc', codecString: 'avc1.420034' },
    ],
};

export interface VideoSetting {
    format: FilmFormat;
    width: number;
    height: number;
    fps: number;
}

type Codec = (typeof codecs)[FilmFormat][number];

/** Returns whether there is an encoder at all: browsers keep it from pages that come over http from other
 *  machines. */
export function canEncode(): boolean {
    return typeof VideoEncoder === 'function';
}

export class VideoEncoding {
    private readonly setting: VideoSetting;
    private readonly encoder: VideoEncoder;
    private readonly codec: Codec;
    private description: AllowSharedBufferSource | undefined;
    private readonly frames: EncodedFrame[] = [];
    private failure: Error | null = null;
    /** Ends the waiting of `add`; an encoder that has failed takes nothing more out of its queue. */
    private wake: () => void = () => undefined;
    private count = 0;

    private constructor(setting: VideoSetting, config: VideoEncoderConfig, codec: Codec) {
        this.setting = setting;
        this.codec = codec;
        this.encoder = new VideoEncoder({
            output: (chunk, metadata) => this.encoded(chunk, metadata),
            error: (error) => {
                this.failure = error;
                this.wake();
            },
        });
        this.encoder.configure(config);
    }

    /** Null where no encoder takes this size. */
    static async begin(setting: VideoSetting): Promise<VideoEncoding | null> {
        const { format, width, height, fps } = setting;
        const bitrate = Math.round(Math.max(1e6, width * height * fps * bitsPerPixel));
        for (const codec of codecs[format]) {
            const config: VideoEncoderConfig = { codec: codec.codecString, width, height, bitrate, framerate: fps };
            const { supported } = await VideoEncoder.isConfigSupported(config).catch(() => ({ supported: false }));
            if (supported === true) return new VideoEncoding(setting, config, codec);
        }
        return null;
    }

    /** Waits while the encoder has enough to do. */
    async add(picture: HTMLCanvasElement): Promise<void> {
        this.demandRunning();
        const { fps } = this.setting;
        const microseconds = (count: number): number => Math.round((1e6 * count) / fps);
        const frame = new VideoFrame(picture, {
            timestamp: microseconds(this.count),
            duration: microseconds(this.count + 1) - microseconds(this.count),
        });
        this.encoder.encode(frame, { keyFrame: this.count % Math.round(keyEverySeconds * fps) === 0 });
        frame.close();
        ++this.count;
        while (this.running && this.encoder.encodeQueueSize > maxQueuedFrames) {
            await new Promise<void>((resolve) => {
                this.wake = resolve;
                this.encoder.addEventListener('dequeue', () => resolve(), { once: true });
            });
        }
        this.demandRunning();
    }

    /** `recipes`: of all surfaces in it. */
    async finish(recipes: readonly string[] = []): Promise<Blob> {
        this.demandRunning();
        await this.encoder.flush().catch((error: unknown) => {
            throw this.failure ?? error;
        });
        this.demandRunning();
        this.encoder.close();
        const { fps: _, ...setting } = this.setting;
        const { codec, description, frames } = this;
        return (await import('./filmFile.ts')).filmFile({ ...setting, ...codec, description, frames, recipes });
    }

    abandon(): void {
        if (this.encoder.state !== 'closed') this.encoder.close();
    }

    private get running(): boolean {
        return this.failure === null && this.encoder.state !== 'closed';
    }

    private demandRunning(): void {
        if (!this.running) throw this.failure ?? new Error('The video encoder of this browser has stopped. Record again.');
    }

    private encoded(chunk: EncodedVideoChunk, metadata?: EncodedVideoChunkMetadata): void {
        this.description ??= metadata?.decoderConfig?.description;
        const data = new Uint8Array(chunk.byteLength);
        chunk.copyTo(data);
        const [time, duration] = [chunk.timestamp / 1e6, (chunk.duration ?? 0) / 1e6];
        this.frames.push({ data, time, duration, key: chunk.type === 'key' });
    }
}
