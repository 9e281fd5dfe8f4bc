// Checks of what the server answers, by method: as described, but for what an answer to this page always has.
import type { Check } from './checks.ts';
import { resultChecks as described } from './generated/results.ts';
import { isObject } from './jsonRpc.ts';
import type { JoinedSession, MethodName, ResultOf } from './messages.ts';

const joinedSession: Check<JoinedSession> = (value) => {
    const fault = described['session.join'](value);
    return fault === null && isObject(value) && value['snapshot'] === undefined ? '.snapshot is missing' : fault;
};

export const resultChecks: { [Name in MethodName]: Check<ResultOf<Name>> } = { ...described, 'session.join': joinedSession };
