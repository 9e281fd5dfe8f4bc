import { beforeEach, describe, expect, it } from 'vitest';
import { Movement, restMs } from './movement.ts';

describe('movement', () => {
    let movement: Movement;

    beforeEach(() => {
        movement = new Movement();
    });

    it('is not what one picture alone shows, but what one shows that follows closely', () => {
        expect(movement.at(0)).toBe(false);
        movement.drawn(1000);
        expect(movement.at(1000 + restMs - 1)).toBe(true);
        expect(movement.at(1000 + restMs)).toBe(false);
    });

    it('begins with the first push, before any picture', () => {
        movement.stir(5000);
        expect(movement.at(5001)).toBe(true);
        expect(movement.at(5000 + restMs)).toBe(false);
    });

    it('is what surfaces do that change more than once a second, and not one change alone', () => {
        movement.surfaceChanged(0);
        expect(movement.at(1)).toBe(false);
        movement.surfaceChanged(900);
        expect(movement.at(901)).toBe(true);
        movement.surfaceChanged(3000);
        expect(movement.at(3001)).toBe(false);
    });

    it('lasts as long as something is held', () => {
        movement.hold(true);
        expect(movement.at(1e6)).toBe(true);
        movement.hold(false);
        expect(movement.at(1e6)).toBe(false);
    });
});
