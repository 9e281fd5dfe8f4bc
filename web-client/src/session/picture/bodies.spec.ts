import { expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { settled } from '../../testing/fakes.ts';
import { datasetOf } from '../../testing/records.ts';
import { Bodies } from './bodies.ts';

it('a body that could not be had leaves a newer request for it alone', async () => {
    const asked: { resolve: (mesh: null) => void; reject: (error: Error) => void }[] = [];
    const worker = { obstacle: () => new Promise<null>((resolve, reject) => asked.push({ resolve, reject })) };
    const bodies = new Bodies(new AppState(), worker);
    bodies.of(datasetOf(), false).catch(() => undefined);
    const newer = bodies.of(datasetOf(), true);
    asked[0]!.reject(new Error('gone'));
    await settled();
    expect(bodies.of(datasetOf(), true)).toBe(newer);
    expect(asked).toHaveLength(2);
});
