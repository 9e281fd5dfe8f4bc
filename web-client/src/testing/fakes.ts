// Stand-ins for what a unit test has not got: a clock on which time passes only when told to, a server that answers by a function, the
// storage of a browser, and the files that a panel hands to its user.
import { vi } from 'vitest';
import type { Clock, Timer } from '../connection/clock.ts';
import type { MethodName, ParamsOf, ResultOf } from '../protocol/messages.ts';

export class FakeClock implements Clock {
    private time = 0;
    private nextTimer = 1;
    private readonly timers = new Map<Timer, { at: number; action: () => void }>();

    now(): number {
        return this.time;
    }

    after(delayMs: number, action: () => void): Timer {
        const timer = this.nextTimer++;
        this.timers.set(timer, { at: this.time + delayMs, action });
        return timer;
    }

    cancel(timer: Timer): void {
        this.timers.delete(timer);
    }

    random(): number {
        return 1;
    }

    /** Lets time pass, timers firing in order, and what they start being settled in between. */
    async pass(milliseconds: number): Promise<void> {
        const end = this.time + milliseconds;
        for (;;) {
            const due = [...this.timers].filter(([, { at }]) => at <= end);
            const [next] = due.sort(([, a], [, b]) => a.at - b.at);
            if (next === undefined) break;
            const [timer, { at, action }] = next;
            this.timers.delete(timer);
            this.time = at;
            action();
            await settled();
        }
        this.time = end;
        await settled();
    }
}

export async function settled(): Promise<void> {
    for (let i = 0; i < 10; ++i) await Promise.resolve();
}

export type Params = Record<string, unknown>;

export interface Answering {
    call: <M extends MethodName>(method: M, params: ParamsOf<M>, signal?: AbortSignal) => Promise<ResultOf<M>>;
}

/** @param answer returns what the server would, or a promise of it; what it throws is the refusal */
export function answering(answer: (method: MethodName, params: Params, signal?: AbortSignal) => unknown): Answering {
    return {
        call: async <M extends MethodName>(method: M, params: ParamsOf<M>, signal?: AbortSignal) =>
            (await answer(method, params as Params, signal)) as ResultOf<M>,
    };
}

class FakeStorage {
    private readonly texts = new Map<string, string>();

    getItem(name: string): string | null {
        return this.texts.get(name) ?? null;
    }

    setItem(name: string, text: string): void {
        this.texts.set(name, text);
    }
}

/** Empty, until the globals are put back. */
export function emptyStorage(...names: ('localStorage' | 'sessionStorage')[]): void {
    for (const name of names) vi.stubGlobal(name, new FakeStorage());
}

/** Until mocks are put back. */
export function savedFiles(): { name: string; content: Blob }[] {
    const saved: { name: string; content: Blob }[] = [];
    let content: Blob;
    vi.spyOn(URL, 'createObjectURL').mockImplementation((blob) => {
        content = blob as Blob;
        return 'blob:saved';
    });
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
        saved.push({ name: this.download, content });
    });
    return saved;
}
