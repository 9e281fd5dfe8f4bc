// A comparison: beside the page, a second one of a copy of its session, with another dataset, at another time or with settings of its own,
// linked with it. The copy goes with it. Loaded when it is first asked for.
import { batch, type ReadonlySignal, signal } from '@preact/signals-core';
import type { OwnServer } from '../../connection/ownServer.ts';
import type { SessionSnapshot } from '../../protocol/messages.ts';
import type { WorkerClient } from '../../worker/workerClient.ts';
import type { Calls } from '../base/calls.ts';
import { fitting } from '../sessions/sessionList.ts';
import type { UrlState } from '../view/urlState.ts';
import type { Views } from '../view/views.ts';
import type { OtherTime } from '../time/otherTime.ts';
import type { Half } from './half.ts';
import { linkHalves } from './linkHalves.ts';
import { showOtherData } from './otherData.ts';

/** A page beside this one. */
export interface BesideOptions {
    url: UrlState;
    prepare: (snapshot: SessionSnapshot) => Promise<boolean>;
}

export interface Beside extends Half {
    /** Stops it, and gives its graphics back. */
    end: () => void;
    worker: Pick<WorkerClient, 'call'>;
    server: Pick<OwnServer, 'fetch'>;
}

export interface CompareOptions<Page extends Beside> {
    left: Half;
    calls: Pick<Calls, 'try'>;
    views: Pick<Views, 'current'>;
    /** Shows a page beside this one. */
    open: (options: BesideOptions) => Page;
    /** Takes the page away. */
    close: () => void;
}

export class Compare<Page extends Beside> {
    /** Null: nothing is compared. */
    readonly right = signal<Page | null>(null);
    readonly busy = signal(false);
    readonly time = signal<OtherTime>({ kind: 'same' });
    /** The dataset of the right half. */
    readonly dataset = signal('');
    readonly moveTogether = signal(true);
    private readonly options: CompareOptions<Page>;
    private unlink: (() => void) | null = null;
    /** The session of the right half, which goes with it. */
    private copy: string | null = null;

    constructor(options: CompareOptions<Page>) {
        this.options = options;
        addEventListener('pagehide', () => void this.end(true));
    }

    get left(): Half {
        return this.options.left;
    }

    /** @param dataset of the right half; left out: the same */
    async begin(dataset = this.left.state.dataset.value?.dataset ?? ''): Promise<void> {
        if (this.busy.value) return;
        this.busy.value = true;
        await this.end();
        const { calls, open } = this.options;
        const copy = await calls.try('session.fork', { name: fitting(this.left.state.sessionName.value, ' (compared)') });
        try {
            if (copy === null) return;
            const right = open({ url: this.addressOf(copy, dataset), prepare: (snapshot) => this.prepare(snapshot, dataset) });
            this.copy = copy.session;
            batch(() => {
                this.right.value = right;
                this.dataset.value = dataset;
            });
            this.linkOnceThere(right);
        } catch (error) {
            this.left.state.notices.tell('compared', error);
            if (copy !== null) await calls.try('session.delete', { session: copy.session, forever: false });
        } finally {
            this.busy.value = false;
        }
    }

    /** @param leaving the page goes, and with it what would hear of an answer */
    async end(leaving = false): Promise<void> {
        const right = this.right.value;
        if (right === null) return;
        // One that was made again has another name.
        const session = right.state.session.value ?? this.copy;
        this.copy = null;
        this.unlink?.();
        this.unlink = null;
        this.right.value = null;
        this.options.close();
        if (leaving) {
            const body = JSON.stringify({ jsonrpc: '2.0', id: 1, method: 'session.delete', params: { session } });
            const headers = { 'Content-Type': 'application/json' };
            void right.server.fetch('rpc', { method: 'POST', keepalive: true, headers, body }).catch(() => undefined);
        } else if (session !== null) {
            // Who may not permanently delete it leaves it in the trash.
            const remove = (forever: boolean): Promise<unknown> => right.worker.call('session.delete', { session, forever });
            await remove(false)
                .then(() => remove(true))
                .catch(() => undefined);
        }
        right.end();
    }

    private addressOf({ session, key }: { session: string; key?: string | undefined }, dataset: string): UrlState {
        const view = this.options.views.current();
        return {
            token: key ?? null,
            session,
            dataset,
            state: { view, rakes: [], surfaces: [], slices: [], lines: [] },
            beside: true,
        };
    }

    private async prepare(snapshot: SessionSnapshot, dataset: string): Promise<boolean> {
        const right = this.right.value;
        const all = [snapshot.surfaces, snapshot.slices, snapshot.lines].flat();
        const same = dataset === this.left.state.dataset.value?.dataset;
        if (right === null || same || all.every((each) => each.dataset === dataset)) return false;
        const missing = await showOtherData(right.worker, snapshot, dataset);
        if (missing !== null) right.state.notices.say('compared', missing);
        return true;
    }

    /** Once it has the view that it began with, which is that of the left half no more. */
    private linkOnceThere(right: Page): void {
        const { time, moveTogether } = this;
        const stop = right.state.stage.subscribe((stage) => {
            if (stage !== 'running') return;
            queueMicrotask(() => {
                stop();
                if (this.right.value === right) this.unlink ??= linkHalves(this.left, right, { time, moveTogether });
            });
        });
    }
}

/** What a page has of it before it is loaded. */
export interface Comparison<C> {
    loaded: ReadonlySignal<C | null>;
    toggle: () => Promise<void>;
}
