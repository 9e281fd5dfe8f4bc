// Files of a surface: its whole mesh in full precision, and its numbers. The server answers when the surface is final,
// or with the mesh that it shows now.
import { signal } from '@preact/signals-core';
import { faultOf, type OwnServer, requestWords } from '../../connection/ownServer.ts';
import { type MeshFile, meshPath } from './scripts.ts';

export interface DownloadProgress {
    state: 'idle' | 'waiting' | 'failed';
    words: string;
}

export interface DownloadedMesh {
    file: Blob;
    /** It is not the final surface. */
    coarse: boolean;
}

export class MeshDownload {
    readonly progress = signal<DownloadProgress>({ state: 'idle', words: '' });
    private readonly server: Pick<OwnServer, 'fetch'>;
    private current: AbortController | null = null;

    constructor(server: Pick<OwnServer, 'fetch'>) {
        this.server = server;
    }

    /** Null where it was cancelled or failed; why is in `progress`. */
    fetch(session: string, surface: string, file: MeshFile): Promise<DownloadedMesh | null> {
        const words = file.now === true ? 'Waiting for the surface as it is now …' : 'Waiting for the final surface …';
        return this.get(session, surface, meshPath(file), words);
    }

    /** The same of any file below the address of a surface. */
    async get(session: string, surface: string, file: string, words: string): Promise<DownloadedMesh | null> {
        this.current?.abort();
        const current = new AbortController();
        this.current = current;
        this.progress.value = { state: 'waiting', words };
        const [of, id] = [encodeURIComponent(session), encodeURIComponent(surface)];
        try {
            const path = `api/v1/sessions/${of}/surfaces/${id}/${file}`;
            const reply = await this.server.fetch(path, { signal: current.signal });
            if (!reply.ok) throw await faultOf(reply);
            const mesh = await reply.blob();
            this.progress.value = { state: 'idle', words: '' };
            return { file: mesh, coarse: (reply.headers.get('content-disposition') ?? '').includes('-coarse.') };
        } catch (error) {
            if (this.current === current) this.failed(error, current.signal.aborted);
            return null;
        } finally {
            if (this.current === current) this.current = null;
        }
    }

    /** The numbers as CSV, or why there are none. @param query  as numbers.csv takes it */
    async numbers(
        session: string,
        surface: string,
        query: Readonly<Record<string, string>>,
        signal?: AbortSignal,
    ): Promise<{ text: string | null; fault: string }> {
        const [of, id] = [encodeURIComponent(session), encodeURIComponent(surface)];
        try {
            const path = `api/v1/sessions/${of}/surfaces/${id}/numbers.csv?${new URLSearchParams(query).toString()}`;
            const reply = await this.server.fetch(path, signal === undefined ? {} : { signal });
            if (!reply.ok) throw await faultOf(reply);
            return { text: await reply.text(), fault: '' };
        } catch (error) {
            return { text: null, fault: requestWords(error) };
        }
    }

    cancel(): void {
        this.current?.abort();
    }

    private failed(error: unknown, cancelled: boolean): void {
        this.progress.value = cancelled ? { state: 'idle', words: '' } : { state: 'failed', words: requestWords(error) };
    }
}
