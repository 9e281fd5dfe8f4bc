// What a page and its server have of each other before anything is drawn: where it is, who is let in, and a worker that connects.
import { OwnServer } from '../connection/ownServer.ts';
import { WorkerClient } from '../worker/workerClient.ts';
import { baseUrl, type UrlState } from './view/urlState.ts';

export interface Connected {
    url: UrlState;
    server: OwnServer;
    worker: WorkerClient;
}

/** Returns at once; the worker connects, and stays connected until it is stopped. */
export function connect(url: UrlState): Connected {
    const server = new OwnServer(baseUrl(), url.session);
    const shown = { token: url.token, login: server.login };
    const worker = new WorkerClient(server.base, shown, (login) => server.loggedIn(login));
    return { url, server, worker };
}
