// The small picture of the session that lists show: sent now and then by who edited last, once everything has
// come to rest. Taken from a picture that is drawn for it in one go and is the same as the one on the screen;
// encoding it holds nothing up.
import { effect } from '@preact/signals-core';
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError, type WorkerClient } from '../../worker/workerClient.ts';
import type { UndoHistory } from '../edits/undoHistory.ts';

/** After the last edit: who still thinks about the next one is not disturbed. */
export const restMs = 4000;
export const leastBetweenMs = 30_000;
/** Looked again whether the surface is final. */
const retryAfterMs = 1000;
/** Patches reach the page that caused them before or after their answer. */
const echoMs = 1000;
const thumbnailSize = { width: 320, height: 200 };
/** The largest picture that the server keeps, in bytes. */
export const maxBytes = 24 << 10;
const qualities = [0.85, 0.7, 0.5, 0.3];
/** So the server does not know the method, or does not want one from here. */
const hopeless: ReadonlySet<number> = new Set([errorCodes.methodNotFound, errorCodes.notPermitted]);

/** Encodes a canvas. */
export type Encode = (picture: HTMLCanvasElement, quality: number) => Promise<Blob | null>;

export interface ThumbnailsOptions {
    state: Pick<AppState, 'stage' | 'phase' | 'locked' | 'editsPending' | 'session'>;
    worker: Pick<WorkerClient, 'call'>;
    edits: { history: Pick<UndoHistory, 'taken'> };
    /** Returns the picture as small as asked; null where it would take long. */
    picture: (size: { width: number; height: number }) => HTMLCanvasElement | null;
    /** A handle or the camera is held, or no user sees the page. */
    busy: () => boolean;
    encode?: Encode;
    now?: () => number;
}

export class Thumbnails {
    private readonly options: ThumbnailsOptions;
    private readonly encode: Encode;
    private readonly now: () => number;
    private timer: ReturnType<typeof setTimeout> | null = null;
    /** When this page's user, and when any user, edited last. */
    private own = Number.NEGATIVE_INFINITY;
    private any = Number.NEGATIVE_INFINITY;
    private sent = Number.NEGATIVE_INFINITY;
    private unwanted = false;

    constructor(options: ThumbnailsOptions) {
        this.options = options;
        this.encode = options.encode ?? asJpeg;
        this.now = options.now ?? (() => performance.now());
        let first = true;
        effect(() => {
            void options.edits.history.taken.value;
            if (!first) this.edited();
            first = false;
        });
    }

    /** A user has changed records. */
    patched(): void {
        this.any = this.now();
    }

    private edited(): void {
        this.own = this.now();
        this.wait(Math.max(restMs, this.sent + leastBetweenMs - this.own));
    }

    private wait(ms: number): void {
        if (this.timer !== null) clearTimeout(this.timer);
        this.timer = this.unwanted ? null : setTimeout(() => this.due(), ms);
    }

    private due(): void {
        this.timer = null;
        const { state, busy } = this.options;
        // Another user's page has the newer picture.
        if (this.any > this.own + echoMs || state.locked.value) return;
        const resting = this.now() - this.own >= restMs;
        if (resting && state.phase.value === 'final' && !state.editsPending.value && !busy()) void this.send();
        else this.wait(retryAfterMs);
    }

    private async send(): Promise<void> {
        const { worker, picture, state } = this.options;
        const session = state.session.value;
        const drawn = picture(thumbnailSize);
        if (drawn === null || session === null) return;
        this.sent = this.now();
        try {
            const image = await this.encoded(drawn);
            if (image !== null) await worker.call('session.thumbnail', { session, image });
        } catch (error) {
            // A list without a new picture is no reason to disturb any user.
            if (error instanceof CallError && hopeless.has(error.failure.code)) this.unwanted = true;
        }
    }

    /** In base64; null where it cannot be made small enough. */
    private async encoded(picture: HTMLCanvasElement): Promise<string | null> {
        for (const quality of qualities) {
            const blob = await this.encode(picture, quality);
            if (blob === null) return null;
            if (blob.size > maxBytes) continue;
            const bytes = new Uint8Array(await blob.arrayBuffer());
            return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
        }
        return null;
    }
}

function asJpeg(picture: HTMLCanvasElement, quality: number): Promise<Blob | null> {
    return new Promise((resolve) => picture.toBlob(resolve, 'image/jpeg', quality));
}
