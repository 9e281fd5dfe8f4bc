// A session that this page has just filled plays its first surface once, from the release to the end: it shows what moves before anyone
// knows where to press. Whoever presses anything first, or wants less motion, does not see it.
import { effect, untracked } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { Playback } from './playback.ts';

export interface FirstPlay {
    state: Pick<AppState, 'phase'>;
    playback: Pick<Playback, 'mode' | 'play' | 'setLoop'>;
}

const presses = ['pointerdown', 'keydown', 'wheel'] as const;

/** Once the surface is final. A stream surface does not move. */
export function playOnce({ state, playback }: FirstPlay): void {
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) return;
    const over = (): void => {
        stop();
        for (const press of presses) removeEventListener(press, over, true);
    };
    const stop = effect(() => {
        if (state.phase.value !== 'final' || playback.mode.value !== 'clock') return;
        queueMicrotask(over);
        untracked(() => {
            void playback.setLoop(false);
            void playback.play();
        });
    });
    for (const press of presses) addEventListener(press, over, true);
}
