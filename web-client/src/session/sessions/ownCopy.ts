// A copy of the session, in which this page's user plays, scrubs and edits without changing what others see;
// and the way back. With a share link the server makes a link of its own into the copy.
import { computed, signal } from '@preact/signals-core';
import type { AppState } from '../../state/appState.ts';
import type { Calls } from '../base/calls.ts';
import { encodeLinkState, openFragment, writeFragment } from '../view/urlState.ts';
import type { Views } from '../view/views.ts';
import { fitting } from './sessionList.ts';

export interface OwnCopyOptions {
    state: Pick<AppState, 'session' | 'sessionName' | 'stage' | 'copyOf'>;
    calls: Pick<Calls, 'try'>;
    views: Pick<Views, 'current'>;
    /** Shows another session; replaced in tests. */
    open?: (fragment: string) => void;
}

export class OwnCopy {
    readonly possible = computed(() => this.options.state.stage.value === 'running' && !this.busy.value);
    private readonly busy = signal(false);
    private readonly options: OwnCopyOptions;
    private readonly open: (fragment: string) => void;

    constructor(options: OwnCopyOptions) {
        this.options = options;
        this.open = options.open ?? openFragment;
    }

    async begin(): Promise<void> {
        if (!this.possible.value) return;
        this.busy.value = true;
        const { calls, state } = this.options;
        const made = await calls.try('session.fork', { name: fitting(state.sessionName.value, ' copy') });
        this.busy.value = false;
        if (made !== null) this.open(this.fragment(made.session) + (made.key === undefined ? '' : `&token=${made.key}`));
    }

    /** To the session that this one was copied from. */
    back(): void {
        const from = this.options.state.copyOf.value;
        if (from !== null) this.open(this.fragment(from.session));
    }

    /** Keeps what is looked at. No records: nothing of the copy is made anew where the other session is empty
     *  by now. */
    private fragment(session: string): string {
        return writeFragment(session, null, encodeLinkState({ view: this.options.views.current() }));
    }
}
