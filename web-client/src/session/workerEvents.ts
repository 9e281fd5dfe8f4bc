// Where what the worker sends goes: a surface straight to its feed, the server's news and the connection to
// those who follow them.
import type { OwnServer } from '../connection/ownServer.ts';
import type { AppState } from '../state/appState.ts';
import type { WorkerEvent } from '../worker/workerClient.ts';
import type { ServerNews } from './serverNews.ts';
import type { SessionController } from './sessionController.ts';
import type { SurfaceFeed } from './surface/surfaceFeed.ts';

export interface Receivers {
    state: Pick<AppState, 'roundTripMs'>;
    feed: Pick<SurfaceFeed, 'receive' | 'troubled'>;
    news: Pick<ServerNews, 'take' | 'unreadable'>;
    controller: Pick<SessionController, 'connectionChanged'>;
    server: Pick<OwnServer, 'took'>;
    loginEnded: (login: string) => void;
}

export function handOut(event: WorkerEvent, { state, feed, news, controller, server, loginEnded }: Receivers): void {
    switch (event.type) {
        case 'surface':
            feed.receive(event);
            break;
        case 'frameTrouble':
            void feed.troubled(event.surface, event.subscription, event.reason);
            break;
        case 'notification':
            news.take(event.notification);
            break;
        case 'unreadable':
            news.unreadable(event.faults);
            break;
        case 'roundTrip':
            state.roundTripMs.value = event.ms;
            break;
        case 'loggedIn':
            server.took({ login: event.login, session: event.session });
            break;
        case 'loginEnded':
            loginEnded(event.login);
            break;
        case 'connection': {
            const { type: _, ...connection } = event;
            controller.connectionChanged(connection);
            break;
        }
    }
}
