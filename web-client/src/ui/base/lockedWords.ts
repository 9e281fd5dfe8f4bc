// Why a control cannot be used: what is disabled says so to who points at it.
import type { AppState } from '../../state/appState.ts';

/** Empty: nothing is in the way. */
export function lockedWords({ locked, role }: Pick<AppState, 'locked' | 'role'>): string {
    if (!locked.value) return '';
    return role.value === 'viewer'
        ? 'Your link is for looking: only people who can edit may do this'
        : 'Not connected to the server';
}

/** Returns what a control does, or why it cannot. */
export function titleOf(state: Pick<AppState, 'locked' | 'role'>, words: string): string {
    const why = lockedWords(state);
    return why === '' ? words : `${words} (${why})`;
}
