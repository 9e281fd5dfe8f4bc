import { describe, expect, it } from 'vitest';
import { AppState } from '../../state/appState.ts';
import { announceLostGraphics } from './drawingSettings.ts';

describe('graphics that are lost', () => {
    it('are said to be, with a way out, until they are back', () => {
        const [state, canvas] = [new AppState(), new EventTarget()];
        let reloads = 0;
        announceLostGraphics(state, canvas, () => ++reloads);
        canvas.dispatchEvent(new Event('webglcontextlost'));
        expect(state.notices.all.value.get('graphics')).toContain('comes back by itself');
        state.notices.remedyOf('graphics')?.act();
        expect(reloads).toBe(1);
        canvas.dispatchEvent(new Event('webglcontextrestored'));
        expect(state.notices.all.value.size).toBe(0);
    });
});
