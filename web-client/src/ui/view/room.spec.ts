import { signal } from '@preact/signals-core';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { emptyStorage } from '../../testing/fakes.ts';
import { recallPanel, togglePanel } from './room.ts';

afterEach(() => vi.unstubAllGlobals());

describe('the panel', () => {
    it('is folded at first where another page shows this one in a frame, and stays as it is put', () => {
        emptyStorage('localStorage');
        const view = { panelFolded: signal(false) };
        vi.stubGlobal('self', globalThis);
        vi.stubGlobal('top', globalThis);
        recallPanel(view);
        expect(view.panelFolded.value).toBe(false);
        vi.stubGlobal('top', {});
        recallPanel(view);
        expect(view.panelFolded.value).toBe(true);
        togglePanel(view);
        recallPanel(view);
        expect(view.panelFolded.value).toBe(false);
    });
});
