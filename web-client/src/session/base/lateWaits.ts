// Answers that are long in coming: whoever waits is told after 10 s, and may have them asked for again.
import type { Announcements } from '../../state/announcements.ts';

/** Whoever waits longer is told. */
export const lateMs = 10_000;

/** @param late told once it takes long, and then once that is over */
export async function toldLate<T>(answer: Promise<T>, late: (isLate: boolean) => void): Promise<T> {
    let isLate = false;
    const timer = setTimeout(() => late((isLate = true)), lateMs);
    try {
        return await answer;
    } finally {
        clearTimeout(timer);
        if (isLate) late(false);
    }
}

export class LateWaits {
    private readonly told: (late: boolean) => void;
    private readonly late = new Set<AbortController>();

    /** @param told whether one is late, whenever that has changed */
    constructor(told: (late: boolean) => void) {
        this.told = told;
    }

    /** @param ask may leave its signal alone: what comes after it is of no use. @param ended it is not wanted any more */
    async until<T>(ask: (signal: AbortSignal) => Promise<T>, ended?: AbortSignal): Promise<T> {
        for (;;) {
            const wait = new AbortController();
            const { signal } = wait;
            const givenUp = new Promise<never>((_, reject) => {
                signal.addEventListener('abort', () => reject(new DOMException('Given up', 'AbortError')));
            });
            if (ended?.aborted === true) wait.abort();
            ended?.addEventListener('abort', () => wait.abort(), { once: true });
            const isOver = (): boolean => !signal.aborted || ended?.aborted === true;
            try {
                const answer = await toldLate(Promise.race([ask(signal), givenUp]), (isLate) => this.tell(wait, isLate));
                if (isOver()) return answer;
            } catch (error) {
                if (isOver()) throw error;
            }
        }
    }

    /** What is late is not waited for any more. */
    again(): void {
        for (const wait of [...this.late]) wait.abort();
    }

    private tell(wait: AbortController, isLate: boolean): void {
        const before = this.late.size > 0;
        if (isLate) this.late.add(wait);
        else this.late.delete(wait);
        if (before !== this.late.size > 0) this.told(isLate);
    }
}

/** Says it over the picture, with a button. @param what the server has not sent */
export function waitsSaid(notices: Announcements, what: string): LateWaits {
    const about = `late: ${what}`;
    const waits: LateWaits = new LateWaits((late) => {
        const remedy = { label: 'Ask again', act: () => waits.again() };
        if (late) notices.say(about, `The server has not sent ${what} for more than 10 s.`, remedy);
        else notices.solved(about);
    });
    return waits;
}
