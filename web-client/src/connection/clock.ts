// Time and chance as the connection sees them; injected, so that tests can run hours in no time.

export type Timer = number;

export interface Clock {
    /** Milliseconds that never go backwards. */
    now(): number;
    after(delayMs: number, action: () => void): Timer;
    cancel(timer: Timer): void;
    /** Uniform in 0..1. */
    random(): number;
}

export const systemClock: Clock = {
    now: () => performance.now(),
    after: (delayMs, action) => setTimeout(action, delayMs) as unknown as Timer,
    cancel: (timer) => clearTimeout(timer),
    random: () => Math.random(),
};
