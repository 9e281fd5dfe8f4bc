// A call that takes its time, one at a time: how far it is, in words, and a way to end it.
import { signal } from '@preact/signals-core';

export interface LongCallStatus {
    making: boolean;
    words: string;
}

export class LongCall {
    readonly status = signal<LongCallStatus | null>(null);
    private readonly what: string;
    private calls = 0;
    private under: AbortController | null = null;

    /** @param what  is made, for its tokens */
    constructor(what: string) {
        this.what = what;
    }

    /** From the notification $/progress. */
    progressed(token: string | number, percentage: number): void {
        if (token !== this.token || this.status.value?.making !== true) return;
        this.tell(true, `${Math.round(percentage)} %`);
    }

    cancel(): void {
        this.under?.abort();
    }

    /** Does nothing while one is under way. @param call  returns what is said once it has been answered */
    protected async run(call: (workDoneToken: string, signal: AbortSignal) => Promise<string>): Promise<void> {
        if (this.under !== null) return;
        this.under = new AbortController();
        ++this.calls;
        this.tell(true, '');
        try {
            this.tell(false, await call(this.token, this.under.signal));
        } catch (error) {
            this.tell(false, String((error as Error).message));
        } finally {
            this.under = null;
        }
    }

    private get token(): string {
        return `${this.what} ${this.calls}`;
    }

    private tell(making: boolean, words: string): void {
        this.status.value = { making, words };
    }
}
