import { afterEach, describe, expect, it, vi } from 'vitest';
import { VideoEncoding } from './videoEncoding.ts';

/** An encoder that takes pictures and returns nothing, until it fails. */
class StuckEncoder extends EventTarget {
    static last: StuckEncoder;
    static isConfigSupported = () => Promise.resolve({ supported: true });
    encodeQueueSize = 0;
    state = 'configured';
    configure = (): void => undefined;
    private readonly told: (error: Error) => void;

    constructor({ error }: { error: (error: Error) => void }) {
        super();
        this.told = error;
        StuckEncoder.last = this;
    }

    encode(): void {
        if (this.state === 'closed') throw new Error('closed');
        ++this.encodeQueueSize;
    }

    fail(words: string): void {
        this.state = 'closed';
        this.told(new Error(words));
    }
}

class Picture {
    close = (): void => undefined;
}

async function begun(): Promise<VideoEncoding> {
    vi.stubGlobal('VideoEncoder', StuckEncoder);
    vi.stubGlobal('VideoFrame', Picture);
    return (await VideoEncoding.begin({ format: 'webm', width: 64, height: 48, fps: 25 }))!;
}

describe('an encoder that fails', () => {
    const picture = {} as HTMLCanvasElement;
    afterEach(() => vi.unstubAllGlobals());

    it('ends the film that waits for it, with its own words', async () => {
        const encoding = await begun();
        for (let i = 0; i < 3; ++i) await encoding.add(picture);
        const waiting = encoding.add(picture);
        StuckEncoder.last.fail('out of memory');
        await expect(waiting).rejects.toThrow('out of memory');
        await expect(encoding.add(picture)).rejects.toThrow('out of memory');
        await expect(encoding.finish()).rejects.toThrow('out of memory');
    });

    it('is noticed also where the browser only closed it', async () => {
        const encoding = await begun();
        StuckEncoder.last.state = 'closed';
        await expect(encoding.add(picture)).rejects.toThrow('has stopped');
    });
});
