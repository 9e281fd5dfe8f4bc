// How this page looks at the session: not shared with others but by a link, a bookmark or following. Written by ui/ and
// session/, read by both.
import { signal } from '@preact/signals-core';

/** What a click on the picture does. */
export type Tool = 'none' | 'place' | 'probe' | 'measure' | 'annotate' | 'paint';

export type Theme = 'system' | 'dark' | 'light';

export class ViewState {
    readonly tool = signal<Tool>('none');
    readonly theme = signal<Theme>('system');
    readonly orthographic = signal(false);
    /** Where the tour is; null: there is none. */
    readonly tourStep = signal<number | null>(null);
    /** The participant whose view this page takes. */
    readonly following = signal<string | null>(null);
}
