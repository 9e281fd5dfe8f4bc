// The worker: owns the WebSocket, Draco and the folding of meshes, so that neither a large mesh nor
// a slow frame on the page delays the other. Hands on complete states in transferred arrays.
import { authorise, type Credentials, EndedLogin, openWebSocket } from '../connection/authorise.ts';
import { systemClock } from '../connection/clock.ts';
import { type ConnectionState, LiveSocket } from '../connection/liveSocket.ts';
import { RpcClient } from '../connection/rpcClient.ts';
import type { DracoPoints } from '../protocol/dracoPoints.ts';
import { encodeNotification, parseIncoming, RpcError } from '../protocol/jsonRpc.ts';
import { type MethodName, type ParamsOf, readNotification, type ResultOf, UnreadableAnswer } from '../protocol/messages.ts';
import { keepDracoSmall, loadDraco } from './draco.ts';
import { SurfaceFolder } from './surfaceFolder.ts';
import type { CallFailure, FromWorker, MessageOf, SurfaceState, ToWorker } from './workerMessages.ts';

interface WorkerPort {
    postMessage(message: MessageOf<FromWorker>, transfer?: Transferable[]): void;
    onmessage: ((event: { data: MessageOf<ToWorker> }) => void) | null;
}

/** A login lasts for a week after that. */
const renewEveryMs = 12 * 3600 * 1000;

class SessionWorker {
    private readonly port: WorkerPort;
    private readonly baseUrl: string;
    private readonly shown: Credentials;
    private renewedAt = 0;
    private refused = false;
    private readonly draco: DracoPoints;
    private readonly rpc = new RpcClient((text) => this.socket.send(text));
    private readonly folder: SurfaceFolder;
    private readonly socket: LiveSocket;
    /** Cancels the calls that are open, by their id. */
    private readonly cancels = new Map<number, AbortController>();

    constructor(port: WorkerPort, draco: DracoPoints, baseUrl: string, shown: Credentials) {
        this.port = port;
        this.draco = draco;
        this.baseUrl = baseUrl;
        this.shown = shown;
        this.folder = new SurfaceFolder({
            draco,
            onState: (state) => this.sendState(state),
            onApplied: (subscription, { epoch, seq }) =>
                this.socket.send(encodeNotification('frame.ack', { subscription, epoch, seq })),
            onTrouble: (surface, subscription, reason) =>
                port.postMessage({ type: 'frameTrouble', surface, subscription, reason }),
        });
        this.socket = new LiveSocket({
            clock: systemClock,
            connect: async () => {
                // Each time: a server without a state folder does not know its predecessor's logins.
                await this.logIn();
                return openWebSocket(baseUrl, this.shown.login);
            },
            onState: (state) => this.connectionChanged(state),
            onMessage: (data) => this.receive(data),
            ping: () => void this.ping(),
        });
        this.socket.start();
    }

    handle(message: MessageOf<ToWorker>): void {
        if (message.type === 'call') {
            this.answer(message.id, this.call(message.id, message.method as MethodName, message.params));
        } else if (message.type === 'cancel') {
            this.cancels.get(message.id)?.abort();
        } else if (message.type === 'obstacle' || message.type === 'bodyValues') {
            const from = { baseUrl: this.baseUrl, login: this.shown.login };
            const read = import('./obstacle.ts');
            this.answer(
                message.id,
                message.type === 'obstacle'
                    ? read.then(({ fetchObstacle }) => fetchObstacle(from, message, this.draco))
                    : read.then(({ fetchBodyValues }) => fetchBodyValues(from, message, this.draco)),
            );
        } else if (message.type === 'notify') {
            this.socket.send(encodeNotification(message.method, message.params));
        } else if (message.type === 'taken') this.folder.taken(message.surface);
        else if (message.type === 'show') this.folder.show(message.surface, message);
        else if (message.type === 'forget') this.folder.forget(message.surface);
        else if (message.type === 'retryNow') this.socket.retryNow();
        else if (message.type === 'logIn') {
            if (message.token !== undefined) this.shown.token = message.token;
            else if (this.refused) Object.assign(this.shown, { token: null, login: message.login });
            if (this.refused) this.socket.start();
        }
    }

    private async logIn(): Promise<void> {
        const { login } = this.shown;
        const made = await authorise(this.baseUrl, this.shown).catch((error: unknown) => {
            if (error instanceof EndedLogin && login !== null) this.port.postMessage({ type: 'loginEnded', login });
            throw error;
        });
        this.renewedAt = Date.now();
        if (made === null) return;
        this.shown.login = made.login;
        this.port.postMessage({ type: 'loggedIn', ...made });
    }

    private async ping(): Promise<void> {
        const start = performance.now();
        await this.rpc.call('server.ping', {}).then(
            () => this.port.postMessage({ type: 'roundTrip', ms: performance.now() - start }),
            () => undefined,
        );
        if (Date.now() - this.renewedAt >= renewEveryMs) await this.logIn().catch(() => undefined);
    }

    private async call(id: number, method: MethodName, params: object): Promise<unknown> {
        if (method === 'surface.subscribe') {
            return this.subscribe(params as ParamsOf<'surface.subscribe'>);
        }
        const cancel = new AbortController();
        this.cancels.set(id, cancel);
        const answered = this.rpc.call(method, params, cancel.signal);
        const result = await answered.finally(() => this.cancels.delete(id));
        if (method === 'session.join') {
            const { resumeToken } = params as ParamsOf<'session.join'>;
            this.joined(resumeToken, (result as ResultOf<'session.join'>).resumeToken);
        }
        return result;
    }

    /** Goes on from the state that is here, if the server can; else, or where it will not hear of that, with
     *  a whole one. */
    private async subscribe({ surface }: ParamsOf<'surface.subscribe'>): Promise<ResultOf<'surface.subscribe'>> {
        const from = this.folder.placeOf(surface);
        const whole = (): Promise<ResultOf<'surface.subscribe'>> => this.rpc.call('surface.subscribe', { surface });
        const agreed =
            from === undefined ? await whole() : await this.rpc.call('surface.subscribe', { surface, from }).catch(whole);
        // Before anything else is heard: the first frames follow the answer at once.
        this.folder.subscribed(surface, agreed);
        return agreed;
    }

    /**
     * A server that knows us gives our token back. Any other, as after a restart, may call its session, its
     * surfaces and their epochs as before, and mean others.
     */
    private joined(sent: string | undefined, received: string): void {
        if (sent === undefined || sent !== received) this.folder.forgetAll();
    }

    private answer(id: number, outcome: Promise<unknown>): void {
        outcome.then(
            (result) => this.port.postMessage({ type: 'reply', id, result }),
            (error: unknown) => this.port.postMessage({ type: 'failure', id, failure: failureOf(error) }),
        );
    }

    private connectionChanged(state: ConnectionState): void {
        this.refused = state.state === 'refused';
        if (state.state === 'waiting' || state.state === 'ended') {
            this.folder.disconnected();
            this.rpc.disconnected();
        }
        this.port.postMessage({ type: 'connection', ...state });
    }

    private receive(data: unknown): void {
        if (data instanceof ArrayBuffer) {
            this.folder.receive(new Uint8Array(data));
            keepDracoSmall(this.draco);
        } else if (typeof data === 'string') this.receiveText(data);
    }

    private receiveText(text: string): void {
        const incoming = parseIncoming(text);
        if (incoming === null) return;
        if (incoming.type === 'notification') {
            const { notification, faults } = readNotification(incoming.method, incoming.params);
            if (notification?.method === 'session.patched') {
                for (const patch of notification.patches) {
                    if (patch.op === 'put' && patch.type === 'surface') this.folder.recorded(patch.record);
                }
            }
            if (notification !== null) this.port.postMessage({ type: 'notification', notification });
            if (faults.length > 0) this.port.postMessage({ type: 'unreadable', faults });
            return;
        }
        this.rpc.receive(incoming);
    }

    private sendState(state: SurfaceState): void {
        const { positions, normals, seeds, scalars, indices, cut, units, unresolved } = state;
        const arrays: ArrayBufferView[] = [positions, normals, seeds, indices, ...scalars.map(({ values }) => values)];
        if (cut !== null) arrays.push(cut.levels);
        for (const each of [units, unresolved]) if (each !== null) arrays.push(each);
        const transfer = arrays.map(({ buffer }) => buffer as ArrayBuffer);
        this.port.postMessage({ type: 'surface', ...state }, transfer);
    }
}

function failureOf(error: unknown): CallFailure {
    if (error instanceof RpcError) {
        return { kind: 'rpc', code: error.code, message: error.message, hint: error.hint };
    }
    const message = error instanceof Error ? error.message : String(error);
    return { kind: error instanceof UnreadableAnswer ? 'unreadable' : 'disconnected', code: 0, message, hint: '' };
}

const port = self as unknown as WorkerPort;
let worker: Promise<SessionWorker> | null = null;

port.onmessage = ({ data }) => {
    if (data.type === 'areYouThere') {
        port.postMessage({ type: 'here' });
        return;
    }
    if (data.type === 'start') {
        const { baseUrl, token, login } = data;
        worker = loadDraco().then((draco) => new SessionWorker(port, draco, baseUrl, { token, login }));
        worker.catch((error: unknown) => {
            const reason = error instanceof Error ? error.message : String(error);
            port.postMessage({ type: 'connection', state: 'broken', reason });
        });
        return;
    }
    void worker?.then((running) => running.handle(data));
};
