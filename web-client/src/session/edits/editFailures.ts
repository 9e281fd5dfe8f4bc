// Handles an edit that the server does not take: words for the user. It goes back to what every user sees.
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError } from '../../worker/workerClient.ts';
import { tellUnlessCut } from '../base/lostConnection.ts';

const { leased } = errorCodes;

/** Returns what the server has said against an edit; null: it has not answered. */
export function refusalWords(error: unknown): string | null {
    return error instanceof CallError && error.failure.kind === 'rpc' ? error.failure.message : null;
}

/** @param about what was edited */
export function tellFailure({ problems }: AppState, about: string, error: unknown): void {
    tellUnlessCut(problems, about, error);
    // What was refused is as it was before; the next edit is about something else.
    const words = problems.all.value.get(about);
    if (words !== undefined) problems.sayUntil('edit', about, words);
    // The hint is for scripts, which can take the rake away from others.
    if (error instanceof CallError && error.failure.code === leased) {
        problems.sayUntil('edit', about, `${error.failure.message}: wait until it is released`);
    }
}
