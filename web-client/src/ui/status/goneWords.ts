// Why the page is in no session, and what can be done.
import type { GoneSession } from '../../state/appState.ts';
import { dayWords } from '../base/timeWords.ts';

export function goneWords({ restorableUntil, remembered }: GoneSession): { words: string; next: string } {
    if (restorableUntil !== null) {
        return { words: 'was moved to the trash.', next: `It can be restored until ${dayWords(restorableUntil)}.` };
    }
    return {
        words: 'is not on this server.',
        next: remembered
            ? 'This page remembers its contents and can recreate it as a new session.'
            : 'It was deleted, or the server was started without it. Choose another session.',
    };
}
