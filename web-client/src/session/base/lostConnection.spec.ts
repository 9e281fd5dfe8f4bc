import { expect, test } from 'vitest';
import { Announcements } from '../../state/announcements.ts';
import { CallError } from '../../worker/workerClient.ts';
import { tellUnlessCut } from './lostConnection.ts';

test('a call that ends with the connection is not told of, one whose answer the page cannot read is', () => {
    const problems = new Announcements();
    const failure = { code: 0, message: 'This page cannot read what the server sent.', hint: '' };
    tellUnlessCut(problems, 'rake', new CallError({ ...failure, kind: 'disconnected' }));
    expect([...problems.all.value]).toEqual([]);
    tellUnlessCut(problems, 'rake', new CallError({ ...failure, kind: 'unreadable' }));
    expect([...problems.all.value]).toEqual([['rake', failure.message]]);
});
