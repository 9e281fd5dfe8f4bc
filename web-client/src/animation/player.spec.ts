import { describe, expect, it } from 'vitest';
import { Player } from './player.ts';

function bench(count: number, decodeMs = 1) {
    const now = { ms: 0 };
    const shown: number[] = [];
    const away: number[] = [];
    const playing: boolean[] = [];
    const steps = {
        count,
        current: -1,
        awayFrom: (step: number) => step - steps.current,
        approach: (step: number) => {
            now.ms += decodeMs;
            steps.current = step < steps.current ? 0 : Math.min(step, steps.current + 1);
            return steps.current === step;
        },
    };
    const player = new Player({
        steps,
        now: () => now.ms,
        onStep: (step) => shown.push(step),
        onAway: (left) => away.push(left),
        onPlaying: (on) => playing.push(on),
    });
    const frames = (many: number): void => {
        for (let i = 0; i < many; ++i) {
            player.frame();
            now.ms += 16;
        }
    };
    return { player, frames, shown, away, playing };
}

describe('a player', () => {
    it('shows every step once and stops at the last', () => {
        const { player, frames, shown, playing } = bench(5);
        player.play();
        frames(200);
        expect(shown).toEqual([0, 1, 2, 3, 4]);
        expect(playing).toEqual([true, false]);
    });

    it('plays once more from the first step after the last', () => {
        const { player, frames, shown } = bench(3);
        player.goTo(2);
        frames(5);
        player.play();
        frames(200);
        expect(shown).toEqual([2, 0, 1, 2]);
    });

    it('stays where it is while it is paused', () => {
        const { player, frames, shown } = bench(50);
        player.play();
        frames(60);
        player.pause();
        const before = [...shown];
        frames(100);
        expect(shown).toEqual(before);
        expect(before.length).toBeGreaterThan(1);
    });

    it('says how far a distant step is and shows none before it', () => {
        const { player, frames, shown, away } = bench(100, 5);
        player.goTo(99);
        frames(100);
        expect(shown).toEqual([99]);
        expect(away.length).toBeGreaterThan(10);
        expect(away.slice(0, -1).every((left, i) => i === 0 || left < away[i - 1]!)).toBe(true);
        expect(away.at(-1)).toBe(0);
    });

    it('keeps to the steps that there are', () => {
        const { player, frames, shown } = bench(4);
        player.goTo(17);
        frames(3);
        player.goTo(-2);
        frames(3);
        expect(shown).toEqual([3, 0]);
    });
});
