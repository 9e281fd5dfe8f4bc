import { signal } from '@preact/signals-core';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import type { SurfacePhase } from '../../state/appState.ts';
import { playOnce } from './firstPlay.ts';
import type { PlaybackMode } from './playback.ts';

let asked: string[];
let lessMotion: boolean;
const page = new EventTarget();

beforeEach(() => {
    [asked, lessMotion] = [[], false];
    vi.stubGlobal('matchMedia', () => ({ matches: lessMotion }));
    vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
    vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page));
});
afterEach(() => {
    vi.unstubAllGlobals();
});

/** Of a surface that is being computed. */
function armed(mode: PlaybackMode = 'clock') {
    const phase = signal<SurfacePhase>('updating');
    const playback = {
        mode: signal(mode),
        setLoop: async (loop: boolean) => void asked.push(loop ? 'loop' : 'once'),
        play: async () => void asked.push('play'),
    };
    playOnce({ state: { phase }, playback });
    return phase;
}

it('what moves plays when it is final, once', async () => {
    const phase = armed();
    expect(asked).toEqual([]);
    phase.value = 'final';
    expect(asked).toEqual(['once', 'play']);
    await Promise.resolve();
    phase.value = 'updating';
    phase.value = 'final';
    expect(asked).toEqual(['once', 'play']);
});

it('nothing plays after a press, where less motion is wanted, or where nothing moves', () => {
    const pressed = armed();
    page.dispatchEvent(new Event('pointerdown'));
    pressed.value = 'final';
    armed('frozen').value = 'final';
    lessMotion = true;
    armed().value = 'final';
    expect(asked).toEqual([]);
});
