// Calls that end with the connection: the connection's own banner says so, and what it said goes with the
// next connection.
import type { Announcements } from '../../state/announcements.ts';
import { CallError } from '../../worker/workerClient.ts';

export function isDisconnected(error: unknown): boolean {
    return error instanceof CallError && error.failure.kind === 'disconnected';
}

/** @param about as Announcements has it */
export function tellUnlessCut(problems: Announcements, about: string, error: unknown): void {
    if (!isDisconnected(error)) problems.tell(about, error);
}
