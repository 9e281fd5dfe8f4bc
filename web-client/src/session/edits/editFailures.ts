// What becomes of an edit that the server does not take: words for the user, and whether it must be taken back on this page.
import { errorCodes } from '../../protocol/generated/errors.ts';
import type { AppState } from '../../state/appState.ts';
import { CallError } from '../../worker/workerClient.ts';
import { tellUnlessCut } from '../base/lostConnection.ts';

const { leased, notPermitted } = errorCodes;

/** @param about what was edited. True: it is not for this user to change that, now or ever. */
export function tellFailure({ problems }: AppState, about: string, error: unknown): boolean {
    tellUnlessCut(problems, about, error);
    if (!(error instanceof CallError)) return false;
    const { code, message } = error.failure;
    // The hint is for scripts, which can take the rake away from others.
    if (code === leased) problems.say(about, `${message}: wait until it is released`);
    return code === notPermitted || code === leased;
}
