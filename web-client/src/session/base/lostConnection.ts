// Calls that end with the connection: the connection's own banner says so, and what it said goes with the next connection.
import type { Problems } from '../../state/problems.ts';
import { CallError } from '../../worker/workerClient.ts';

export function isDisconnected(error: unknown): boolean {
    return error instanceof CallError && error.failure.kind === 'disconnected';
}

/** @param about as Problems has it */
export function tellUnlessCut(problems: Problems, about: string, error: unknown): void {
    if (!isDisconnected(error)) problems.tell(about, error);
}
